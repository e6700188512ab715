namespace Rill
{
    /// <summary>A neighbor that a fluid takes particles from.</summary>
    struct StepConnection
    {
        public PbfSolver neighbor;
        /// <summary>Where the neighbor's particles are in this fluid's frame, and which of them are this fluid's.</summary>
        public TransferRegion region;
        /// <summary>The same the other way round, where the neighbor takes as well: before a step of either.</summary>
        public TransferRegion back;
        public bool isMutual;
        /// <summary>Number of the frame.</summary>
        public int frame;
    }

    /// <summary>The neighbors of a fluid in one step; used again for every step.</summary>
    sealed class StepConnections
    {
        public readonly StepConnection[] items = new StepConnection[ParticleTransfer.MaxTransfers];
        public int count;

        /// <summary>Whether there is a neighbor, also one that has taken for both already.</summary>
        public bool isOpen;

        /// <summary>Ends of the box that neighbors cover, see StepInput.openFaces.</summary>
        public uint openFaces;

        public void Clear()
        {
            count = 0;
            openFaces = 0;
            isOpen = false;
        }

        public void Add(in StepConnection connection) => items[count++] = connection;
    }
}
