using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Messages and state of a fluid that drops time, by long frames or by a game that runs fast. Frames of 6 steps, of which 4
    /// are taken.</summary>
    public class DroppingFluidTests : PlayedFluidFixture
    {
        const float Step = 1f / 60f, Rate = 4f / 6f;

        readonly List<string> said = new List<string>();
        SourceScene scene;

        [SetUp]
        public void Listen()
        {
            said.Clear();
            Application.logMessageReceived += Hear;
        }

        [TearDown]
        public void LetTimeGoOn()
        {
            Application.logMessageReceived -= Hear;
            Time.timeScale = 1f;
            scene?.Dispose();
            scene = null;
        }

        void Hear(string text, string trace, LogType type) => said.Add(text);

        [UnityTest]
        public IEnumerator A_game_that_runs_fast_drops_time_and_one_that_stands_meanwhile_changes_nothing()
        {
            FluidSimulation fluid = Fluid("Basin", new Vector3(0.4f, 0.4f, 0.3f), 0.05f, 200, new Vector3(0.4f, 0.1f, 0.3f));
            yield return Frames(2);
            Assert.That((fluid.Clock.DropsTime, fluid.Clock.RateOfTime), Is.EqualTo((false, 1f)));
            Time.timeScale = 6f;
            yield return Frames(10);
            Assert.That(said, Has.Count.EqualTo(1));
            Assert.That(said[0], Does.Contain("'Basin' drops time, and runs slower than the game: frames of 0.1 s need 6 fixed steps"));
            Time.timeScale = 0f;
            yield return Frames(20);
            Assert.That(fluid.Clock.DropsTime);
            Assert.That(fluid.Clock.RateOfTime, Is.EqualTo(Rate).Within(1e-3f));
            Time.timeScale = 1f;
            yield return Frames(14);
            Assert.That((fluid.Clock.DropsTime, fluid.Clock.RateOfTime), Is.EqualTo((false, 1f)));
            Assert.That(said, Has.Count.EqualTo(1));
        }

        [Test]
        public void Once_it_is_enabled_again_time_that_is_dropped_is_told_again()
        {
            FluidSimulation fluid = Basin();
            Advance(20, 6f);
            Assert.That(said, Has.Count.EqualTo(1));
            fluid.enabled = false;
            fluid.enabled = true;
            Advance(1, 1f);
            Advance(4, 6f);
            Assert.That(said, Has.Count.EqualTo(1));
            Advance(2, 6f);
            Assert.That(said, Has.Count.EqualTo(2));
        }

        public enum Between { Pause, FrameWithoutTime, FrameWithoutStep, DisableAndEnable, SnapshotAndRestore, Teleport }

        [Test]
        public void What_comes_between_five_frames_in_a_row_does_not_end_the_row([Values] Between between)
        {
            FluidSimulation fluid = Basin();
            Advance(1, 1f);
            Advance(3, 6f);
            switch (between)
            {
                case Between.Pause:
                    fluid.Paused = true;
                    Advance(3, 6f);
                    fluid.Paused = false;
                    break;
                case Between.FrameWithoutTime: Advance(3, 0f); break;
                case Between.FrameWithoutStep: Advance(3, 0.1f); break;
                case Between.DisableAndEnable:
                    fluid.enabled = false;
                    fluid.enabled = true;
                    break;
                case Between.SnapshotAndRestore:
                    FluidSnapshot snapshot = Take();
                    Advance(12, 1f);
                    Assert.That((fluid.Clock.DropsTime, fluid.Clock.RateOfTime), Is.EqualTo((false, 1f)));
                    fluid.Restore(FluidSnapshot.FromBytes(snapshot.ToBytes()));
                    break;
                case Between.Teleport: fluid.Teleport(); break;
            }
            Assert.That(fluid.Clock.DropsTime);
            Assert.That(fluid.Clock.RateOfTime, Is.EqualTo(Rate).Within(1e-3f));
            Advance(1, 6f);
            Assert.That(said, Is.Empty);
            Advance(1, 6f);
            Assert.That(said, Has.Count.EqualTo(1));
        }

        [Test]
        public void After_a_restart_no_time_is_dropped()
        {
            FluidSimulation fluid = Basin();
            Advance(4, 6f);
            Assert.That(fluid.Clock.DropsTime);
            fluid.Restart();
            Assert.That((fluid.Clock.DropsTime, fluid.Clock.RateOfTime), Is.EqualTo((false, 1f)));
            Advance(4, 6f);
            Assert.That(said, Is.Empty);
        }

        FluidSimulation Basin()
        {
            scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.3f), 0.05f, 200).Fill(0.1f);
            return scene.Fluid;
        }

        void Advance(int frames, float steps)
        {
            for (int i = 0; i < frames; i++)
                scene.Fluid.Advance(steps * Step);
        }

        FluidSnapshot Take()
        {
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            return request.Snapshot;
        }
    }
}
