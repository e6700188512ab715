using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Particles that change fluids. What goes to neighbors whose boxes overlap: once a frame each fluid takes the particles that crossed to its
    // side, and copies those that are left in its box as ghosts, which take part in the steps of that frame. What a box that moves leaves
    // outside, where it stays until the box is there again. What it hands over to another fluid.
    partial class PbfSolver
    {
        bool hasGhosts;         // since the last removal
        int ghostFrame;         // in which they came

        /// <summary>Particles of which transfer number it took how many, as far as has come back.</summary>
        public int Transferred(int number, TransferWord word) => Transfer?.Latest(number, word) ?? 0;

        /// <summary>Starts the readback of what was taken from neighbors.</summary>
        public void RequestTransferred() => Transfer?.Request();

        /// <summary>The number goes to another: nothing was transferred under it.</summary>
        public void ResetTransfer(int number) => Transfer?.Reset(number);

        /// <summary>Whether the state is a snapshot's, and no step was taken from it.</summary>
        public bool IsRestored => isRestored;

        /// <summary>As two fluids are connected, at once: each gets what lies on its side, and of what both were filled with one is
        /// removed. Before a step of either.</summary>
        public static void PartFrom(PbfSolver one, in TransferRegion toOne, PbfSolver other, in TransferRegion toOther)
        {
            one.SplitFrom(other, toOne);
            other.SplitFrom(one, toOther);
        }

        /// <summary>Whether there are ghosts that no step has removed.</summary>
        public bool HasGhosts => hasGhosts;

        /// <summary>Records the removal of the ghosts, after what looks at the lists of the last step.</summary>
        public void RecordGhostRemoval(CommandBuffer cmd)
        {
            if (!hasGhosts)
                return;
            hasGhosts = false;
            Transfer.RecordRemoval(cmd, particles.AsSet(ParticleTags));
            MarkRemoved();
        }

        // Ghosts of an earlier frame, in which no step followed; those of this one stay, whichever neighbor they are of.
        void RecordStaleRemoval(CommandBuffer cmd, int frame)
        {
            if (ghostFrame != frame)
                RecordGhostRemoval(cmd);
            ghostFrame = frame;
        }

        void PrepareConnections(in StepInput input)
        {
            StepConnections connections = input.connections;
            if (connections == null || !input.takesParticles)
                return;
            for (int c = 0; c < connections.count; c++)
            {
                ref StepConnection connection = ref connections.items[c];
                PrepareExchange(connection.neighbor, connection.region);
                if (connection.isMutual)
                    connection.neighbor.PrepareExchange(this, connection.back);
            }
        }

        void RecordConnections(in StepContext step)
        {
            StepConnections connections = step.Input.connections;
            if (connections == null || !step.Input.takesParticles)
                return;
            CommandBuffer cmd = step.Commands;
            RecordGhostsBefore(cmd, connections);
            RecordTakes(cmd, connections, TransferRule.Move);
            // After all of what is this fluid's: a ghost of one neighbor may be another's particle.
            RecordTakes(cmd, connections, TransferRule.Copies);
        }

        void RecordTakes(CommandBuffer cmd, StepConnections connections, TransferRule rule)
        {
            for (int c = 0; c < connections.count; c++)
            {
                ref StepConnection connection = ref connections.items[c];
                if (rule == TransferRule.Move && connection.copiesOnly)
                    continue;
                RecordTake(cmd, connection.neighbor, connection.region, rule);
                if (connection.isMutual)
                    connection.neighbor.RecordTake(cmd, this, connection.back, rule);
            }
        }

        // Of a neighbor that took no step since.
        void RecordGhostsBefore(CommandBuffer cmd, StepConnections connections)
        {
            if (connections.count > 0)
                RecordStaleRemoval(cmd, connections.items[0].frame);
            for (int c = 0; c < connections.count; c++)
                if (connections.items[c].isMutual)
                    connections.items[c].neighbor.RecordStaleRemoval(cmd, connections.items[c].frame);
        }

        void RecordTake(CommandBuffer cmd, PbfSolver neighbor, TransferRegion region, TransferRule rule)
        {
            bool copies = rule == TransferRule.Copies;
            if (copies)
                region.plane = 0f;
            Transfer.Record(cmd, neighbor.particles.AsSet(neighbor.ParticleTags), particles.AsSet(ParticleTags), region, rule);
            if (copies)
                hasGhosts = true;
            else
                neighbor.MarkRemoved();
        }

        void SplitFrom(PbfSolver from, in TransferRegion region)
        {
            PrepareConstants();
            PrepareExchange(from, region);
            using (var cmd = new CommandBuffer { name = "Rill.Connect" })
            {
                StepContext taker = BetweenSteps(cmd);
                neighborSearch.RecordOrderAtRest(taker);
                Transfer.RecordApart(taker, from.particles.AsSet(from.ParticleTags), particles.AsSet(ParticleTags), region);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            from.MarkRemoved();
            Resting?.Wake();
        }

        // Either's particles may become the other's: with phases and lifetimes where one of them has some, and as deep.
        void PrepareExchange(PbfSolver neighbor, in TransferRegion region)
        {
            ReserveFor(neighbor, region);
            NeedTransfer(neighbor.Layout.Capacity);
        }

        void ReserveFor(PbfSolver neighbor, in TransferRegion region)
        {
            if (ParticleTags != null || neighbor.ParticleTags != null)
            {
                NeedTags();
                neighbor.NeedTags();
            }
            hasLifetimes |= neighbor.hasLifetimes;
            maxParticles = Layout.Capacity;
            if (!math.all(neighbor.minAdded <= neighbor.maxAdded))
                return;
            float3 a = math.rotate(region.rotation, neighbor.minAdded) + region.offset;
            float3 b = math.rotate(region.rotation, neighbor.maxAdded) + region.offset;
            minAdded = math.min(minAdded, math.clamp(math.min(a, b), 0f, Layout.DomainSize));
            maxAdded = math.max(maxAdded, math.clamp(math.max(a, b), 0f, Layout.DomainSize));
        }

        void MarkRemoved() => markedAfter = stepIndex + 1;

        // Room to take from a set of so many.
        void NeedTransfer(int capacity)
            => (Transfer ?? Keep(Features.Transfer, new ParticleTransfer(ReadbackErrors))).Reserve(capacity);

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
            if (ParticleTags != null)
                kept.NeedTags();
            else if (kept.HasTags)
                NeedTags();
            NeedTransfer(math.max(Layout.Capacity, kept.Capacity));
            ParticleSet fluid = particles.AsSet(ParticleTags);
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
            MarkAdded(Layout.Capacity, minAdded, maxAdded);
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

        // Number of the transfer to it, behind those of what is kept. Of a transfer whose rest is kept no number is read.
        const int HandingOver = Listing + 1;

        /// <summary>Particles of the newest hand-over that the other fluid had no room for and that were not kept, as far as has come
        /// back.</summary>
        public int RefusedToHandOver => Transferred(HandingOver, TransferWord.Held);

        /// <summary>Moves to another fluid, at once, what lies in its box and will lie outside of this one's. Before
        /// <see cref="Shift(float3)"/>.</summary>
        /// <param name="taker">Of the same particle spacing.</param>
        /// <param name="from">Where this box is in world space, m, its lowest corner.</param>
        /// <param name="to">Where it will be, turned as before.</param>
        /// <param name="takersBox">Where the other is.</param>
        /// <param name="keepsRest">Whether what finds no room is kept.</param>
        public void HandOver(PbfSolver taker, in RigidPose from, in RigidPose to, in RigidPose takersBox, bool keepsRest)
        {
            TransferRegion region = RegionOf(from, takersBox, taker.Layout, keepsRest ? Listing : HandingOver);
            region.staysCorner = math.rotate(math.inverse(from.rotation), to.position - from.position) / Layout.Spacing;
            region.staysSize = Layout.DomainSize;
            region.stepsAhead = taker.stepIndex - stepIndex;
            taker.ReserveFor(this, region);
            NeedTransfer(Layout.Capacity);
            using (var cmd = new CommandBuffer { name = "Rill.HandOver" })
            {
                Transfer.Record(cmd, particles.AsSet(ParticleTags), taker.particles.AsSet(taker.ParticleTags), region, TransferRule.Move);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            MarkRemoved();
            taker.MarkAdded(Layout.Capacity, taker.minAdded, taker.maxAdded);
            Transfer.Request();
        }
    }
}
