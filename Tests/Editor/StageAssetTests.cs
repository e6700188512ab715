using System;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor.Tests
{
    /// <summary>Results of importing the package, seen without playing.</summary>
    public class StageAssetTests
    {
        [TestCase("Clear", "ClearWords", "ClearBlocks", "ClearTriples")]
        [TestCase("CoarseGrid", "BinFlow", "FindDivergence", "DisplaceFlow", "FindErrors", "DisplaceErrors")]
        [TestCase("CoarseSolver", "Smooth", "CorrectAndSmooth", "RestrictGrid", "SmoothLevel", "CorrectAndSmoothLevel", "RestrictLevel",
            "SolveCoarseLevels")]
        [TestCase("DensityConstraint", "BuildList", "BuildListDeep", "SolveLambda", "ApplyDeltaP", "ApplyDeltaPWithPressure",
            "ApplyDeltaPDeep", "ApplyDeltaPDeepWithPressure", "ApplyDeltaPWithTension", "ApplyDeltaPDeepWithTension")]
        [TestCase("Contacts", "FindContacts", "ResolveContacts")]
        [TestCase("ParticleUpload", "Append", "CommitAppend", "Clear")]
        [TestCase("Foam", "AverageCells", "Move", "Compact", "Spawn", "Commit")]
        [TestCase("FoamSources", "FindPotentials", "CountSpawned")]
        [TestCase("ImplicitViscosity", "ApplyProjection", "FindCoefficients", "FindResidual", "FirstPass", "NextPass")]
        [TestCase("GrainFriction", "Anticipate", "AddGrains", "AddGrainsBefore", "FindNodes", "FindSolids", "FindCells", "FindCellsBefore",
            "MoveNodes", "MoveNodesWithColliders", "StressCells", "MoveGrains", "MoveGrainsBefore")]
        [TestCase("MeshSdf", "Clear", "Gather", "SplatDistances", "SplatNearest", "SplatLargeDistances", "SplatLargeNearest", "Flood",
            "BuildLeaves", "BuildParents", "FindSides", "ResolveSolid", "ResolveShell")]
        [TestCase("NeighborSearch", "CountCells", "CountCellsDeep", "CountCellsWithColliders", "CountCellsDeepWithColliders",
            "CountCellsAtRest", "ScatterOrder", "Gather", "GatherWithColliders", "GatherTags", "GatherPreviousIndices")]
        [TestCase("PrefixSum", "SumTiles", "ScanTileSums", "ScanTiles", "ScanFewTiles")]
        [TestCase("Recording", "PackFrame", "UnpackFrame")]
        [TestCase("RestingRegions", "MeasureMotion", "CountQuiet", "Spread")]
        [TestCase("Statistics", "Measure", "Reduce")]
        [TestCase("VelocityUpdate", "UpdateVelocity", "UpdateVelocityViscous")]
        [TestCase("Viscoelasticity", "Deform", "ApplyStress")]
        [TestCase("VorticityConfinement", "Curl", "Confine")]
        public void Every_kernel_of_a_stage_is_imported_and_runs_on_this_device(string stage, params string[] kernels)
        {
            ComputeShader shader = StageShader.LoadCompute(stage);
            foreach (string kernel in kernels)
            {
                Assert.That(shader.HasKernel(kernel), $"{stage}.compute has no kernel {kernel}");
                string runs = DeviceLimits.Current.Holds(stage, kernel) ? kernel : StandInFor(shader, kernel);
                Assert.That(shader.IsSupported(shader.FindKernel(runs)), $"{stage}.compute: {runs} is not supported");
            }
        }

        // Returns what runs instead of a kernel that this device is too small for.
        static string StandInFor(ComputeShader shader, string kernel)
        {
            string standIn = shader.HasKernel(kernel + KernelNeed.Small) ? kernel + KernelNeed.Small : kernel + KernelNeed.Narrow;
            Assert.That(shader.HasKernel(standIn), $"{shader.name} has no kernel for this device instead of {kernel}");
            return standIn;
        }

        [Test]
        public void A_setting_that_is_changed_in_the_editor_changes_the_stages_that_are_stored()
        {
            using (var scene = new EditorScene())
            {
                var fluid = scene.Add<FluidSimulation>();
                Change(fluid, "statisticsInterval", property => property.intValue = 0);
                Assert.That(Stored(fluid), Has.Member("ParticleUpload").And.Member("CoarseGrid").And.No.Member("Statistics").And.No.Member(
                    "VorticityConfinement"));
                Change(fluid, "material.vorticity", property => property.floatValue = 1f);
                Assert.That(Stored(fluid), Has.Member("VorticityConfinement"));
                Change(fluid, "shadersInBuild", property => property.intValue = (int)ShadersInBuild.AllFeatures);
                Assert.That(Stored(fluid), Has.Member("Colliders").And.Member("ParticleRenderer").And.No.Member("MeshSdf"));
                Change(fluid, "shadersInBuild", property => property.intValue = (int)ShadersInBuild.UsedBySettings);
                Change(fluid, "material.vorticity", property => property.floatValue = 0f);
                Assert.That(Stored(fluid), Has.No.Member("VorticityConfinement").And.No.Member("Colliders"));
            }
        }

        static void Change(Object target, string path, Action<SerializedProperty> set)
        {
            var serialized = new SerializedObject(target);
            set(serialized.FindProperty(path));
            serialized.ApplyModifiedProperties();
            SettingsQueue.Apply();
        }

        static string[] Stored(IUsesFeatures user) => Array.ConvertAll(user.StageReferences.Stages, stage => stage.name);

        [TestCase("ParticleRenderer")]
        [TestCase("DomainRenderer")]
        [TestCase("Foam")]
        public void Every_renderer_has_a_shader_that_runs_on_this_device(string stage)
        {
            Shader shader = StageShader.Load(stage).Shader;
            Assert.That(shader != null);
            Assert.That(shader.isSupported);
        }
    }
}
