using System;
using System.IO;
using System.Linq;
using Host.Check;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The rules about compiled code see what is planted in this assembly, which stands here for a package's.</summary>
    public class CheckCodeTests
    {
        string folder;

        [SetUp]
        public void GiveOutThisAssemblyAsAPackage()
        {
            folder = Path.Combine(Path.GetTempPath(), "rill-check-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
            File.Copy(typeof(CheckCodeTests).Assembly.Location, Path.Combine(folder, "Planted.dll"));
            File.WriteAllText(Path.Combine(folder, "Planted.asmdef"), "{ \"name\": \"Planted\" }");
        }

        [TearDown]
        public void RemoveIt() => Directory.Delete(folder, true);

        [TestCase("ReadsBack", "GraphicsBuffer.GetData", "waits for the GPU")]
        [TestCase("Waits", "AsyncGPUReadbackRequest.WaitForCompletion", "waits for the GPU")]
        [TestCase("Searches", "GameObject.Find", "scene")]
        [TestCase("Queries", "Enumerable.Sum", "LINQ allocates")]
        [TestCase("MakesTexture", "RenderTexture..ctor", "has the format")]
        public void A_call_that_stalls_a_frame_is_named_with_its_caller(string method, string called, string why)
        {
            Findings findings = Examine(new FrameCallsRule());
            Assert.That(findings.Faults, Has.Some.Contains($"PlantedFaults.{method} calls {called}, which ").And.Contains(why));
        }

        [Test]
        public void What_the_list_allows_and_no_one_does_is_told()
            => Assert.That(Examine(new FrameCallsRule()).Faults, Has.Some.Contains("Readback.Complete no longer calls WaitForCompletion"));

        [TestCase("counter")]
        [TestCase("cache")]
        [TestCase("Instance")]
        [TestCase("resetTooLate")]
        public void A_static_that_outlives_play_mode_is_named(string field)
            => Assert.That(Examine(new StaticsRule()).Faults, Has.Some.Match($"PlantedFaults\\..*{field}.* is a static that can change"));

        [TestCase("reset")]
        [TestCase("lookup")]
        [TestCase("Limit")]
        [TestCase("id")]
        [TestCase("Label")]
        public void A_static_that_is_reset_or_constant_is_none(string field)
            => Assert.That(Examine(new StaticsRule()).Faults, Has.None.Contains($"PlantedFaults.{field} "));

        [Test]
        public void An_assembly_that_was_not_built_is_a_fault()
        {
            File.Delete(Path.Combine(folder, "Planted.dll"));
            Assert.That(Examine(new StaticsRule()).Faults, Has.Some.Contains("Planted.dll is not there"));
        }

        Findings Examine(Rule rule) => rule.Examine(new PackageTree(folder, folder));
    }

    [System.AttributeUsage(System.AttributeTargets.Field)]
    sealed class KeptBetweenPlaysAttribute : System.Attribute { }

    static class PlantedFaults
    {
        static int counter;
        static readonly System.Collections.Generic.List<int> cache = new System.Collections.Generic.List<int>();
        static object Instance { get; set; }
        static int resetTooLate;
        static int reset;
        [KeptBetweenPlays] static object lookup;
        const int Limit = 3;
        static readonly int id = Shader.PropertyToID("_Planted");
        static readonly string Label = "label";

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset() => reset = Limit;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.AfterSceneLoad)]
        static void ResetLate() => resetTooLate = 0;

        static void ReadsBack(GraphicsBuffer buffer) => buffer.GetData(new int[1]);
        static void Waits(AsyncGPUReadbackRequest request) => request.WaitForCompletion();
        static void Searches() => Instance = GameObject.Find("Fluid");
        static RenderTexture MakesTexture() => new RenderTexture(1, 1, 0, RenderTextureFormat.RHalf);
        static void Install() => lookup = new object();
        static int Queries() => (lookup == null ? 0 : 1) + cache.Sum() + counter++ + resetTooLate + reset + id + Label.Length;
    }
}
