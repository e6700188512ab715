using NUnit.Framework;
using Rill.Tests;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Editor.Tests
{
    /// <summary>Asset that the inspector's button writes.</summary>
    public class SnapshotAssetTests
    {
        [Test]
        public void A_state_is_saved_into_a_new_asset_and_then_into_the_one_that_the_fluid_starts_with()
        {
            using (SourceScene scene = new SourceScene(Vector3.one, 0.05f, 1000).Fill(0.1f).Step(3))
            {
                scene.Fluid.name = "Snapshot Asset Test";
                string path = SnapshotAssets.Save(scene.Fluid, Take(scene));
                try
                {
                    Assert.That(path, Is.EqualTo("Assets/Snapshot Asset Test Start State.asset"));
                    var asset = AssetDatabase.LoadAssetAtPath<FluidSnapshotAsset>(path);
                    Assert.That(asset.Snapshot.StepCount, Is.EqualTo(3));
                    scene.Fluid.StartState = asset;
                    Assert.That(SnapshotAssets.Save(scene.Fluid, Take(scene.Step(2))), Is.EqualTo(path));
                    Assert.That(asset.Snapshot.StepCount, Is.EqualTo(5), "in place, so that references stay");
                }
                finally
                {
                    AssetDatabase.DeleteAsset(path);
                }
            }
        }

        static FluidSnapshot Take(SourceScene scene)
        {
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            return request.Snapshot;
        }
    }
}
