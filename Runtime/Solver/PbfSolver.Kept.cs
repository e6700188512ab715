using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What is kept outside of a box that moves: particles that leave it, until it is there again.
    partial class PbfSolver
    {
        // Numbers of the transfers out of the box, back into it, and to its new frame, behind those from neighbors.
        const int Leaving = ParticleTransfer.MaxTransfers, Returning = Leaving + 1, Listing = Leaving + 2;

        KeptParticles kept;

        /// <summary>Whether particles may be outside.</summary>
        public bool KeepsParticles => kept != null;

        /// <summary>Particles outside, as far as has come back.</summary>
        public int KeptCount => Transferred(Leaving, TransferWord.Handed) - Transferred(Returning, TransferWord.Handed);

        /// <summary>Particles of the newest move that were to be kept and had no room, as far as has come back.</summary>
        public int RefusedToKeep => Transferred(Leaving, TransferWord.Held);

        /// <summary>What is kept outside goes along with a box that is put elsewhere.</summary>
        /// <param name="from">Where the box was in world space, m, its lowest corner.</param>
        /// <param name="to">Where it is now.</param>
        public void TeleportKept(in RigidPose from, in RigidPose to) => kept?.Teleport(from, to);

        /// <summary>Moves the box and leaves the particles where they are in the world, at once: those outside are kept up to a number, and
        /// those kept that it then covers come back.</summary>
        /// <param name="from">Where the box was in world space, m, its lowest corner.</param>
        /// <param name="to">Where it then is, turned as before.</param>
        /// <param name="most">Most particles outside; those kept before stay.</param>
        /// <param name="keeps">False removes those that leave.</param>
        public void Shift(in RigidPose from, in RigidPose to, int most, bool keeps)
        {
            PrepareConstants();
            if (keeps && kept == null)
                kept = new KeptParticles(most, from);
            if (tags != null)
                kept.NeedTags();
            else if (kept.HasTags)
                tags = new ParticleTags(Layout.Capacity);
            Transfer.Reserve(math.max(Layout.Capacity, kept.Capacity));
            ParticleSet fluid = particles.AsSet(tags);
            using (var cmd = new CommandBuffer { name = "Rill.Keep" })
            {
                // To the frame of the box as it will be. What it will not cover goes first: that is kept already.
                Transfer.Record(cmd, kept.Set, kept.Next, RegionOf(kept.Box, to, Listing), TransferRule.Outside | TransferRule.KeepsIds);
                if (keeps)
                    Transfer.Record(cmd, fluid, kept.Next, RegionOf(from, to, Leaving), TransferRule.Outside | TransferRule.KeepsIds);
                Graphics.ExecuteCommandBuffer(cmd);
                cmd.Clear();
                Shift(math.rotate(math.inverse(to.rotation), from.position - to.position) / Layout.Spacing);
                Transfer.Record(cmd, kept.Set, fluid, RegionOf(kept.Box, to, Returning), TransferRule.KeepsIds);
                // What came to a full box waits for the next move.
                Transfer.Record(cmd, kept.Set, kept.Next, RegionOf(kept.Box, to, Listing), TransferRule.All | TransferRule.KeepsIds);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            kept.Advance(to);
            NoteAdded(Layout.Capacity, minAdded, maxAdded);
            Transfer.Request();
        }

        void RemoveKept()
        {
            if (kept == null)
                return;
            ReleaseKept();
            ResetTransfer(Leaving);
            ResetTransfer(Returning);
        }

        TransferRegion RegionOf(in RigidPose from, in RigidPose to, int number) => RegionOf(from, to, Layout, number);

        static TransferRegion RegionOf(in RigidPose from, in RigidPose to, SolverLayout taker, int number)
        {
            quaternion toTaker = math.inverse(to.rotation);
            return new TransferRegion
            {
                offset = math.rotate(toTaker, from.position - to.position) / taker.Spacing,
                rotation = math.mul(toTaker, from.rotation),
                size = taker.DomainSize,
                number = number,
            };
        }

        void ReleaseKept()
        {
            kept?.Dispose();
            kept = null;
        }
    }
}
