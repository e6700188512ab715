using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>That a scene runs what it needs and nothing else, by what the device was given and what memory is alive.</summary>
    public class LeftOutTests : GraphicsFixture
    {
        const float FrameTime = 1f / 60f, Spacing = 0.1f;
        const int Iterations = 4;

        // Kernels, variants and buffers that still shallow water has no use for, as they appear in names.
        static readonly string[] NotForAShallowPool = { "Coarse", "Deep", "GrainFriction", "Rill.Friction",
            "ImplicitViscosity", "Rill.Viscous", "Rill.NextViscous",
            "Contact", "Viscoelasticity", "GatherPreviousIndices", "Rill.Conformation", "Rill.DeformedConformation", "Rill.Stress",
            "Rill.PreviousIndices", "Vorticity", "Rill.Curl", "Rill.Unconfined", "Regions", RestingRegions.Keyword, "WithPressure", "WithTension",
            "Emitters", "Drain", "ForceFields", "Rill.Fields", "Borders", "Tags", "ParticleAccess", "Recording", "Rill.RecordedFrame",
            "Rill.PlayedFrame", NeighborLists.TwoListsKeyword, "Rill.MoreNeighbors", "Collider", "WithColliders", "WithColliders", "Foam", "Smoke",
            "Queries", "QueryBatch", "ParticleTransfer", "Rill.Transfer", "Rill.Kept" };

        // Work that each feature adds to (+) and takes from (-) a frame of a shallow pool. A name that ends in * stands for all that begin so,
        // at least one.
        static readonly (string Name, Action<FluidSimulation> Before, Action<FluidSimulation> Change, string[] Expected)[] Features =
        {
            ("nothing", null, s => { }, new string[0]),
            ("deep water", null, Settings((ref SolverSettings v) => v.deepWater = DeepWater.On), new[]
            {
                "+1 CoarseGrid.compute BinFlow", "+1 CoarseGrid.compute FindSurface", "+1 CoarseGrid.compute FindDivergence",
                    "+1 CoarseGrid.compute DisplaceFlow", "+1 CoarseGrid.compute FindErrors",
                "+1 CoarseGrid.compute DisplaceErrors", "+2 CoarseGrid.compute ExtendDisplacements", "+2 CoarseSolver.compute *", "+1 Rill.Coarse.*",
                "-1 NeighborSearch.compute CountCells", "+1 NeighborSearch.compute CountCellsDeep",
                "-1 DensityConstraint.compute BuildList", "+1 DensityConstraint.compute BuildListDeep",
                "-1 DensityConstraint.compute ApplyDeltaP", "+1 DensityConstraint.compute ApplyDeltaPDeep",
                "-1 VelocityUpdate.compute UpdateVelocityViscous", "+1 VelocityUpdate.compute UpdateVelocityDeep",
            }),
            ("vorticity", null, Material((ref FluidMaterial v) => v.vorticity = 1f), new[]
            {
                "+1 VorticityConfinement.compute Curl", "+1 VorticityConfinement.compute Confine", "+1 Rill.Curl *", "+1 Rill.Unconfined *",
                "-1 VelocityUpdate.compute UpdateVelocityViscous", "+1 VelocityUpdate.compute UpdateVelocity",      // XSPH moves into Confine
            }),
            ("dynamic viscosity", null, Material((ref FluidMaterial v) => v.dynamicViscosity = 10f), new[]
            {
                "+1 ImplicitViscosity.compute FindCoefficients", "+1 ImplicitViscosity.compute FindResidual",
                    "+1 ImplicitViscosity.compute FirstPass", "+2 ImplicitViscosity.compute NextPass",
                "+1 Rill.ViscousVelocities *", "+1 Rill.NextViscousVelocities *", "+1 Rill.ViscousChanges *", "+1 Rill.ViscousHolds *",
            }),
            ("friction of grains", Settings((ref SolverSettings v) => v.deepWater = DeepWater.On),
                Material((ref FluidMaterial v) => v.frictionAngle = 30f), new[]
            {
                "+1 GrainFriction.compute Anticipate", "+1 GrainFriction.compute AddGrainsBefore", "+1 GrainFriction.compute AddGrains",
                "+2 GrainFriction.compute FindNodes", "+1 GrainFriction.compute FindCellsBefore", "+1 GrainFriction.compute FindCells",
                "+18 GrainFriction.compute MoveNodes", "+16 GrainFriction.compute StressCells", "+1 GrainFriction.compute MoveGrainsBefore",
                "+1 GrainFriction.compute MoveGrains", "+1 Rill.Friction.*",
                "-1 NeighborSearch.compute CountCellsDeep", "+1 NeighborSearch.compute CountCells",
            }),
            ("contacts", null, Material((ref FluidMaterial v) => v.contacts = true), new[]
            {
                $"+{Iterations} Contacts.compute FindContacts", $"+{Iterations} Contacts.compute ResolveContacts", "+1 Rill.ContactCounts *",
                $"-{Iterations} DensityConstraint.compute ApplyDeltaP", $"-{Iterations - 1} DensityConstraint.compute SolveLambda",
            }),
            ("elasticity", null, Material((ref FluidMaterial v) => v.shearModulus = 100f), new[]
            {
                "+1 NeighborSearch.compute GatherPreviousIndices", "+1 Viscoelasticity.compute Deform", "+1 Viscoelasticity.compute ApplyStress",
                "+1 Rill.Conformation *", "+1 Rill.DeformedConformation *", "+1 Rill.Stress *", "+1 Rill.PreviousIndices *",
            }),
            ("viscosity off", null, Inviscid,
                new[] { "-1 VelocityUpdate.compute UpdateVelocityViscous", "+1 VelocityUpdate.compute UpdateVelocity" }),
            ("artificial pressure", null, Material((ref FluidMaterial v) => v.artificialPressure = 0.1f), new[]
            {
                $"-{Iterations} DensityConstraint.compute ApplyDeltaP", $"+{Iterations} DensityConstraint.compute ApplyDeltaPWithPressure",
            }),
            ("surface tension", null, Material((ref FluidMaterial v) => v.surfaceTension = 1f), new[]
            {
                $"-{Iterations} DensityConstraint.compute ApplyDeltaP", $"+{Iterations} DensityConstraint.compute ApplyDeltaPWithTension",
            }),
            ("surface tension beside a collider", s => AddCollider(s, false), Material((ref FluidMaterial v) => v.surfaceTension = 1f),
                Instead(Iterations, "DensityConstraint.compute ApplyDeltaP", "WithTension")
                .Concat(Instead(Iterations - 1, "Colliders.compute Collide", "WithTension"))
                .Concat(Instead(1, "Colliders.compute CollideLast", "WithTension")).ToArray()),
            ("surface tension of deep water", Settings((ref SolverSettings v) => v.deepWater = DeepWater.On),
                Material((ref FluidMaterial v) => v.surfaceTension = 1f),
                Instead(Iterations - 1, "DensityConstraint.compute ApplyDeltaP", "WithTension")
                .Concat(Instead(1, "DensityConstraint.compute ApplyDeltaPDeep", "WithTension")).ToArray()),
            ("a second material", null, s => s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Oil", 500f) },
                new[] { "+1 NeighborSearch.compute GatherTags", "+1 Rill.TagsA *", "+1 Rill.TagsB *", "+1 Rill.Slips *", "+1 Rill.Phases *",
                $"-{Iterations} DensityConstraint.compute ApplyDeltaP",
                $"+{Iterations} DensityConstraint.compute ApplyDeltaP {MaterialTable.Keyword}",
                $"-{Iterations - 1} DensityConstraint.compute SolveLambda",
                $"+{Iterations - 1} DensityConstraint.compute SolveLambda {MaterialTable.Keyword}" }
                .Concat(InVariant(MaterialTable.Keyword, "DensityConstraint.compute BuildList", "VelocityUpdate.compute UpdateVelocityViscous"))
                .ToArray()),
            ("materials that mix", null, s =>
            {
                s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Dye", 1000f) };
                s.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, s.PhaseMaterials[0], 0.001f) };
            }, new[]
            {
                "+1 NeighborSearch.compute GatherTags", "+1 Rill.TagsA *", "+1 Rill.TagsB *",
                "+1 Diffusion.compute Choose", "+1 Diffusion.compute Exchange", "+1 Rill.Diffusion.*",
            }),
            ("sleep", null, Settings((ref SolverSettings v) => v.sleepSpeed = 0.02f),
                new[] { "+1 RestingRegions.compute MeasureMotion", "+1 RestingRegions.compute CountQuiet",
                "+1 RestingRegions.compute Spread", "+1 Rill.Regions.*" }
                .Concat(InVariant(RestingRegions.Keyword, "NeighborSearch.compute CountCells", "NeighborSearch.compute ScatterOrder",
                    "NeighborSearch.compute Gather", "DensityConstraint.compute BuildList", "VelocityUpdate.compute UpdateVelocityViscous"))
                .Append($"-{Iterations} DensityConstraint.compute ApplyDeltaP")
                    .Append($"+{Iterations} DensityConstraint.compute ApplyDeltaP {RestingRegions.Keyword}")
                .Append($"-{Iterations - 1} DensityConstraint.compute SolveLambda")
                    .Append($"+{Iterations - 1} DensityConstraint.compute SolveLambda {RestingRegions.Keyword}").ToArray()),
            ("less damping", null, Settings((ref SolverSettings v) => v.numericalDamping = 0.5f), new[]
            {
                "+1 NeighborSearch.compute GatherMeans", "-1 VelocityUpdate.compute UpdateVelocityViscous",
                    "+1 VelocityUpdate.compute UpdateVelocityExtrapolated", "+1 Rill.Means *", "+1 Rill.SortedMeans *",
            }),
            ("statistics", null, s => s.StatisticsInterval = 1, new[]
            {
                "+1 Statistics.compute Measure", "+1 Statistics.compute Reduce", "+1 Rill.Statistics.*",
                "+1 NeighborSearch.compute CountCellsAtRest", "+1 NeighborSearch.compute ScatterOrder", "+1 PrefixSum.compute *",
                "+1 Rill.CellStartsAtRest *",
            }),
            ("a collider", null, s => AddCollider(s, false), WithCollider("")),
            ("a mesh that deforms far away", null, s => AddDeforming(1000f * Vector3.right), new string[0]),
            ("a collider beside an emitter", Part<FluidEmitter>(Still), s => AddCollider(s, false),
                WithCollider("").Concat(new[] { "FindRoom", "Feel", "Press" }.SelectMany(kernel => new[]
                    { $"-1 Emitters.compute {kernel}", $"+1 Emitters.compute {kernel}WithColliders" })).ToArray()),
            ("a collider whose force is measured", null, s => AddCollider(s, true),
                WithCollider("React").Append("+1 Colliders.compute TakeReactions").ToArray()),
            ("motion of a collider", s => AddCollider(s, false), s => ((FluidCollider)SceneColliders.Enabled[0]).gameObject.AddComponent<Mover>(),
                new[] { "+1 Colliders.compute BinColliders", "+1 Colliders.compute MeasureColliderVolume" }),
            ("motion of a collider in deep water",
                s => { AddCollider(s, false); Settings((ref SolverSettings v) => v.deepWater = DeepWater.On)(s); }, s
                => ((FluidCollider)SceneColliders.Enabled[0]).gameObject.AddComponent<Mover>(), new[]
            {
                "+1 Colliders.compute BinColliders", "+1 Colliders.compute MeasureColliderVolume", "+1 CoarseColliders.compute OpenCells",
                    "+1 CoarseColliders.compute LinkCells",
            }),
            ("a collider in deep water", Settings((ref SolverSettings v) => v.deepWater = DeepWater.On), s => AddCollider(s, false), new[]
            {
                "+1 Rill.Colliders.*", "+1 Colliders.compute CollidePaths",
                $"+{Iterations - 1} Colliders.compute Collide", "+1 Colliders.compute CollideLast",
                "+1 Rill.Coarse.RawOpenFractions *", "+1 Rill.Coarse.OpenFractions *", "+1 Rill.Coarse.OpenCenters *",
                    "+1 Rill.Coarse.ColliderFlow *",
                "-1 NeighborSearch.compute CountCellsDeep", "+1 NeighborSearch.compute CountCellsDeepWithColliders",
                    "-1 NeighborSearch.compute Gather", "+1 NeighborSearch.compute GatherWithColliders",
                "-1 DensityConstraint.compute BuildListDeep", "+1 DensityConstraint.compute BuildListDeepWithColliders",
            }
                .Concat(Instead(Iterations - 1, "DensityConstraint.compute SolveLambda", "WithColliders"))
                    .Concat(Instead(1, "VelocityUpdate.compute UpdateVelocityDeep", "WithColliders"))
                .Concat(new[] { "BinFlow", "FindSurface", "FindDivergence", "DisplaceFlow", "FindErrors",
                    "DisplaceErrors" }.SelectMany(kernel => Instead(1, "CoarseGrid.compute " + kernel, "WithColliders")))
                .Concat(new[] { "Smooth", "RestrictGrid",
                    "CorrectAndSmooth" }.SelectMany(kernel => Instead(2, "CoarseSolver.compute " + kernel, "WithColliders"))).ToArray()),
            ("density colors", null, ColorByDensity, new string[0]),        // the pass for the viscosity has the density
            ("density colors without viscosity", Inviscid, ColorByDensity,
            new[] { "-1 VelocityUpdate.compute UpdateVelocity", "+1 VelocityUpdate.compute UpdateVelocityViscous" }),
            ("an emitter", null, Part<FluidEmitter>(Still),
                new[] { "+1 Emitters.compute Feel", "+1 Emitters.compute Press", "+1 Emitters.compute FindRoom", "+1 Emitters.compute Emit",
                "+1 Rill.Emitters.States *", "+1 Rill.Emitters.Free *",
                "+1 Rill.Emitters.Constants *", "+1 Rill.Emitters.Positions *" }),
            ("a second emitter", Part<FluidEmitter>(Still), Part<FluidEmitter>(Still),
                new[] { "+1 Emitters.compute Feel", "+1 Emitters.compute Press", "+1 Emitters.compute FindRoom", "+1 Emitters.compute Emit",
                    "+1 Rill.Emitters.Positions *" }),
            ("an emitter with a phase", null, Part<FluidEmitter>(e => { Still(e); e.Phase = 1; }), new[]
            {
                $"+1 Emitters.compute Feel {ParticleTags.Keyword}", $"+1 Emitters.compute Press {ParticleTags.Keyword}",
                $"+1 Emitters.compute FindRoom {ParticleTags.Keyword}", $"+1 Emitters.compute Emit {ParticleTags.Keyword}",
                    "+1 Rill.Emitters.*", "+1 NeighborSearch.compute GatherTags", "+1 Rill.TagsA *", "+1 Rill.TagsB *",
            }),
            ("colors of phases", Part<FluidEmitter>(e => { Still(e); e.Phase = 1; }),
                s => s.GetComponent<ParticleRenderer>().ColorBy = ParticleRenderer.Quantity.Phase, new string[0]),
            ("colors of phases without any", null, s => s.GetComponent<ParticleRenderer>().ColorBy = ParticleRenderer.Quantity.Phase, new string[0]),
            ("a lifetime", Part<FluidEmitter>(e => { Still(e); e.Phase = 1; }), s => s.GetComponentInChildren<FluidEmitter>().Lifetime = 1f,
                new[] { "+1 Drains.compute Drain RILL_LIFETIMES", "+1 Rill.Drains.Regions *", "+1 Rill.Drains.States *" }),
            ("a drain", null, Part<FluidDrain>(Aside), new[] { "+1 Drains.compute Drain", "+1 Rill.Drains.Regions *", "+1 Rill.Drains.States *" }),
            ("a second drain", Part<FluidDrain>(Aside), Part<FluidDrain>(Aside), new string[0]),
            ("a drain with a limit", Part<FluidDrain>(Aside), Part<FluidDrain>(d => { Aside(d); d.RateLimit = 1f; }),
                new[] { "+1 Drains.compute CountRandomRanks", "+1 Drains.compute SelectRandom", "+1 Rill.Drains.Histogram *" }),
            // stronger ones lean gravity, and may make water deep
            ("a force field without bounds", null, Part<FluidForceField>(f => f.Strength = 0.01f), new string[0]),
            ("a force field", null, Part<FluidForceField>(f => f.Bounds = ForceFieldBounds.Sphere),
                new[] { "+1 ForceFields.compute Accelerate", "+1 Rill.Fields *" }),
            ("an absorbing border", null, s => s.Borders = Border(BorderKind.Absorbing), new[] { "+1 Borders.compute RelaxAtBorders" }),
            ("an open border", null, s => s.Borders = Border(BorderKind.Open), new[]
            {
                "+1 Borders.compute RelaxAtBorders", "+1 Drains.compute Drain", "+1 Rill.Drains.Regions *", "+1 Rill.Drains.States *",
                "+1 Emitters.compute FindRoom", "+1 Emitters.compute Emit", "+1 Rill.Emitters.*",
            }),
            ("a second force field", Part<FluidForceField>(f => f.Bounds = ForceFieldBounds.Sphere),
                Part<FluidForceField>(f => f.Bounds = ForceFieldBounds.Sphere), new string[0]),
            ("a wind without viscosity", Inviscid, Part<FluidForceField>(f => f.Kind = ForceFieldKind.Wind), new[]
            {
                // which has the density
                "+1 ForceFields.compute Accelerate", "+1 Rill.Fields *", "-1 VelocityUpdate.compute UpdateVelocity",
                    "+1 VelocityUpdate.compute UpdateVelocityViscous",
            }),
            ("a probe", null, Part<FluidProbe>(),
                new[] { "+1 Queries.compute FindSurface", "+1 Queries.compute AnswerPoints", "+1 Rill.Queries.*",
                $"+{Queries.RingSize} Rill.Queries.Results *" }),
            ("a detector", null, Part<FluidDetector>(),
                new[] { "+1 Queries.compute Detect", "+1 Rill.Queries.*", $"+{Queries.RingSize} Rill.Queries.Results *" }),
            ("a second probe and a detector beside one", Part<FluidProbe>(), s => { Part<FluidProbe>()(s); Part<FluidDetector>()(s); },
                new[] { "+1 Queries.compute Detect" }),
            ("a probe beside a phase", Part<FluidEmitter>(e => { Still(e); e.Phase = 1; }), Part<FluidProbe>(),
                new[] { $"+1 Queries.compute FindSurface {ParticleTags.Keyword}",
                $"+1 Queries.compute AnswerPoints {ParticleTags.Keyword}",
                "+1 Rill.Queries.*", $"+{Queries.RingSize} Rill.Queries.Results *" }),
            ("a batch of points", null, Batch(2, 0), new[] { "+1 Queries.compute FindSurface", "+1 Queries.compute AnswerPoints",
                "+1 Clear.compute ClearWords", "+1 Rill.QueryBatch.Points *", "+1 Rill.QueryBatch.FoundPoints *",
                $"+{QueryBatch.RingSize} Rill.QueryBatch.Results *" }),
            ("a batch of rays", null, Batch(0, 2), new[] { "+1 Queries.compute SearchLines", "+1 Queries.compute AnswerRays",
                "+1 Clear.compute ClearWords", "+1 Rill.QueryBatch.Rays *", "+1 Rill.QueryBatch.Lines *", "+1 Rill.QueryBatch.FoundRays *",
                $"+{QueryBatch.RingSize} Rill.QueryBatch.Results *" }),
            ("a batch that asks nothing", null, Batch(0, 0), new string[0]),
            ("an emitter where water sleeps", Settings((ref SolverSettings v) => v.sleepSpeed = 0.02f), Part<FluidEmitter>(Still),
                new[] { $"+1 Emitters.compute Feel {RestingRegions.Keyword}", $"+1 Emitters.compute Press {RestingRegions.Keyword}",
                    $"+1 Emitters.compute FindRoom {RestingRegions.Keyword}", $"+1 Emitters.compute Emit {RestingRegions.Keyword}",
                "+1 Rill.Emitters.*" }),
            // it asks for smoke in its first frame
            ("smoke", null, s => { s.gameObject.AddComponent<FluidSmoke>(); PlayerLoop.Frame(FrameTime); }, new[]
            {
                "+1 Smoke.compute FindWater", "+1 Smoke.compute Move", "+1 Smoke.compute Correct", "+1 Smoke.compute FindCurls",
                "+1 Smoke.compute AddForcesAndConfine", "+1 Smoke.compute FindDivergence", "+2 CoarseSolver.compute *",
                "+1 Smoke.compute Project", "+1 Smoke.compute Shade", "+1 SmokeVolume.shader", "+1 Rill.Smoke.*", "+1 Rill.Coarse.*",
            }),
            // it asks for foam in its first frame
            ("foam", null, s => { s.gameObject.AddComponent<FluidFoam>(); PlayerLoop.Frame(FrameTime); }, new[]
            {
                "+1 FoamSources.compute FindPotentials", "+1 FoamSources.compute CountSpawned", "+1 Foam.compute AverageCells",
                    "+1 Foam.compute Move", "+1 PrefixSum.compute SumTiles",
                "+1 PrefixSum.compute ScanFewTiles", "+1 Foam.compute Compact", "+1 Foam.compute Spawn", "+1 Foam.compute Commit",
                    "+1 FoamParticles.shader", "+1 Rill.Foam.*", "+1 Rill.PrefixSum.TileSums *",
            }),
            ("a pass of a script", null, s => s.BeforeStep += Nothing, new[] { "+1 ParticleAccess.compute RemoveKilled" }),
            ("a pass of a script where water sleeps", Settings((ref SolverSettings v) => v.sleepSpeed = 0.02f),
                s => s.BeforeStep += Nothing, new[] { "+1 ParticleAccess.compute RemoveKilledAsleep" }),
            ("a recorder that does not record", null, s => s.gameObject.AddComponent<FluidRecorder>(), new string[0]),
            ("a playback without a recording", null, s => s.gameObject.AddComponent<FluidPlayback>(), new string[0]),
            ("a recording", null, Record, new[] { "+1 Recording.compute PackFrame", "+2 Rill.RecordedFrame *" }),
            ("phases for a script", null, s => s.TrackPhases = true,
                new[] { "+1 NeighborSearch.compute GatherTags", "+1 Rill.TagsA *", "+1 Rill.TagsB *" }),
            ("one more iteration", null, Settings((ref SolverSettings v) => v.iterations++),
                new[] { "+1 DensityConstraint.compute SolveLambda", "+1 DensityConstraint.compute ApplyDeltaP" }),
        };

        static void Record(FluidSimulation simulation)
        {
            var recorder = simulation.gameObject.AddComponent<FluidRecorder>();
            recorder.OpenFile = _ => new MemoryStream();
            recorder.Record("memory");
        }

        static void Nothing(CommandBuffer commands, FluidParticles particles) { }

        public static IEnumerable<string> FeatureNames => Features.Select(feature => feature.Name);

        [TestCaseSource(nameof(FeatureNames))]
        public void Turning_a_feature_on_changes_its_own_passes_buffers_and_variants_and_no_other_and_turning_it_off_undoes_it(string name)
        {
            var feature = Features.Single(candidate => candidate.Name == name);
            FluidSimulation simulation = Pool();
            feature.Before?.Invoke(simulation);
            SolverSettings settings = simulation.Settings;
            FluidMaterial material = simulation.Material;
            ISceneCollider[] collidersBefore = SceneColliders.Enabled.ToArray();
            FluidPart[] partsBefore = simulation.GetComponentsInChildren<FluidPart>();
            Footprint before = FullestFrame();

            feature.Change(simulation);
            List<string> changes = FullestFrame().Since(before);
            AssertExactly(changes, feature.Expected);

            foreach (FluidPart part in simulation.GetComponentsInChildren<FluidPart>().Except(partsBefore))
                UnityEngine.Object.DestroyImmediate(part.gameObject);
            foreach (FluidEmitter emitter in simulation.GetComponentsInChildren<FluidEmitter>())
                emitter.Lifetime = 0f;
            simulation.BeforeStep -= Nothing;
            simulation.TrackPhases = false;
            simulation.PhaseMaterials = null;
            simulation.MaterialPairs = null;
            simulation.Borders = FluidBorders.Default;
            if (simulation.Solver.Tags != null)
                simulation.Restart();       // until then there may be particles with tags
            simulation.Settings = settings;
            simulation.Material = material;
            simulation.StatisticsInterval = 0;
            foreach (Mover mover in UnityEngine.Object.FindObjectsOfType<Mover>())
                UnityEngine.Object.DestroyImmediate(mover);
            foreach (BatchOwner owner in UnityEngine.Object.FindObjectsOfType<BatchOwner>())
                UnityEngine.Object.DestroyImmediate(owner);
            foreach (FluidCollider collider in SceneColliders.Enabled.Except(collidersBefore).ToArray())
                UnityEngine.Object.DestroyImmediate(collider.gameObject);
            UnityEngine.Object.DestroyImmediate(simulation.GetComponent<FluidSmoke>());
            UnityEngine.Object.DestroyImmediate(simulation.GetComponent<FluidFoam>());
            UnityEngine.Object.DestroyImmediate(simulation.GetComponent<FluidRecorder>());
            UnityEngine.Object.DestroyImmediate(simulation.GetComponent<FluidPlayback>());
            simulation.GetComponent<ParticleRenderer>().ColorBy = ParticleRenderer.Quantity.Speed;
            for (int i = 0; i < 4; i++)
                PlayerLoop.Frame(FrameTime);        // what was read back arrives
            Assert.That(FullestFrame().Since(before), Is.Empty);
        }

        [Test]
        public void A_measurement_dispatches_what_is_explained_and_nothing_else()
        {
            FluidSimulation simulation = Pool();
            Footprint before = FullestFrame();
            simulation.StatisticsInterval = 1;
            var expected = FullestFrame().Since(before).Where(change => change.Contains(".compute"));
            Assert.That(simulation.Results.Describe().SelectMany(stage => stage.Kernels).Where(kernel => kernel.perStep == 0)
                .Select(kernel => "+1 " + Footprint.Short(kernel.kernel)), Is.EquivalentTo(expected));
        }

        [Test]
        public void A_pass_and_a_buffer_too_many_are_seen()
        {
            FluidSimulation simulation = Pool();
            Footprint before = FullestFrame();
            simulation.gameObject.AddComponent<Intruder>();
            List<string> changes = FullestFrame().Since(before);
            Assert.That(changes, Is.SupersetOf(new[] { "+1 PrefixSum.compute ScanFewTiles", $"+1 {Intruder.BufferName} 32" }));
            Assert.Throws<AssertionException>(() => AssertExactly(changes, new string[0]));
            Assert.Throws<AssertionException>(() => AssertExactly(new List<string>(), new[] { "+1 PrefixSum.compute *" }),
                "what is missing is seen too");
        }

        [Test]
        public void A_capacity_beyond_one_list_buffer_changes_the_variant_of_the_kernels_that_read_lists_and_nothing_else()
        {
            Footprint one = StepWithLists(long.MaxValue), two = StepWithLists(2 * 128 * 64 * sizeof(uint));
            string[] kernels = one.Work.Where(entry => entry.StartsWith("DensityConstraint") || entry.StartsWith("VelocityUpdate")).ToArray();
            Assert.That(kernels.Distinct().Count(), Is.EqualTo(4));
            var expected = kernels.GroupBy(entry => entry)
                .SelectMany(entry => new[] { $"-{entry.Count()} {entry.Key}",
                $"+{entry.Count()} {entry.Key} {NeighborLists.TwoListsKeyword}" });
            AssertExactly(two.Since(one), expected.Append("-1 Rill.Neighbors *").Append("+1 Rill.Neighbors *").Append("+1 Rill.MoreNeighbors *"));
            Assert.That(Unneeded(one), Is.Empty);
            Assert.That(Unneeded(two), Has.Member("DensityConstraint.compute BuildList "
                + NeighborLists.TwoListsKeyword).And.Some.StartsWith("Rill.MoreNeighbors"));
        }

        [TestCase("Still Pool", false)]
        [TestCase("Column", true)]
        [TestCase("Dam Break", true)]
        public void A_sample_runs_what_it_explains_and_the_coarse_solve_only_where_the_water_is_deep(string sample, bool deep)
        {
            InSample(sample, simulation =>
            {
                // The scene's, not the fluid's: its shadow map and depth are draws of their own.
                foreach (Light light in UnityEngine.Object.FindObjectsOfType<Light>())
                    light.shadows = LightShadows.None;
                foreach (MeshRenderer renderer in UnityEngine.Object.FindObjectsOfType<MeshRenderer>())
                    renderer.enabled = false;
                foreach (DomainRenderer renderer in UnityEngine.Object.FindObjectsOfType<DomainRenderer>())
                    renderer.enabled = false;
                for (int i = 0; i < 2; i++)     // what finds the surface is asked in the first and there in the second
                    PlayerLoop.Frame(FrameTime);
                Footprint frame = Footprint.Of(() => PlayerLoop.Frame(FrameTime));       // the third: none of the samples measures before the fourth
                List<StageDescription> stages = simulation.Results.Describe();
                // The sky and the copy of the opaque scene are the camera's, however many fluids it sees; the surface's particles and its mesh,
                // with two sums, are found once a frame.
                string[] others = { "BlitCopy.shader", "SkyboxProcedural.shader", "SurfaceParticles.compute", "SurfaceMesh.compute" };
                string[] sums = { "PrefixSum.compute SumTiles", "PrefixSum.compute ScanFewTiles" };
                Assert.That(frame.Work.Where(entry => !others.Any(entry.StartsWith)),
                    Is.EquivalentTo(Footprint.Explained(stages).Concat(sums).Concat(sums)));
                StageDescription coarse = stages.Single(stage => stage.Name == "Coarse correction");
                Assert.That(coarse.IsUsed, Is.EqualTo(deep), coarse.Reason);
                Assert.That(coarse.Reason, Does.Match(@"^water \d+ layers deep, (more than|at most) \d+"));
                Assert.That(Unneeded(frame).Any(), Is.EqualTo(deep), string.Join("\n", Unneeded(frame)));
            });
        }

        [TestCase("deep water")]
        [TestCase("vorticity")]
        [TestCase("elasticity")]
        [TestCase("artificial pressure")]
        [TestCase("surface tension")]
        [TestCase("sleep")]
        [TestCase("a collider")]
        [TestCase("an emitter with a phase")]
        [TestCase("a drain")]
        [TestCase("a force field")]
        [TestCase("a probe")]
        [TestCase("a detector")]
        [TestCase("a batch of rays")]
        public void What_a_shallow_pool_leaves_out_would_be_seen_if_it_ran(string name)
        {
            FluidSimulation simulation = Pool();
            Assert.That(Unneeded(FullestFrame()), Is.Empty);
            Features.Single(feature => feature.Name == name).Change(simulation);
            Assert.That(Unneeded(FullestFrame()), Is.Not.Empty);
        }

        static IEnumerable<string> Instead(int count, string kernel, string suffix) => new[] { $"-{count} {kernel}", $"+{count} {kernel}{suffix}" };

        static string[] WithCollider(string react)
        {
            return new[]
            {
                "+1 Rill.Colliders.*", "+1 Colliders.compute CollidePaths" + react,
                $"+{Iterations - 1} Colliders.compute Collide" + react, "+1 Colliders.compute CollideLast" + react,
            }
                .Concat(Instead(1, "NeighborSearch.compute CountCells", "WithColliders"))
                    .Concat(Instead(1, "NeighborSearch.compute Gather", "WithColliders"))
                    .Concat(Instead(1, "DensityConstraint.compute BuildList", "WithColliders"))
                    .Concat(Instead(Iterations - 1, "DensityConstraint.compute SolveLambda", "WithColliders"))
                .Concat(Instead(1, "VelocityUpdate.compute UpdateVelocityViscous", "WithColliders")).ToArray();
        }

        sealed class Mover : MonoBehaviour
        {
            void Update() => transform.Rotate(0f, 1f, 0f);
        }

        static void AddCollider(FluidSimulation simulation, bool measuresForce)
        {
            var collider = new GameObject("Collider").AddComponent<FluidCollider>();
            collider.transform.position = simulation.transform.position;
            collider.Size = 3f * Spacing * Vector3.one;
            collider.MeasuresForce = measuresForce;
        }

        static void AddDeforming(Vector3 position)
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.transform.position = position;
            cube.AddComponent<FluidDeformingMesh>();
        }

        static IEnumerable<string> InVariant(string keyword, params string[] kernels)
            => kernels.SelectMany(kernel => new[] { $"-1 {kernel}", $"+1 {kernel} {keyword}" });

        static IEnumerable<string> Unneeded(Footprint footprint)
            => footprint.Work.Concat(footprint.Buffers).Where(entry => NotForAShallowPool.Any(entry.Contains));

        static void AssertExactly(List<string> changes, IEnumerable<string> expected)
        {
            var left = new List<string>(changes);
            foreach (string text in expected)
            {
                bool Matches(string change) => text.EndsWith('*') ? change.StartsWith(text.TrimEnd('*')) : change == text;
                Assert.That(left.RemoveAll(Matches), Is.GreaterThan(0), $"{text} is not among\n{string.Join("\n", changes)}");
            }
            Assert.That(left, Is.Empty);
        }

        // The frame with most work of several: with statistics not each has a measurement.
        static Footprint FullestFrame()
        {
            PlayerLoop.Frame(FrameTime);
            return Enumerable.Range(0, 4).Select(_ => Footprint.Of(() => PlayerLoop.Frame(FrameTime)))
                .OrderByDescending(frame => frame.Work.Count).First();
        }

        // 8 x 3 x 8 particles on the floor of a box that they fill, drawn.
        static FluidSimulation Pool()
        {
            var fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            var simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(8f, 8f, 8f) * Spacing, Spacing, 192);
            simulation.StatisticsInterval = 0;
            Settings((ref SolverSettings v) => v.iterations = Iterations)(simulation);
            var water = new GameObject("Water");
            water.transform.SetParent(fluid.transform, false);
            water.transform.localPosition = new Vector3(0f, -2.5f, 0f) * Spacing;
            water.AddComponent<FluidVolume>().Size = new Vector3(8f, 3f, 8f) * Spacing;
            fluid.AddComponent<ParticleRenderer>();
            new GameObject("Camera").AddComponent<Camera>().transform.position = new Vector3(0f, 0f, -4f);
            fluid.SetActive(true);
            return simulation;
        }

        static Footprint StepWithLists(long maxBinding)
        {
            StepInput input = new StepInput { timeStep = FrameTime, gravity = new float3(0f, -9.81f, 0f), settings = SolverSettings.Default,
                material = FluidMaterial.Water };
            using var solver = new PbfSolver(new SolverLayout(8f * Spacing, Spacing, 500, 64, 1f, maxBinding));
            using (var positions = new NativeArray<float4>(1, Allocator.Persistent))
                solver.Add(positions, positions);
            using var commands = new CommandBuffer { name = "step" };
            solver.Step(commands, input);
            return Footprint.Of(() => Graphics.ExecuteCommandBuffer(commands));
        }

        static void InSample(string sample, Action<FluidSimulation> test)
        {
            using (new SampleScene(sample))
                test(UnityEngine.Object.FindObjectOfType<FluidSimulation>());
        }

        delegate void SettingsChange(ref SolverSettings settings);
        delegate void MaterialChange(ref FluidMaterial material);

        static Action<FluidSimulation> Settings(SettingsChange change) => simulation =>
        {
            SolverSettings settings = simulation.Settings;
            change(ref settings);
            simulation.Settings = settings;
        };

        static Action<FluidSimulation> Material(MaterialChange change) => simulation =>
        {
            FluidMaterial material = simulation.Material;
            change(ref material);
            simulation.Material = material;
        };

        static Action<FluidSimulation> Part<T>(Action<T> set = null) where T : FluidPart => simulation =>
        {
            var part = new GameObject(typeof(T).Name);
            part.SetActive(false);
            part.transform.SetParent(simulation.transform, false);
            T component = part.AddComponent<T>();
            set?.Invoke(component);
            part.SetActive(true);
        };

        // With room for more than it asks.
        static Action<FluidSimulation> Batch(int points, int rays) => simulation =>
        {
            var batch = new FluidQueryBatch(simulation, points + (rays == 0 ? 1 : 0), rays);
            batch.SetPoints(new Vector3[points], 0, points);
            batch.SetRays(Enumerable.Repeat(new FluidRay(Vector3.up, Vector3.down), rays).ToArray(), 0, rays);
            simulation.gameObject.AddComponent<BatchOwner>().Batch = batch;
        };

        sealed class BatchOwner : MonoBehaviour
        {
            public FluidQueryBatch Batch;
            void OnDestroy() => Batch.Dispose();
        }

        static void Still(FluidEmitter emitter) => emitter.Rate = 0f;

        static FluidBorders Border(BorderKind kind)
        {
            FluidBorders borders = FluidBorders.Default;
            borders.maxX = new FluidBorder { kind = kind, width = 4f * Spacing, level = Spacing };
            return borders;
        }

        static void Aside(FluidDrain drain) => drain.transform.localPosition = new Vector3(0f, 5f, 0f);

        static void Inviscid(FluidSimulation simulation) => Material((ref FluidMaterial v) => v.velocitySmoothing = 0f)(simulation);

        static void ColorByDensity(FluidSimulation simulation)
            => simulation.GetComponent<ParticleRenderer>().ColorBy = ParticleRenderer.Quantity.Density;

        /// <summary>Work that no stage of the fluid answers for.</summary>
        sealed class Intruder : MonoBehaviour
        {
            public const string BufferName = "Planted.Counts";
            PrefixSum sum;
            GraphicsBuffer counts, sums;
            CommandBuffer commands;

            void OnEnable()
            {
                sum = new PrefixSum(StageShader.LoadCompute("PrefixSum"), 8);
                counts = GpuBuffer.Structured<uint>(BufferName, 8);
                sums = GpuBuffer.Structured<uint>("Planted.Sums", 8);
                counts.SetData(new uint[8]);
                commands = new CommandBuffer { name = "Intruder" };
                sum.Record(commands, counts, sums, 8);
            }

            void Update() => Graphics.ExecuteCommandBuffer(commands);

            void OnDisable()
            {
                sum.Dispose();
                GpuBuffer.Release(ref counts);
                GpuBuffer.Release(ref sums);
                commands.Dispose();
            }
        }
    }
}
