using Unity.Collections;

namespace Rill
{
    /// <summary>Foam of a fluid, counted on the GPU and brought back a few frames later.</summary>
    public struct FoamStatistics
    {
        /// <summary>Particles in the air, on the water and in it.</summary>
        public int spray, foam, bubbles;
        /// <summary>Particles made since the last restart. Those of a kind that is not wanted count too.</summary>
        public long spawned;
        /// <summary>Particles that found no room in the budget since the last restart.</summary>
        public long refused;

        /// <summary>All that are there.</summary>
        public int Particles => spray + foam + bubbles;

        internal static FoamStatistics From(NativeArray<uint> block)
        {
            return new FoamStatistics
            {
                spray = (int)block[(int)FoamCounter.Spray],
                foam = (int)block[(int)FoamCounter.Foam],
                bubbles = (int)block[(int)FoamCounter.Bubbles],
                spawned = block[(int)FoamCounter.Spawned],
                refused = block[(int)FoamCounter.Refused],
            };
        }
    }
}
