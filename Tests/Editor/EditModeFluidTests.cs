using System.Linq;
using NUnit.Framework;
using Rill.Tests;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Editor.Tests
{
    /// <summary>Fluids of a scene that does not play.</summary>
    [Category("EditMode")]
    public class EditModeFluidTests
    {
        const string AssetPath = "Assets/Edit Mode Fluid Start State.asset";

        FluidSimulation fluid;
        FluidVolume volume;

        [SetUp]
        public void MakeFluid()
        {
            fluid = new GameObject("Fluid").AddComponent<FluidSimulation>();
            fluid.Configure(Vector3.one, 0.1f, 1000);
            volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(fluid.transform, false);
            volume.Size = new Vector3(0.5f, 0.4f, 1f);
        }

        [TearDown]
        public void DestroyFluid()
        {
            SceneSimulation.Stop();
            VolumePreview.Clear();
            Object.DestroyImmediate(fluid.gameObject);
            AssetDatabase.DeleteAsset(AssetPath);
            Undo.ClearAll();
        }

        [Test]
        public void Nothing_plays_and_a_fluid_does_not_run_by_itself()
        {
            Assert.That(Application.isPlaying, Is.False);
            Assert.That(fluid.IsRunning, Is.False);
        }

        [Test]
        public void A_fluid_steps_while_it_is_simulated_and_is_as_it_was_afterwards()
        {
            string before = JsonUtility.ToJson(fluid);
            SceneSimulation.Start(fluid);
            Assert.That(SceneSimulation.Problem, Is.Null);
            Assert.That(SceneSimulation.Runs(fluid) && fluid.IsRunning);
            GraphicsBuffer positions = fluid.Solver.Positions;
            for (int i = 0; i < 3; i++)
                fluid.Advance(fluid.FixedStep);
            Assert.That(fluid.StepCount, Is.EqualTo(3));
            ParticleState water = TestFluid.Read(fluid.Solver);
            Assert.That(water.Count, Is.EqualTo(5 * 4 * 10));
            Assert.That(water.velocities.Average(v => v.y), Is.LessThan(-1f), "it falls, spacings/s");

            SceneSimulation.Stop();
            Assert.That(positions.IsValid(), Is.False);
            Assert.That(fluid.IsRunning || fluid.HasKeptState || fluid.runInEditMode, Is.False);
            Assert.That(fluid.enabled);
            Assert.That(JsonUtility.ToJson(fluid), Is.EqualTo(before));
        }

        [Test]
        public void The_particles_that_a_volume_shows_are_those_that_the_fluid_begins_with()
        {
            fluid.transform.SetPositionAndRotation(new Vector3(2f, 0f, 1f), Quaternion.Euler(0f, 30f, 0f));
            Vector3[] corners = VolumePreview.MeshOf(volume, fluid).vertices;
            SceneSimulation.Start(fluid);
            ParticleState water = TestFluid.Read(fluid.Solver);
            Assert.That(corners.Length, Is.EqualTo(ParticleMesh.Corners * water.Count));
            for (int i = 0; i < water.Count; i++)
            {
                float3 center = 0.5f * (corners[i * ParticleMesh.Corners] + corners[i * ParticleMesh.Corners + 1]);
                Assert.That(math.distance(center, water.positions[i].xyz), Is.LessThan(1e-4f), "spacings");
            }
        }

        [Test]
        public void A_state_that_is_saved_is_what_the_fluid_starts_with_until_that_is_undone()
        {
            SceneSimulation.Start(fluid);
            for (int i = 0; i < 3; i++)
                fluid.Advance(fluid.FixedStep);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            SnapshotAssets.SaveAsStart(fluid, request.Snapshot, AssetPath);
            Assert.That(AssetDatabase.GetAssetPath(fluid.StartState), Is.EqualTo(AssetPath));
            ParticleState saved = TestFluid.Read(fluid.Solver);
            SceneSimulation.Current.Restart();
            TestFluid.AssertSame(TestFluid.Read(fluid.Solver), saved);
            SceneSimulation.Stop();
            Undo.PerformUndo();
            Assert.That(fluid.StartState, Is.Null);
        }

        [Test]
        public void A_disabled_fluid_is_not_simulated_and_the_reason_is_given()
        {
            fluid.enabled = false;
            SceneSimulation.Start(fluid);
            Assert.That(SceneSimulation.Current, Is.Null);
            Assert.That(SceneSimulation.Problem, Is.EqualTo("'Fluid' is disabled. Enable the component and its object."));
        }
    }
}
