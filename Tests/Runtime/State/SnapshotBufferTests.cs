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

        // By the path from the solver.
        static readonly Dictionary<string, (Why why, string reason)> NotStored = new Dictionary<string, (Why, string)>
        {
            { "particles.Predicted", (Why.Rewritten, "the sort writes it") },
            { "particles.SortedIds", (Why.Rewritten, "the sort writes it") },
            { "particles.AliveArguments", (Why.Follows, "from the counters") },
            { "particles.SortedArguments", (Why.Follows, "the sort writes it from the counters") },
            { "constants", (Why.Follows, "from layout and settings, in each step") },
            { "neighborSearch.cellHistogram", (Why.Zero, "the prefix sum clears what it has read") },
            { "neighborSearch.cellRanks", (Why.Rewritten, "the count writes it") },
            { "neighborSearch.cellStartsAtRest", (Why.Rewritten, "the prefix sum writes it") },
            { "neighborSearch.Order", (Why.Rewritten, "the sort writes it") },
            { "coarseCorrection.Bins", (Why.Zero, "passes clear what they have read") },
            { "coarseCorrection.weightedCounts", (Why.Zero, "FindSurface clears what it has read") },
            { "coarseCorrection.flow", (Why.Rewritten, "FindDivergence writes it") },
            { "coarseCorrection.fill", (Why.Rewritten, "FindDivergence and FindErrors write it") },
            { "coarseCorrection.source", (Why.Rewritten, "FindDivergence and FindErrors write it") },
            { "coarseCorrection.diagonal", (Why.Rewritten, "FindDivergence and FindErrors write it") },
            { "coarseCorrection.Displacements", (Why.Rewritten, "DisplaceFlow and DisplaceErrors write it") },
            { "coarseCorrection.Constants", (Why.Follows, "from the grid") },
            { "coarseCorrection.Solver.smoothed", (Why.Rewritten, "a cycle writes it") },
            { "coarseCorrection.Solver.couplings", (Why.Rewritten, "a cycle writes it") },
            { "coarseCorrection.Solver.residuals", (Why.Rewritten, "a cycle writes it") },
            { "coarseCorrection.Solver.errors", (Why.Rewritten, "a cycle writes it") },
            { "coarseCorrection.Solver.corrections", (Why.Rewritten, "a cycle writes it") },
            { "coarseCorrection.coarseColliders.raw", (Why.Follows, "from the colliders, again where there are others") },
            { "coarseCorrection.coarseColliders.open", (Why.Follows, "from the colliders, again where there are others") },
            { "coarseCorrection.coarseColliders.centers", (Why.Follows, "from the colliders, again where there are others") },
            { "coarseCorrection.coarseColliders.flow", (Why.Follows, "from the colliders, again where there are others") },
            { "colliders.constants", (Why.Follows, "from the colliders, again where there are others") },
            { "colliders.states", (Why.Follows, "from the colliders, again where there are others") },
            { "colliders.masks", (Why.Follows, "from the colliders, again where there are others") },
            { "colliders.colliderVolume", (Why.Follows, "from the colliders, again where there are others") },
            { "colliders.boundary", (Why.Rewritten, "the sort writes it") },
            { "colliders.contactOffsets", (Why.Rewritten, "the sort writes it") },
            { "colliders.pathBoundary", (Why.Rewritten, "the count and CollidePaths write it") },
            { "colliders.pathContactOffsets", (Why.Rewritten, "the count and CollidePaths write it") },
            { "implicitViscosity.solution", (Why.Rewritten, "FindCoefficients writes it") },
            { "implicitViscosity.nextSolution", (Why.Rewritten, "a pass writes it") },
            { "implicitViscosity.changes", (Why.Rewritten, "FindResidual writes it") },
            { "implicitViscosity.holds", (Why.Rewritten, "FindCoefficients writes it") },
            { "viscoelasticity.deformed", (Why.Rewritten, "Deform writes it") },
            { "viscoelasticity.stress", (Why.Rewritten, "Deform writes it") },
            { "viscoelasticity.previousIndices", (Why.Rewritten, "the sort writes it") },
            { "velocityExtrapolation.sorted", (Why.Rewritten, "the sort writes it") },
            { "vorticityConfinement.curl", (Why.Rewritten, "Curl writes it") },
            { "vorticityConfinement.unconfined", (Why.Rewritten, "the velocity update writes it") },
            { "restingRegions.states", (Why.Rewritten, "Spread writes it") },
            { "tags.sorted", (Why.Rewritten, "the sort writes it") },
            { "emitters.free", (Why.Rewritten, "FindRoom writes it") },
            { "emitters.constants", (Why.Follows, "from the emitters, in each step") },
            { "emitters.positionBuffers", (Why.Follows, "from the emitters' shapes") },
            { "drains.regions", (Why.Follows, "from the drains, in each step") },
            { "drains.histogram", (Why.Zero, "SelectRandom clears what it has read") },
            { "forceFields.regions", (Why.Follows, "from the fields, in each step") },
            { "foam.particles", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.moved", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.arguments", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.cells", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.potentials", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.spawnCounts", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.groupCounts", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.sums", (Why.Output, "foam does not act on the water, and begins again") },
            { "foam.readback.buffer", (Why.Output, "foam does not act on the water, and begins again") },
        };

        // What belongs to a helper of several stages, or to what is drawn and measured.
        static readonly Dictionary<string, string> NotStoredBelow = new Dictionary<string, string>
        {
            { "neighborSearch.prefixSum.", "a prefix sum begins from nothing" },
            { "foam.prefixSum.", "a prefix sum begins from nothing" },
            { "statistics.", "measured, not read by a step" },
            { "surface.", "drawn, not read by a step" },
            { "surfaceWorkspace.", "each surface writes it before it is read" },
            { "particleUpload.", "free between uploads" },
            { "packing.", "a frame that was uploaded" },
        };

        static readonly string[] Lists = { "densityConstraint.Lists.first", "densityConstraint.Lists.second", "densityConstraint.Lists.counts" };

        static SnapshotCase AllStages => new SnapshotCase
        {
            name = "all stages", deepWater = DeepWater.On, depth = 0.5f, substeps = 2, numericalDamping = 0.5f, dynamicViscosity = 0.5f,
            colliders = true, emitter = true, drain = true,
            field = true, moves = true, sleepSpeed = 0.02f, draws = true,
        };

        static SnapshotCase ElasticStages => new SnapshotCase { name = "elastic stages", shearModulus = 100f, vorticity = 0.3f, colliders = true };

        [Test]
        public void Every_buffer_is_stored_or_has_a_reason_not_to_be()
        {
            var seen = new HashSet<string>();
            foreach (SnapshotCase made in new[] { AllStages, ElasticStages })
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
            Assert.That(NotStored.Keys.Where(path => !seen.Contains(path)), Is.Empty, "on the list, but there is no such buffer");
            TestContext.Out.WriteLine($"{seen.Count} buffers, " +
                $"{seen.Count(path => !NotStored.ContainsKey(path) && !NotStoredBelow.Keys.Any(path.StartsWith))} of them stored");
        }

        // What would be read before it is written shows: the fluid goes on as it did all the same.
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
            scene.Fluid.Solver.CaptureReactions(capture, contents, scene.Fluid.ColliderSet, default);
            return new HashSet<GraphicsBuffer>(capture.Buffers);
        }
    }
}
