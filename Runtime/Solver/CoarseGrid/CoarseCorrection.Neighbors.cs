using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Couples the coarse grids of fluids whose boxes overlap: each holds its potential to the other's beyond its own side. So the
    // water on both sides of an opening is moved by what is nearly one solution, as in the alternating method of Schwarz, a pass a substep.
    partial class CoarseCorrection
    {
        readonly Kernel takePotential;

        /// <summary>Neighbors whose solution is taken.</summary>
        static int CountTied(StepConnections connections)
        {
            int count = 0;
            for (int n = 0; n < (connections?.neighborCount ?? 0); n++)
                if (connections.neighbors[n].IsTied)
                    count++;
            return count;
        }

        /// <summary>Whether the flow has been solved for: another fluid can take what was found.</summary>
        public bool HasFound => FlowTime > 0f;

        /// <summary>Length of the substep that the flow's potential is of, s; 0 before the first. A neighbor depends on it.</summary>
        public float FlowTime { get; set; }

        // Takes the flow's potentials of all neighbors, or those of the errors.
        void RecordNeighbors(in StepContext step, bool ofFlow)
        {
            StepConnections connections = step.Input.connections;
            for (int n = 0; n < (connections?.neighborCount ?? 0); n++)
            {
                if (!connections.neighbors[n].IsTied)
                    continue;
                CoarseCorrection other = connections.neighbors[n].solver.Coarse;
                // The flow's is a displacement within a substep, which grows with its square.
                float ratio = ofFlow ? step.SubstepTime / other.FlowTime : 1f;
                RecordTake(step.Commands, connections.neighbors[n].region, other, ofFlow ? other.flowPotential : other.errorPotential,
                    ofFlow ? flowPotential : errorPotential, ratio * ratio);
            }
        }

        /// <summary>Records that a potential takes a neighbor's on the neighbor's side of the overlap.</summary>
        /// <param name="region">What comes from the neighbor.</param>
        /// <param name="from">The neighbor's potential.</param>
        /// <param name="to">This one's.</param>
        /// <param name="scale">This one's potentials of one there.</param>
        public void RecordTake(CommandBuffer cmd, in TransferRegion region, CoarseCorrection other, GraphicsBuffer from, GraphicsBuffer to,
            float scale)
        {
            Neighbor.Bind(cmd, shader, takePotential, from, to, region.offset, new float4(1f / other.Grid.CellSize, scale),
                (float3)other.Grid.Counts, region.plane);
            Dispatch(cmd, takePotential);
        }

        static readonly ShaderParameters Neighbor = new ShaderParameters(
            "_NeighborPotential", "_Potential", "_NeighborOffset", "_NeighborInverseSize", "_NeighborCounts", "_OwnSide");
    }
}
