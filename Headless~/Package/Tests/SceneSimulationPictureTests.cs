using System;
using System.Linq;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Pictures by cameras of a fluid that is simulated without Play.</summary>
    public class SceneSimulationPictureTests : GraphicsFixture
    {
        const int Steps = 6;

        [TearDown]
        public void StopSimulation() => SceneSimulation.Stop();

        [Test]
        public void The_picture_without_Play_is_that_of_play_mode_and_the_water_goes_with_Stop()
        {
            DrawParticles(new EditModeScene(plays: true));
            EditModeScene.Play(Steps);
            byte[] played = Screenshot.ReadRgba();
            PlayerLoop.Reset();

            var scene = new EditModeScene();
            DrawParticles(scene);
            EditModeScene.Play(1);
            byte[] still = Screenshot.ReadRgba();
            scene.Simulate();
            EditModeScene.Step(Steps);
            byte[] simulated = Screenshot.ReadRgba();
            EditorTick.Run();       // paused
            byte[] paused = Screenshot.ReadRgba();
            SceneSimulation.Stop();
            EditModeScene.Play(1);
            byte[] stopped = Screenshot.ReadRgba();

            Assert.That(Differing(still, played), Is.GreaterThan(0.03), "the water is to be seen");
            Assert.That(Differing(simulated, played), Is.Zero);
            Assert.That(Differing(paused, played), Is.Zero);
            Assert.That(Differing(stopped, still), Is.Zero);
        }

        // The surface takes a minute to compile on a CPU.
        static void DrawParticles(EditModeScene scene)
        {
            Object.DestroyImmediate(scene.Fluid.GetComponent<FluidSurface>());
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -2f);
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.gray;
        }

        // Fraction of the pixels that are not the same, by more than a rounding.
        static double Differing(byte[] a, byte[] b)
        {
            int pixels = a.Length / 4;
            return Enumerable.Range(0, pixels).Count(i => Enumerable.Range(4 * i, 3).Any(k => Math.Abs(a[k] - b[k]) > 2)) / (double)pixels;
        }
    }
}
