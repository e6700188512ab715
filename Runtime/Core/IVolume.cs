using Unity.Mathematics;

namespace Rill
{
    /// <summary>Tells at which positions particles may be.</summary>
    interface IVolume
    {
        /// <param name="position">Center of a particle, m, from the center of the volume in its own frame.</param>
        /// <returns>Whether all of the particle is inside.</returns>
        bool Contains(float3 position);
    }
}
