using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host.Assets
{
    /// <summary>Changes of the player by a project's ProjectSettings folder: color space, names, time step, physics, scenes of the
    /// build, preloaded assets.</summary>
    internal static class ProjectSettings
    {
        /// <param name="exists">Whether an asset path leads to a file; scenes that do not are not in the build.</param>
        public static void Apply(string root, Func<string, bool> exists)
        {
            Player.ProjectPath = root;
            SceneManager.BuildScenes.Clear();

            if (Settings(root, "ProjectSettings") is YamlNode player)
            {
                Player.LinearColorSpace = player.Int("m_ActiveColorSpace") == 1;
                Player.ProductName = player.Text("productName", Player.ProductName);
                Player.CompanyName = player.Text("companyName", Player.CompanyName);
            }
            if (Settings(root, "TimeManager") is YamlNode time)
            {
                Time.fixedDeltaTime = time.Float("Fixed Timestep", Time.fixedDeltaTime);
                Time.maximumDeltaTime = time.Float("Maximum Allowed Timestep", Time.maximumDeltaTime);
                Time.timeScale = time.Float("m_TimeScale", Time.timeScale);
            }
            PhysicsWorld.Install();
            if (Settings(root, "DynamicsManager") is YamlNode physics)
                PhysicsSettings.Apply(physics);
            SceneManager.BuildScenes.AddRange(BuildScenes(root).Where(exists));
        }

        /// <summary>The paths of the scenes in the build, whether they are there or not.</summary>
        public static IEnumerable<string> BuildScenes(string root) =>
            Settings(root, "EditorBuildSettings") is YamlNode build ? build.Items("m_Scenes").Where(s => s.Bool("enabled"))
            .Select(s => s.Text("path")) : Enumerable.Empty<string>();

        /// <summary>Objects that a player loads before the first scene, without empty entries.</summary>
        public static IEnumerable<FileReference> PreloadedAssets(string root) =>
            Settings(root, "ProjectSettings") is YamlNode player ? player.Items("preloadedAssets").Select(FileReference.Of).Where(r => !r.IsNone)
            : Enumerable.Empty<FileReference>();

        static YamlNode Settings(string root, string name)
        {
            var file = Path.Combine(root, "ProjectSettings", name + ".asset");
            return File.Exists(file) ? UnityYaml.Load(file, $"ProjectSettings/{name}.asset").Documents[0].Fields : null;
        }
    }
}
