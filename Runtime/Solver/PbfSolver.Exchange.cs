using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Particles that change fluids, in three cases. Neighbors whose boxes overlap: once a frame each fluid takes the particles that crossed to
    // its side, and copies those that are left in its box as ghosts, which take part in the steps of that frame. A box that moves: it leaves
    // particles outside, where they stay until it covers them again. A hand-over: particles move to another fluid at once.
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

        /// <summary>Splits the water of two fluids that are being connected, at once: each gets the particles on its side, and one of two fillings
        /// that overlap is removed. To be called before a step of either.</summary>
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

        // Removes the ghosts of neighbors that took no step since.
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
            Wake();
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

        // Reserves room to take from a set of that capacity.
        void NeedTransfer(int capacity)
            => (Transfer ?? Keep(Features.Transfer, new ParticleTransfer(ReadbackErrors))).Reserve(capacity);

        // Numbers of the transfers out of the box, back into it, and to its new frame, after those from neighbors.
        const int Leaving = ParticleTransfer.MaxTransfers, Returning = Leaving + 1, Listing = Leaving + 2;

        OutsideParticles outside;

        /// <summary>Whether particles may be outside.</summary>
        public bool KeepsOutside => outside != null;

        /// <summary>Number of particles outside, as far as it was read back.</summary>
        public int OutsideCount => Transferred(Leaving, TransferWord.Handed) - Transferred(Returning, TransferWord.Handed);

        /// <summary>Number of particles of the newest move that had no room outside and were removed, as far as it was read back.</summary>
        public int OutsideOverflow => Transferred(Leaving, TransferWord.Held);

        /// <summary>Moves the particles outside along with a box that is put elsewhere.</summary>
        /// <param name="from">Former pose of the box in world space, m, at its lowest corner.</param>
        /// <param name="to">New pose of the box.</param>
        public void TeleportOutside(in RigidPose from, in RigidPose to) => outside?.Teleport(from, to);

        /// <summary>Moves the box and leaves the particles where they are in the world, at once: those outside are kept up to a number, and
        /// those that it then covers come back.</summary>
        /// <param name="from">Former pose of the box in world space, m, at its lowest corner.</param>
        /// <param name="to">New pose of the box, with the same rotation.</param>
        /// <param name="maxOutside">Maximum number of particles outside; those that are there already stay.</param>
        /// <param name="keeps">False removes those that leave.</param>
        public void Shift(in RigidPose from, in RigidPose to, int maxOutside, bool keeps)
        {
            PrepareConstants();
            if (keeps && outside == null)
                outside = new OutsideParticles(maxOutside, from);
            if (ParticleTags != null)
                outside.NeedTags();
            else if (outside.HasTags)
                NeedTags();
            NeedTransfer(math.max(Layout.Capacity, outside.Capacity));
            ParticleSet fluid = particles.AsSet(ParticleTags);
            using (var cmd = new CommandBuffer { name = "Rill.Keep" })
            {
                // To the frame of the box as it will be. What it will not cover goes first: that is outside already.
                Transfer.Record(cmd, outside.Set, outside.Next, RegionOf(outside.Box, to, Listing), TransferRule.Outside | TransferRule.KeepsIds);
                if (keeps)
                    Transfer.Record(cmd, fluid, outside.Next, RegionOf(from, to, Leaving), TransferRule.Outside | TransferRule.KeepsIds);
                Graphics.ExecuteCommandBuffer(cmd);
                cmd.Clear();
                Shift(math.rotate(math.inverse(to.rotation), from.position - to.position) / Layout.Spacing);
                Transfer.Record(cmd, outside.Set, fluid, RegionOf(outside.Box, to, Returning), TransferRule.KeepsIds);
                // Particles that came to a full box wait for the next move.
                Transfer.Record(cmd, outside.Set, outside.Next, RegionOf(outside.Box, to, Listing), TransferRule.All | TransferRule.KeepsIds);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            outside.Advance(to);
            MarkAdded(Layout.Capacity, minAdded, maxAdded);
            Transfer.Request();
        }

        void RemoveOutside()
        {
            if (outside == null)
                return;
            ReleaseOutside();
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

        void ReleaseOutside()
        {
            outside?.Dispose();
            outside = null;
        }

        // Number of the transfer to another fluid, after those of the particles outside. A transfer whose rest is kept reads no number.
        const int HandingOver = Listing + 1;

        /// <summary>Particles of the newest hand-over that the other fluid had no room for and that were not kept, as far as has come
        /// back.</summary>
        public int RefusedToHandOver => Transferred(HandingOver, TransferWord.Held);

        /// <summary>Moves to another fluid, at once, what lies in its box and will lie outside of this one's. Before
        /// <see cref="Shift(float3)"/>.</summary>
        /// <param name="taker">Fluid that takes, with the same particle spacing.</param>
        /// <param name="from">Pose of this box in world space, m, at its lowest corner.</param>
        /// <param name="to">Pose to which it moves, with the same rotation.</param>
        /// <param name="takersBox">Pose of the other box.</param>
        /// <param name="keepsRest">Whether what finds no room stays outside, see <see cref="Shift(in RigidPose, in RigidPose, int, bool)"/>.</param>
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
