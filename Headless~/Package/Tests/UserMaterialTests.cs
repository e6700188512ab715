using System;
using System.Linq;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>A material of the user's own on a surface, whose shader is made of Surface.hlsl, shows what the settings ask for.</summary>
    public class UserMaterialTests : PipelineSurfaceFixture
    {
        static readonly string[] Pipelines = { "", "Universal 14", "Universal 17", "HighDefinition 14", "HighDefinition 17" };
        static readonly string[] Keywords = { "RILL_REFRACTION", "RILL_OWN_REFLECTION", "RILL_FOAM" };

        Cubemap red;

        [TearDown]
        public void DestroyCube()
        {
            UnityEngine.Object.DestroyImmediate(red);
            red = null;
        }

        FluidSurface Surface => simulation.GetComponent<FluidSurface>();

        void BuildFor(string name)
        {
            PipelineKind kind = PipelineKind.All.FirstOrDefault(one => name.StartsWith(one.Folder, StringComparison.Ordinal));
            Build(kind, kind == null ? null : name.Substring(kind.Folder.Length + 1));
            PlantedFoam.Add(simulation.gameObject);
            Surface.Refraction = false;
            Play(3);
            simulation.Paused = true;
            Play(1);
        }

        void TurnOn(string keyword)
        {
            Surface.Refraction = keyword == "RILL_REFRACTION";
            if (keyword == "RILL_OWN_REFLECTION")
            {
                red = new Cubemap(1, TextureFormat.RGBAHalf, false);
                for (int face = 0; face < 6; face++)
                    red.SetPixels(new[] { Color.red }, (CubemapFace)face);
                red.Apply();
                Surface.Reflection = red;
                Surface.ReflectionStrength = 4;
            }
            if (keyword == "RILL_FOAM")
                PlantedFoam.Plant(simulation, new Vector3(0, 0.4f, 0));
        }

        static int Unlike(Vector4[] a, Vector4[] b) => a.Where((pixel, i) => (pixel - b[i]).magnitude > 0.004f).Count();

        [Test]
        public void It_follows_each_setting_as_the_packages_does_and_is_left_alone([ValueSource(nameof(Pipelines))] string name,
            [ValueSource(nameof(Keywords))] string keyword)
        {
            BuildFor(name);
            Material own = RenderPassFixture.MaterialOf("Surface.shader", UnityEngine.Headless.Player.PipelineTag);
            Vector4[] off = Pixels();
            TurnOn(keyword);
            Play(2);
            Vector4[] on = Pixels();
            Surface.Material = own;
            Play(2);
            Assert.That(Unlike(on, off), Is.GreaterThan(30), "the setting is seen");
            Assert.That(Unlike(Pixels(), on), Is.Zero);
            Assert.That(own.shaderKeywords, Is.Empty);
            Assert.That(Errors, Is.Empty);

            own.renderQueue = 2962;
            Play(1);
            Assert.That(Resources.FindObjectsOfTypeAll<Material>().Count(other => other.shader == own.shader && other.renderQueue == 2962),
                Is.EqualTo(2), "what is drawn follows it");
            Surface.Material = null;
            Play(2);
            Assert.That(Unlike(Pixels(), on), Is.Zero, "back");
        }

        [Test]
        public void One_that_knows_nothing_of_foam_leaves_it_to_the_component()
        {
            BuildFor("");
            TurnOn("RILL_FOAM");
            Play(1);
            Assert.That(Surface.DrawsFoam, Is.True);
            Surface.Material = RenderPassFixture.MaterialOf("Surface.shader", "",
                text => text.Replace("#pragma multi_compile_local_fragment _ RILL_FOAM", ""));
            Play(1);
            Assert.That(Surface.DrawsFoam, Is.False);
        }
    }
}
