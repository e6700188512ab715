namespace Rill
{
    /// <summary>A neighbor that a fluid takes particles from.</summary>
    struct StepConnection
    {
        public PbfSolver neighbor;
        /// <summary>Transform of the neighbor's particles to this fluid's frame, and which of them are this fluid's.</summary>
        public TransferRegion region;
        /// <summary>Region with both exchanged, for a neighbor that takes as well: before a step of either.</summary>
        public TransferRegion back;
        public bool isMutual;
        /// <summary>Whether nothing is moved: the neighbor's water is on its way to another solver.</summary>
        public bool copiesOnly;
        /// <summary>Number of the frame.</summary>
        public int frame;
    }

    /// <summary>A neighbor that a fluid feels, in any step of a frame.</summary>
    struct StepNeighbor
    {
        public PbfSolver solver;
        /// <summary>Transform of the neighbor's frame to this fluid's, and which side is this fluid's.</summary>
        public TransferRegion region;

        /// <summary>Whether the coarse grid is held to the neighbor's.</summary>
        public bool IsTied => solver.Coarse != null && solver.Coarse.HasFound;
    }

    /// <summary>The neighbors of a fluid in the steps of one frame; used again for every frame.</summary>
    sealed class StepConnections
    {
        public readonly StepConnection[] items = new StepConnection[ParticleTransfer.MaxTransfers];
        public int count;

        /// <summary>All that are felt, also those that have taken for both already.</summary>
        public readonly StepNeighbor[] neighbors = new StepNeighbor[ParticleTransfer.MaxTransfers];
        public int neighborCount;

        /// <summary>Ends of the box that neighbors cover, see SolverConstants.openFaces.</summary>
        public uint OpenFaces
        {
            get
            {
                uint faces = 0;
                for (int n = 0; n < neighborCount; n++)
                    faces |= neighbors[n].region.openFaces * (neighbors[n].IsTied ? 1u + (1u << CoarseConstants.TiedFaces) : 1u);
                return faces;
            }
        }

        public void Clear()
        {
            count = 0;
            neighborCount = 0;
        }

        public void AddNeighbor(in StepNeighbor neighbor) => neighbors[neighborCount++] = neighbor;

        public void Add(in StepConnection connection) => items[count++] = connection;
    }
}
