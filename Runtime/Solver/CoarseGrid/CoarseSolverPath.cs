namespace Rill
{
    /// <summary>Which kernels of CoarseSolver.compute a device runs: those for 1,024 threads and 32 KB of groupshared memory, or the small
    /// ones.</summary>
    readonly struct CoarseSolverPath
    {
        const string File = "CoarseSolver";

        /// <summary>Tiles of 16 KB, which give the same numbers.</summary>
        public readonly bool SmallTiles;
        /// <summary>The last levels in a group of 256 threads and 16 KB.</summary>
        public readonly bool SmallTail;

        public CoarseSolverPath(bool smallTiles, bool smallTail)
        {
            SmallTiles = smallTiles;
            SmallTail = smallTail;
        }

        /// <summary>Each kernel as large as the device holds it.</summary>
        public static CoarseSolverPath For(in DeviceLimits limits)
        {
            bool tiles = limits.Holds(File, "Smooth") && limits.Holds(File, "SmoothWithColliders") && limits.Holds(File, "SmoothLevel");
            return new CoarseSolverPath(!tiles, !limits.Holds(File, "SolveCoarseLevels"));
        }

        /// <summary>Cells of all levels that the tail holds.</summary>
        public int TailCells => SmallTail ? CoarseGrid.SmallTailCells : CoarseGrid.LargeTailCells;

        public string CoarseLevels => SmallTail ? "SolveCoarseLevels" + KernelNeed.Small : "SolveCoarseLevels";

        /// <summary>The name of a kernel that works in tiles.</summary>
        public string Tiled(string kernel) => SmallTiles ? kernel + KernelNeed.Small : kernel;
    }
}
