using System;
using System.Linq;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>What cameras draw of a fluid that is simulated without Play.</summary>
    public class SceneSimulationPictureTests : GraphicsFixture
    {
        const int Steps = 6;

        [SetUp]
        public void SetSize() => (Player.ScreenWidth, Player.ScreenHeight) = (160, 90);

        [TearDown]
        public void StopSimulation() => SceneSimulation.Stop();

        [Test]
        public void The_picture_of_a_sample_without_Play_is_that_of_play_mode()
        {
            byte[] played, still, simulated, stopped;
            using (new SampleScene("Column"))
            {
                EditModeScene.Play(Steps);
                played = Screenshot.ReadRgba();
            }
            PlayerLoop.Reset();

            EditMode.IsOn = true;
            using (new SampleScene("Column"))
            {
                EditModeScene.Play(1);
                still = Screenshot.ReadRgba();
                SceneSimulation.Start(Object.FindObjectOfType<FluidSimulation>());
                Assert.That(SceneSimulation.Problem, Is.Null);
                EditModeScene.Step(Steps);
                simulated = Screenshot.ReadRgba();
                SceneSimulation.Stop();
                EditModeScene.Play(1);
                stopped = Screenshot.ReadRgba();
            }
            Assert.That(Differing(still, played), Is.GreaterThan(0.02), "the water is to be seen");
            Assert.That(Differing(simulated, played), Is.LessThan(0.001));
            Assert.That(Differing(stopped, still), Is.Zero, "after it the picture is as before");
        }

        // Fraction of the pixels that are not the same, by more than a rounding.
        static double Differing(byte[] a, byte[] b)
            => Enumerable.Range(0, a.Length / 4).Count(i => Enumerable.Range(4 * i, 3).Any(k => Math.Abs(a[k] - b[k]) > 2)) / (a.Length / 4.0);
    }
}
