using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.Loader;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>A player whose code is stripped at the strictest keeps all that the engine calls by attribute alone.</summary>
    public class LinkedPlayerTests
    {
        const string Terrain = "Rill.TerrainPhysics: Rill.TerrainGroundHook.Install",
            Universal = "Rill.Universal: Rill.Universal.UniversalSurfaces.Listen",
            HighDefinition = "Rill.HighDefinition: Rill.HighDefinition.HighDefinitionSurfaces.Listen";

        readonly Dictionary<string, LinkedPlayer> players = new();

        [OneTimeTearDown]
        public void RemovePlayers()
        {
            foreach (LinkedPlayer player in players.Values)
                player.Dispose();
        }

        [TestCase("Dam Break", "universal", Universal)]
        [TestCase("Honey", "high-definition", HighDefinition)]
        [TestCase("Key in a Well", "universal", Terrain)]
        public void Every_hook_is_left_in_a_player_of_a_sample(string sample, string pipeline, string hook)
        {
            LinkedPlayer player = Link(sample, pipeline);
            Assert.That(player.Hooks, Does.Contain(hook).And.Count.GreaterThanOrEqualTo(12));
            Assert.That(player.HooksLeft(), Is.EqualTo(player.Hooks));
            Assert.That(new FileInfo(player.Find("Rill")).Length, Is.LessThan(new FileInfo(typeof(FluidSimulation).Assembly.Location).Length),
                "something was stripped");
        }

        [TestCase("Key in a Well", "universal", new[] { "Rill.TerrainPhysics", "Rill.Universal" }, new[] { Terrain, Universal })]
        [TestCase("Honey", "high-definition", new[] { "Rill.HighDefinition" }, new[] { HighDefinition })]
        public void Without_the_assembly_s_attribute_its_hook_is_dropped(string sample, string pipeline, string[] assemblies, string[] hooks)
        {
            using (var player = new LinkedPlayer(sample, Find(pipeline), assemblies))
            {
                Assert.That(assemblies.Select(player.Find), Is.All.Null);
                Assert.That(player.HooksLeft(), Is.EqualTo(player.Hooks.Except(hooks)));
            }
        }

        [Test]
        public void The_hooks_that_are_left_do_their_work()
        {
            var code = new LinkedCode(Link("Key in a Well", "universal"));
            code.Call(Terrain);
            Assert.That(code["Rill.Physics"].GetType("Rill.ColliderGround", true).GetProperty("Find", LinkedCode.Any).GetValue(null), Is.Not.Null);

            FieldInfo begin = typeof(RenderPipelineManager).GetField(nameof(RenderPipelineManager.beginCameraRendering), LinkedCode.Any);
            FieldInfo end = typeof(RenderPipelineManager).GetField(nameof(RenderPipelineManager.endCameraRendering), LinkedCode.Any);
            (object begun, object ended) = (begin.GetValue(null), end.GetValue(null));
            try
            {
                code.Call(Universal);
                Assert.That(((Delegate)begin.GetValue(null)).GetInvocationList().Select(call => call.Method.Module.Assembly),
                    Does.Contain(code["Rill.Universal"]));
            }
            finally
            {
                begin.SetValue(null, begun);
                end.SetValue(null, ended);
            }
        }

        LinkedPlayer Link(string sample, string pipeline)
        {
            if (!players.TryGetValue(sample, out LinkedPlayer player))
                players.Add(sample, player = new LinkedPlayer(sample, Find(pipeline)));
            return player;
        }

        static PipelineKind Find(string name) => PipelineKind.All.Single(kind => kind.Name == name);

        /// <summary>The linked assemblies beside those of this process, over the same engine.</summary>
        sealed class LinkedCode : AssemblyLoadContext
        {
            public const BindingFlags Any = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

            readonly LinkedPlayer player;
            readonly Dictionary<string, Assembly> pipeline;

            public LinkedCode(LinkedPlayer player)
            {
                this.player = player;
                pipeline = PipelineAssemblies.Of(PipelineVersion.Find("17")).Images
                    .ToDictionary(stand => stand.Key, stand => LoadFromStream(new MemoryStream(stand.Value)));
            }

            public Assembly this[string name] => LoadFromAssemblyName(new AssemblyName(name));

            public void Call(string hook)
            {
                string[] parts = hook.Split(": ");
                int dot = parts[1].LastIndexOf('.');
                this[parts[0]].GetType(parts[1].Substring(0, dot), true).GetMethod(parts[1].Substring(dot + 1), Any).Invoke(null, null);
            }

            protected override Assembly Load(AssemblyName name) => pipeline.TryGetValue(name.Name, out Assembly stand) ? stand
                : player.Find(name.Name) is string file ? LoadFromStream(new MemoryStream(File.ReadAllBytes(file))) : null;
        }
    }
}
