using Unity.Mathematics;

namespace Rill
{
    /// <summary>Says where particles may be.</summary>
    interface IVolume
    {
        /// <param name="place">Of a particle's center, m, from the middle of the volume in its own frame.</param>
        /// <returns>Whether all of the particle is inside.</returns>
        bool Contains(float3 place);
    }
}
