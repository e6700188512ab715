using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Lets fluids that run without Play take Terrain Colliders by layer.</summary>
    static class TerrainGroundInstaller
    {
        [InitializeOnLoadMethod]
        static void Install() => TerrainGroundHook.Install();
    }
}
