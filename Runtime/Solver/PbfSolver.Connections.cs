using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What goes to neighbors whose boxes overlap, and what is felt of them. Once a frame each takes the particles that crossed to its side,
    // and copies those that are left in its box as ghosts, which take part in the steps of that frame.
    partial class PbfSolver
    {
        ParticleTransfer transfer;
        bool hasGhosts;         // since the last removal
        int ghostFrame;         // in which they came

        ParticleTransfer Transfer => transfer ??= new ParticleTransfer(ReadbackErrors);

        /// <summary>Particles of which transfer number it took how many, as far as has come back.</summary>
        public int Transferred(int number, TransferWord word) => transfer?.Latest(number, word) ?? 0;

        /// <summary>Starts the readback of what was taken from neighbors.</summary>
        public void RequestTransferred() => transfer?.Request();

        /// <summary>The number goes to another: nothing was transferred under it.</summary>
        public void ResetTransfer(int number) => transfer?.Reset(number);

        /// <summary>Whether the state is a snapshot's, and no step was taken from it.</summary>
        public bool IsRestored => isRestored;

        /// <summary>As two fluids are connected, at once: each gets what lies on its side, and of what both were filled with one is
        /// removed. Before a step of either.</summary>
        public static void PartFrom(PbfSolver one, in TransferRegion toOne, PbfSolver other, in TransferRegion toOther)
        {
            one.TakeApart(other, toOne);
            other.TakeApart(one, toOther);
        }

        /// <summary>Whether there are ghosts that no step has removed.</summary>
        public bool HasGhosts => hasGhosts;

        /// <summary>Records the removal of the ghosts, after what looks at the lists of the last step.</summary>
        public void RecordGhostRemoval(CommandBuffer cmd)
        {
            if (!hasGhosts)
                return;
            hasGhosts = false;
            Transfer.RecordRemoval(cmd, particles.AsSet(tags));
            NoteGone();
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
                Meet(connection.neighbor, connection.region);
                if (connection.isMutual)
                    connection.neighbor.Meet(this, connection.back);
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
            Transfer.Record(cmd, neighbor.particles.AsSet(neighbor.tags), particles.AsSet(tags), region, rule);
            if (copies)
                hasGhosts = true;
            else
                neighbor.NoteGone();
        }

        void TakeApart(PbfSolver from, in TransferRegion region)
        {
            PrepareConstants();
            Meet(from, region);
            using (var cmd = new CommandBuffer { name = "Rill.Connect" })
            {
                StepContext taker = BetweenSteps(cmd);
                neighborSearch.RecordOrderAtRest(taker);
                Transfer.RecordApart(taker, from.particles.AsSet(from.tags), particles.AsSet(tags), region);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            from.NoteGone();
            restingRegions?.Wake();
        }

        // Either's particles may become the other's: with phases and lifetimes where one of them has some, and as deep.
        void Meet(PbfSolver neighbor, in TransferRegion region)
        {
            Expect(neighbor, region);
            Transfer.Reserve(neighbor.Layout.Capacity);
        }

        void Expect(PbfSolver neighbor, in TransferRegion region)
        {
            if (tags != null || neighbor.tags != null)
            {
                tags ??= new ParticleTags(Layout.Capacity);
                neighbor.tags ??= new ParticleTags(neighbor.Layout.Capacity);
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

        void NoteGone() => markedAfter = stepIndex + 1;

        void ReleaseConnections()
        {
            transfer?.Dispose();
            transfer = null;
            hasGhosts = false;
        }
    }
}
