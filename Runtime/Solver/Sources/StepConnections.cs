using Unity.Mathematics;

namespace Rill
{
    /// <summary>A neighbor that a fluid takes particles from.</summary>
    struct StepConnection
    {
        public PbfSolver neighbor;
        /// <summary>Where the neighbor's particles are in this fluid's frame, and which of them are this fluid's.</summary>
        public TransferRegion region;
    }

    /// <summary>The neighbors of a fluid in one step; used again for every step.</summary>
    sealed class StepConnections
    {
        public readonly StepConnection[] items = new StepConnection[ParticleTransfer.MaxTransfers];
        public int count;

        /// <summary>Ends of the box that neighbors cover, see StepInput.openFaces.</summary>
        public uint openFaces;

        public void Clear()
        {
            count = 0;
            openFaces = 0;
        }

        public void Add(in StepConnection connection)
        {
            items[count++] = connection;
            openFaces |= connection.region.openFaces;
        }
    }
}
