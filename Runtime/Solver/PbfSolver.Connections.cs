using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What goes to neighbors whose boxes overlap, and what is felt of them. Once a frame each takes the particles that crossed to its side,
    // and copies those that are left in its box as ghosts, which take part in the steps of that frame.
    sealed partial class PbfSolver
    {
        ParticleTransfer transfer;
        bool hasGhosts;         // since the last removal

        ParticleTransfer Transfer => transfer ??= new ParticleTransfer();

        /// <summary>Particles of which transfer number it took how many, as far as has come back.</summary>
        public int Transferred(int number, TransferWord word) => transfer?.Latest(number, word) ?? 0;

        /// <summary>Starts the readback of what was taken from neighbors.</summary>
        public void RequestTransferred() => transfer?.Request();

        /// <summary>The number goes to another: nothing was transferred under it.</summary>
        public void ForgetTransfer(int number) => transfer?.Forget(number);

        /// <summary>Whether the state is a snapshot's, and no step was taken from it.</summary>
        public bool IsRestored => isRestored;

        /// <summary>As two fluids are connected, at once: each gets what lies on its side, and of what both were filled with one is
        /// removed. Before a step of either.</summary>
        public static void PartFrom(PbfSolver one, in TransferRegion toOne, PbfSolver other, in TransferRegion toOther)
        {
            one.TakeApart(other, toOne);
            other.TakeApart(one, toOther);
        }

        /// <summary>Records the removal of the ghosts, after what looks at the lists of the last step.</summary>
        public void RecordGhostRemoval(CommandBuffer cmd)
        {
            if (!hasGhosts)
                return;
            hasGhosts = false;
            Transfer.RecordRemoval(cmd, particles.AsSet(tags));
            markedAfter = stepIndex + 1;
        }

        void PrepareConnections(StepConnections connections)
        {
            if (connections == null)
                return;
            for (int c = 0; c < connections.count; c++)
                Meet(connections.items[c].neighbor, connections.items[c].region);
        }

        void RecordConnections(in StepContext step)
        {
            StepConnections connections = step.Input.connections;
            if (connections == null)
                return;
            for (int c = 0; c < connections.count; c++)
            {
                ref StepConnection connection = ref connections.items[c];
                ParticleSet from = connection.neighbor.particles.AsSet(connection.neighbor.tags);
                Transfer.Record(step.Commands, from, particles.AsSet(tags), connection.region, TransferRule.Move);
                connection.neighbor.NoteGone();
            }
            // After all of what is this fluid's: a ghost of one neighbor may be another's particle.
            for (int c = 0; c < connections.count; c++)
            {
                ref StepConnection connection = ref connections.items[c];
                TransferRegion whole = connection.region;
                whole.plane = 0f;
                ParticleSet from = connection.neighbor.particles.AsSet(connection.neighbor.tags);
                Transfer.Record(step.Commands, from, particles.AsSet(tags), whole, TransferRule.Copies);
            }
            hasGhosts = connections.count > 0;
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
            if (tags != null || neighbor.tags != null)
            {
                tags ??= new ParticleTags(Layout.Capacity);
                neighbor.tags ??= new ParticleTags(neighbor.Layout.Capacity);
            }
            hasLifetimes |= neighbor.hasLifetimes;
            Transfer.Reserve(neighbor.Layout.Capacity);
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
