using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The constant buffer RillCoarse of CoarseGrid.hlsl, member by member; lengths in d.</summary>
    [StructLayout(LayoutKind.Sequential)]
    struct CoarseConstants
    {
        public uint3 counts;
        public uint total;
        public float3 inverseSize;
        public float activeCount;
        public float3 coupling;
        public float screening;
        public float inverseVolume;
        public float negativeFraction;
        public float maxFlow;
        public float maxPush;
        public uint levelCount;
        public uint firstTailLevel;
        public float minSurfaceDistance;
        public float maxSurfaceDistance;
        public uint4 level0, level1, level2, level3, level4, level5, level6, level7;

        /// <summary>
        /// Layers of particles across a coarse cell that make it active, whatever its size: with more, thin sheets are left to the
        /// passes, and in cells of 8 d they collapse; with fewer, sheets swell.
        /// </summary>
        const float ActiveLayers = 2f;

        /// <summary>Length ℓ beyond which the potential is screened, d: shorter lets deep water sink, none lets it drift.</summary>
        const float ScreeningLength = 100f;

        /// <summary>Share of a small negative density error that the projection takes up; without it thin layers hover.</summary>
        const float NegativeFraction = 0.3f;

        /// <summary>Longest displacements, d: a lower one of the projection would damp splashes.</summary>
        const float MaxFlow = 40f;
        public const float MaxPush = 2f;

        /// <summary>Nearest and furthest that the free surface lies from the middle of the water in an active cell, in cells.</summary>
        const float MinSurfaceDistance = 0.1f, MaxSurfaceDistance = 1.5f;

        public static CoarseConstants For(CoarseGrid grid)
        {
            float volume = grid.CellSize.x * grid.CellSize.y * grid.CellSize.z;
            return new CoarseConstants
            {
                counts = (uint3)grid.Counts,
                total = (uint)grid.Total,
                inverseSize = 1f / grid.CellSize,
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
                level0 = grid.Level(0),
                level1 = grid.Level(1),
                level2 = grid.Level(2),
                level3 = grid.Level(3),
                level4 = grid.Level(4),
                level5 = grid.Level(5),
                level6 = grid.Level(6),
                level7 = grid.Level(7),
            };
        }
    }
}
