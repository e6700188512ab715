using System;
using System.Linq;
using UnityEngine.SceneManagement;

namespace Host.Assets
{
    /// <summary>A .unity file opened as a scene that no one has woken yet.</summary>
    internal static class SceneAsset
    {
        /// <param name="scene">"Assets/Scenes/Main.unity", "Scenes/Main" or "Main", as SceneManager.LoadScene takes it.</param>
        /// <returns>The invalid scene when the project has none of that name.</returns>
        public static Scene Load(ProjectAssets project, string scene) =>
            Find(project, scene) is AssetEntry entry ? project.ReadScene(entry) : default;

        static AssetEntry Find(ProjectAssets project, string scene)
        {
            bool Same(string a, string b) => a.Equals(b, StringComparison.OrdinalIgnoreCase);
            var wanted = scene.EndsWith(".unity", StringComparison.OrdinalIgnoreCase) ? scene.Substring(0, scene.Length - 6) : scene;
            // Scenes of the build settings go first, as a name may occur twice in a project.
            var scenes = project.Index.Entries.Where(e => e.Extension == ".unity").OrderBy(e => SceneManager.BuildScenes.Contains(e.Path)
                ? 0 : 1).ToList();
            return scenes.Find(e => Same(WithoutExtension(e), wanted)) ?? scenes.Find(e => Same(WithoutExtension(e), "Assets/" + wanted))
                ?? scenes.Find(e => Same(e.Name, wanted));
        }

        static string WithoutExtension(AssetEntry entry) => entry.Path.Substring(0, entry.Path.Length - 6);
    }
}
