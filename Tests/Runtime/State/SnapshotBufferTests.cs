using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Every buffer of the solver is in a snapshot, or here with the reason why it need not be; and the reason holds.</summary>
    public class SnapshotBufferTests
    {
        enum Why
        {
            /// <summary>A step writes it before it reads it.</summary>
            Rewritten,
            /// <summary>0 between steps.</summary>
            Zero,
            /// <summary>Follows from layout, settings, scene or another buffer.</summary>
            Follows,
            /// <summary>No step reads it.</summary>
            Output,
        }

        // By name.
        static readonly Dictionary<string, (Why why, string reason)> NotStored = new Dictionary<string, (Why, string)>
        {
            { "Rill.PositionsB", (Why.Rewritten, "the sort writes it") },
            { "Rill.IdsB", (Why.Rewritten, "the sort writes it") },
            { "Rill.AliveArguments", (Why.Follows, "from the counters") },
            { "Rill.SortedArguments", (Why.Follows, "the sort writes it from the counters") },
            { "constants", (Why.Follows, "from layout and settings, in each step") },
            { "Rill.CellHistogram", (Why.Zero, "the prefix sum clears what it has read") },
            { "Rill.CellRanks", (Why.Rewritten, "the count writes it") },
            { "Rill.CellStartsAtRest", (Why.Rewritten, "the prefix sum writes it") },
            { "Rill.Order", (Why.Rewritten, "the sort writes it") },
            { "Rill.Coarse.Bins", (Why.Zero, "passes clear what they have read") },
            { "Rill.Coarse.WeightedCounts", (Why.Zero, "FindSurface clears what it has read") },
            { "Rill.Coarse.Flow", (Why.Rewritten, "FindDivergence writes it") },
            { "Rill.Coarse.DeepFlow", (Why.Rewritten, "DisplaceFlow writes it") },
            { "Rill.Coarse.Fill", (Why.Rewritten, "FindDivergence and FindErrors write it") },
            { "Rill.Coarse.Source", (Why.Rewritten, "FindDivergence and FindErrors write it") },
            { "Rill.Coarse.Diagonal", (Why.Rewritten, "FindDivergence and FindErrors write it") },
            { "Rill.Coarse.Displacements", (Why.Rewritten, "DisplaceFlow and DisplaceErrors write it") },
            { "Rill.Coarse.CellDensities", (Why.Rewritten, "FindSurface writes it") },
            { "Rill.Phases", (Why.Follows, "from the materials, in each step") },
            { "Rill.Coarse.Constants", (Why.Follows, "from the grid") },
            { "Rill.Coarse.Smoothed", (Why.Rewritten, "a cycle writes it") },
            { "Rill.Coarse.Couplings", (Why.Rewritten, "a cycle writes it") },
            { "Rill.Coarse.Residuals", (Why.Rewritten, "a cycle writes it") },
            { "Rill.Coarse.Errors", (Why.Rewritten, "a cycle writes it") },
            { "Rill.Coarse.Corrections", (Why.Rewritten, "a cycle writes it") },
            { "Rill.Coarse.RawOpenFractions", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Coarse.OpenFractions", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Coarse.OpenCenters", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Coarse.ColliderFlow", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Colliders.Constants", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Colliders.States", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Colliders.Masks", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Colliders.ColliderVolume", (Why.Follows, "from the colliders, again where there are others") },
            { "Rill.Colliders.Boundary", (Why.Rewritten, "the sort writes it") },
            { "Rill.Colliders.ContactOffsets", (Why.Rewritten, "the sort writes it") },
            { "Rill.Colliders.PathBoundary", (Why.Rewritten, "the count and CollidePaths write it") },
            { "Rill.Colliders.PathContactOffsets", (Why.Rewritten, "the count and CollidePaths write it") },
            { "Rill.ViscousVelocities", (Why.Rewritten, "FindCoefficients writes it") },
            { "Rill.NextViscousVelocities", (Why.Rewritten, "a pass writes it") },
            { "Rill.ViscousChanges", (Why.Rewritten, "FindResidual writes it") },
            { "Rill.ViscousHolds", (Why.Rewritten, "FindCoefficients writes it") },
            { "Rill.Friction.Constants", (Why.Follows, "from the material, in each step") },
            { "Rill.Friction.NodeSums", (Why.Zero, "FindNodes clears what it has read") },
            { "Rill.Friction.CellSums", (Why.Zero, "FindCells clears what it has read") },
            { "Rill.Friction.NodeFlows", (Why.Rewritten, "FindNodes writes it") },
            { "Rill.Friction.NewFlows", (Why.Rewritten, "FindNodes writes it") },
            { "Rill.Friction.NodeSolids", (Why.Rewritten, "FindSolids writes it") },
            { "Rill.Friction.Trial", (Why.Rewritten, "FindCells writes it") },
            { "Rill.Friction.Limits", (Why.Rewritten, "FindCells writes it before the prediction") },
            { "Rill.ContactCounts", (Why.Rewritten, "FindContacts writes it") },
            { "Rill.DeformedConformation", (Why.Rewritten, "Deform writes it") },
            { "Rill.Stress", (Why.Rewritten, "Deform writes it") },
            { "Rill.PreviousIndices", (Why.Rewritten, "the sort writes it") },
            { "Rill.SortedMeans", (Why.Rewritten, "the sort writes it") },
            { "Rill.Curl", (Why.Rewritten, "Curl writes it") },
            { "Rill.Unconfined", (Why.Rewritten, "the velocity update writes it") },
            { "Rill.Regions.States", (Why.Rewritten, "Spread writes it") },
            { "Rill.TagsB", (Why.Rewritten, "the sort writes it") },
            { "Rill.Emitters.Free", (Why.Rewritten, "FindRoom writes it") },
            { "Rill.Emitters.Constants", (Why.Follows, "from the emitters, in each step") },
            { "Emitters.positionBuffers", (Why.Follows, "from the emitters' shapes") },
            { "Rill.Drains.Regions", (Why.Follows, "from the drains, in each step") },
            { "Rill.Drains.Histogram", (Why.Zero, "SelectRandom clears what it has read") },
            { "Rill.Fields", (Why.Follows, "from the fields, in each step") },
            { "Rill.Foam.Particles", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.Moved", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.Arguments", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.Cells", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.Potentials", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.SpawnCounts", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.GroupCounts", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.Sums", (Why.Output, "foam does not act on the water, and begins again") },
            { "Rill.Foam.Counters", (Why.Output, "foam does not act on the water, and begins again") },
        };

        // Parts that belong to a helper of several stages, or to what is drawn and measured.
        static readonly Dictionary<string, string> NotStoredBelow = new Dictionary<string, string>
        {
            { "neighborSearch.prefixSum.", "a prefix sum begins from nothing" },
            { "Foam.prefixSum.", "a prefix sum begins from nothing" },
            { "Rill.Statistics.", "measured, not read by a step" },
            { "Rill.Surface", "drawn, not read by a step" },
            { "surfaceWorkspace.", "each surface writes it before it is read" },
            { "particleUpload.", "free between uploads" },
            { "Rill.PlayedFrame", "a frame that was uploaded" },
        };

        static readonly string[] Lists = { "Rill.Neighbors", "Rill.MoreNeighbors", "Rill.NeighborCounts" };

        static SnapshotCase AllStages => new SnapshotCase
        {
            name = "all stages", density = 500f, deepWater = DeepWater.On, depth = 0.5f, substeps = 2, numericalDamping = 0.5f,
            dynamicViscosity = 0.5f, colliders = true, emitter = true, drain = true,
            field = true, moves = true, sleepSpeed = 0.02f, draws = true,
        };

        // Deep, of one liquid: several are not blended to the coarse flow.
        static SnapshotCase ElasticStages => new SnapshotCase
        {
            name = "elastic stages", shearModulus = 100f, vorticity = 0.3f, frictionAngle = 30f, colliders = true,
            deepWater = DeepWater.On, depth = 0.5f
        };

        [Test]
        public void Every_buffer_is_stored_or_has_a_reason_not_to_be()
        {
            var seen = new HashSet<string>();
            foreach (SnapshotCase made in new[] { AllStages, ElasticStages, new SnapshotCase { name = "contacts", contacts = true } })
                using (SnapshotScene scene = new SnapshotScene(made).Run(6))
                {
                    HashSet<GraphicsBuffer> stored = Stored(scene);
                    foreach (KeyValuePair<string, GraphicsBuffer> buffer in SolverBuffers.Of(scene.Fluid.Solver))
                    {
                        seen.Add(buffer.Key);
                        bool isListed = NotStored.ContainsKey(buffer.Key) || NotStoredBelow.Keys.Any(buffer.Key.StartsWith)
                            || Lists.Contains(buffer.Key) && made.dynamicViscosity == 0f;
                        Assert.That(stored.Contains(buffer.Value) || isListed, $"{buffer.Key} is in no snapshot. Put it into ListState " +
                            $"of its stage, or here with the reason why no step depends on it.");
                        Assert.That(stored.Contains(buffer.Value) && isListed, Is.False,
                            $"{buffer.Key} is in snapshots and on the list of what is not");
                    }
                }
            Assert.That(NotStored.Keys.Where(path => !seen.Contains(path)), Is.Empty, "on the list, but not a buffer");
            TestContext.Out.WriteLine($"{seen.Count} buffers, " +
                $"{seen.Count(path => !NotStored.ContainsKey(path) && !NotStoredBelow.Keys.Any(path.StartsWith))} of them stored");
        }

        // Reads before a write would show: the fluid goes on as it did all the same.
        [Test, Category("LongRun")]
        public void A_restored_fluid_reads_nothing_that_is_not_stored([Values] bool elastic)
        {
            SnapshotCase made = elastic ? ElasticStages : AllStages;
            using (var scene = new SnapshotScene(made))
            {
                FluidSnapshot snapshot = scene.Run(9).Take();
                int taken = scene.Frame;
                ParticleState expected = scene.Run(5).Read();
                foreach (KeyValuePair<string, GraphicsBuffer> buffer in SolverBuffers.Of(scene.Fluid.Solver))
                    if (NotStored.TryGetValue(buffer.Key, out (Why why, string reason) known) && known.why == Why.Zero)
                        Assert.That(GpuTest.Read<uint>(buffer.Value, buffer.Value.count * buffer.Value.stride / sizeof(uint)), Is.All.Zero,
                            buffer.Key);

                scene.GoTo(taken).Fluid.Restore(snapshot);
                int filled = 0;
                foreach (KeyValuePair<string, GraphicsBuffer> buffer in SolverBuffers.Of(scene.Fluid.Solver))
                    if (NotStored.TryGetValue(buffer.Key, out (Why why, string reason) known) && known.why == Why.Rewritten)
                    {
                        GpuTest.FillWithGarbage(buffer.Value);
                        filled++;
                    }
                Assert.That(filled, Is.GreaterThan(10));
                TestFluid.AssertSame(scene.Run(5).Read(), expected);
            }
        }

        static HashSet<GraphicsBuffer> Stored(SnapshotScene scene)
        {
            var contents = new SnapshotContents();
            SnapshotCapture capture = scene.Fluid.Solver.Capture(contents);
            scene.Fluid.Solver.CaptureReactions(capture, contents, scene.Fluid.Inputs.Colliders.Set, default);
            return new HashSet<GraphicsBuffer>(capture.Buffers);
        }
    }
}
