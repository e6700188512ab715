using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The coarse grid, for all kernels that read it; lengths in d.</summary>
    [GenerateHlsl("CoarseGrid", ConstantBuffer = "RillCoarse")]
    [StructLayout(LayoutKind.Sequential)]
    struct CoarseConstants
    {
        /// <summary>cells along x, y, z</summary>
        public uint3 coarseCounts;
        /// <summary>their product</summary>
        public uint coarseTotal;
        /// <summary>1/d</summary>
        public float3 inverseCoarseSize;
        /// <summary>particles that make a cell active: two layers across it</summary>
        public float activeCount;
        /// <summary>1/size² along each axis, 1/d²</summary>
        public float3 coupling;
        /// <summary>1/ℓ², 1/d²</summary>
        public float screening;
        /// <summary>1/d³</summary>
        public float inverseVolume;
        /// <summary>of a small negative density error that the projection takes up</summary>
        public float negativeFraction;
        /// <summary>longest displacement of the projection, d</summary>
        public float maxFlow;
        /// <summary>longest displacement of the density correction under strong gravity, d</summary>
        public float maxPush;
        /// <summary>levels of the V-cycle below the grid itself</summary>
        public uint levelCount;
        /// <summary>the first of those that one thread group does together</summary>
        public uint firstTailLevel;
        /// <summary>minimum distance of the free surface from the water's center, cells</summary>
        public float minSurfaceDistance;
        /// <summary>maximum of it, cells</summary>
        public float maxSurfaceDistance;
        /// <summary>cells along x, y, z and index of the first; [0] is the grid itself</summary>
        public CoarseLevels levels;

        /// <summary>right-hand side of a cell that is not solved for: its potential is 0</summary>
        [GenerateHlsl("CoarseGrid")] public const float Inactive = 1e30f;

        /// <summary>bit in _OpenFaces of the first end at which a neighbor's solution is known, in the order of the open ones</summary>
        [GenerateHlsl("CoarseGrid")] public const int TiedFaces = 6;

        /// <summary>
        /// Layers of particles across a coarse cell that make it active, whatever its size: with more, thin sheets are left to the
        /// passes, and in cells of 8 d they collapse; with fewer, sheets swell.
        /// </summary>
        const float ActiveLayers = 2f;

        /// <summary>
        /// Length ℓ beyond which the potential is screened, d: shorter lets deep water sink and its waves answer to a weaker gravity, none
        /// lets it drift. See Research~/solver-study.md, "How far the potential reaches".
        /// </summary>
        const float ScreeningLength = 300f;

        /// <summary>Fraction of a small negative density error that the projection takes up; without it thin layers hover.</summary>
        const float NegativeFraction = 0.3f;

        /// <summary>Longest displacements, d: a lower one of the projection would damp splashes.</summary>
        const float MaxFlow = 40f;
        public const float MaxPush = 2f;

        /// <summary>Minimum and maximum distance of the free surface from the center of the water in an active cell, in cells.</summary>
        const float MinSurfaceDistance = 0.1f, MaxSurfaceDistance = 1.5f;

        public static CoarseConstants For(CoarseGrid grid)
        {
            float volume = grid.CellSize.x * grid.CellSize.y * grid.CellSize.z;
            return new CoarseConstants
            {
                coarseCounts = (uint3)grid.Counts,
                coarseTotal = (uint)grid.Total,
                inverseCoarseSize = 1f / grid.CellSize,
                activeCount = math.ceil(ActiveLayers * math.pow(volume, 2f / 3f) - 0.01f),     // rounding shall not decide
                coupling = 1f / (grid.CellSize * grid.CellSize),
                screening = 1f / (ScreeningLength * ScreeningLength),
                inverseVolume = 1f / volume,
                negativeFraction = NegativeFraction,
                maxFlow = MaxFlow,
                maxPush = MaxPush,
                levelCount = (uint)grid.LevelCount,
                firstTailLevel = (uint)grid.FirstTailLevel,
                minSurfaceDistance = MinSurfaceDistance,
                maxSurfaceDistance = MaxSurfaceDistance,
                levels = new CoarseLevels
                {
                    level0 = grid.Level(0),
                    level1 = grid.Level(1),
                    level2 = grid.Level(2),
                    level3 = grid.Level(3),
                    level4 = grid.Level(4),
                    level5 = grid.Level(5),
                    level6 = grid.Level(6),
                    level7 = grid.Level(7),
                },
            };
        }
    }

    /// <summary>The levels of a <see cref="CoarseGrid"/>, <see cref="CoarseGrid.MaxLevels"/> of them: an array to the shaders.</summary>
    struct CoarseLevels
    {
        public uint4 level0, level1, level2, level3, level4, level5, level6, level7;
    }
}
