using UnityEngine;

namespace Rill
{
    /// <summary>Lets fluids take Terrain Colliders by layer.</summary>
    static class TerrainGroundHook
    {
        /// <summary>Runs as play begins, and in the Editor as scripts are loaded.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void Install() => ColliderGround.Find = Find;

        static IColliderGround Find(Collider collider) => collider is TerrainCollider terrain ? new TerrainColliderGround(terrain) : null;
    }
}
