using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Projects that use the package from its source.</summary>
    public class PackageProjectTests
    {
        [Test]
        public void The_package_plays_in_a_project_that_refers_to_its_folder()
        {
            using var run = new ForeignRun(Path.Combine(PackageFolder.Path, "TestProject~"), 2, "Dam Break", "--size", "160x90");
            run.MustHaveSucceeded();
            Assert.That(run.Output.First(), Does.Match(@"^Rill: (\d+) of \1 scripts compiled$"));
            Assert.That(run.Errors.Where(line => line.StartsWith("error", StringComparison.Ordinal)), Is.Empty);
        }

        /// <summary>The manifest of Pool asks for the package by a git address; its tests use the package's assertions.</summary>
        [Test]
        public void The_tests_of_a_project_run_over_the_package_at_hand()
        {
            var run = new ProjectRun(Path.Combine(PackageFolder.Tests, "Projects", "Pool"));
            run.MustHaveEnded(1, "FAILED A_pool_too_small_for_its_water_loses_some",
                "were refused, since the capacity is 100: raise it or add less.", "3 passed, 1 failed");
            Assert.That(run.Output.First(line => line.StartsWith("Rill: ")), Does.Match(@"^Rill: (\d+) of \1 scripts compiled$"));
            Assert.That(run.Errors, Has.Some.StartsWith("warning: the package com.rill.fluids is taken from ").And.Some.Contains(
                "packages that are not here: com.unity.ide.rider 3.0.24"));
            Assert.That(run.Errors.Where(line => line.Contains("left out")), Is.Empty);
            Assert.That(run.Everything, Does.Contain("PoolTests.cs:line"));
        }

        /// <summary>Imports it like the Package Manager, into Assets/Samples. The longer tests of it are run with those of the host.</summary>
        [Test]
        public void The_tests_of_a_sample_run_in_a_project_that_imports_it()
        {
            string project = Path.Combine(Path.GetTempPath(), "rill-imported-" + Guid.NewGuid().ToString("N"));
            try
            {
                Import("Key in a Well", project);
                new ProjectRun(project, "--filter", "A_restart_brings_back_the_very_start").MustHaveEnded(0, "1 passed, 0 failed");
            }
            finally
            {
                Directory.Delete(project, recursive: true);
            }
        }

        /// <summary>The remedy that the error names.</summary>
        [TestCase(true)]
        [TestCase(false)]
        public void A_fluid_that_a_script_makes_in_a_player_has_its_shaders_from_the_preloaded_assets(bool preloads)
        {
            string project = Path.Combine(Path.GetTempPath(), "rill-preloads-" + Guid.NewGuid().ToString("N"));
            try
            {
                Import("Still Pool", project);
                string settings = preloads ? "  preloadedAssets:\n  - {fileID: 11400000, guid: " + GuidOf("Runtime/FluidShaders.asset") +
                    ", type: 2}\n"
                    : "  preloadedAssets: []\n";
                File.WriteAllText(Path.Combine(project, "ProjectSettings", "ProjectSettings.asset"),
                    "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!129 &1\nPlayerSettings:\n" + settings);
                File.WriteAllText(Path.Combine(project, "Assets", "Game.cs"), @"
using Rill;
using UnityEngine;
public class Game : MonoBehaviour
{
    FluidSimulation fluid;
    [RuntimeInitializeOnLoadMethod] static void Begin() => new GameObject(""Game"").AddComponent<Game>();
    void Start()
    {
        foreach (FluidSimulation other in FindObjectsOfType<FluidSimulation>()) DestroyImmediate(other.gameObject);
        var pool = new GameObject(""Made"");
        pool.SetActive(false);
        fluid = pool.AddComponent<FluidSimulation>();
        fluid.Configure(Vector3.one, 0.1f, 1000);
        pool.AddComponent<FluidVolume>().Size = Vector3.one * 0.5f;
        pool.AddComponent<FluidPhysicsColliders>().ColliderLayers = 1;
        pool.SetActive(true);
    }
    void Update()
    {
        if (Time.frameCount == 10) Debug.Log(fluid.FluidTime > 0 ? ""the water moves"" : ""the water stands"");
    }
}");
                using var run = new ForeignRun(project, 12, "StillPool", "--no-frames");
                Assert.That(run.Everything, Does.Contain(preloads ? "the water moves" : "Preloaded Assets of the player settings"));
                Assert.That(run.ExitCode, Is.EqualTo(preloads ? 0 : 1), run.Everything);
            }
            finally
            {
                Directory.Delete(project, recursive: true);
            }
        }

        static string GuidOf(string asset) => File.ReadLines(Path.Combine(PackageFolder.Path, asset + ".meta"))
            .Single(line => line.StartsWith("guid: ", StringComparison.Ordinal)).Substring("guid: ".Length);

        /// <summary>So small a game can be read in one go. Its tests do not count.</summary>
        [Test]
        public void The_scripts_of_the_sample_game_stay_below_300_lines_in_all()
        {
            string game = Path.Combine(PackageFolder.Path, "Samples~", "Key in a Well");
            string[] scripts = Directory.GetFiles(game, "*.cs");
            Assert.That(scripts, Has.Length.GreaterThanOrEqualTo(4));
            Assert.That(Directory.GetFiles(game, "*.cs", SearchOption.AllDirectories).Except(scripts).Select(Path.GetDirectoryName).Distinct(),
                Is.EqualTo(new[] { Path.Combine(game, "Tests") }), "others that would not be counted");
            Assert.That(scripts.Sum(script => File.ReadLines(script).Count()), Is.InRange(100, 299));
        }

        static void Import(string sample, string project)
        {
            string from = Path.Combine(PackageFolder.Path, "Samples~", sample), to = Path.Combine(project, "Assets", "Samples", sample);
            foreach (string file in Directory.GetFiles(from, "*", SearchOption.AllDirectories))
            {
                string copy = Path.Combine(to, Path.GetRelativePath(from, file));
                Directory.CreateDirectory(Path.GetDirectoryName(copy));
                File.Copy(file, copy);
            }
            foreach (string folder in new[] { "Packages", "ProjectSettings" })
                Directory.CreateDirectory(Path.Combine(project, folder));
            File.WriteAllText(Path.Combine(project, "ProjectSettings", "ProjectVersion.txt"), "m_EditorVersion: 2022.3.0f1\n");
            File.WriteAllText(Path.Combine(project, "Packages", "manifest.json"), "{ \"dependencies\": { \"com.rill.fluids\": \"file:" +
                PackageFolder.Path.Replace('\\', '/') + "\", \"com.unity.mathematics\": \"1.2.6\", \"com.unity.modules.physics\": " +
                "\"1.0.0\", \"com.unity.test-framework\": \"1.1.33\" } }");
        }
    }
}
