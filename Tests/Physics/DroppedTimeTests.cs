using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Bodies where frames take more time than the fluid has steps for.</summary>
    [Category("LongRun")]
    public class DroppedTimeTests
    {
        static readonly Vector3 Box = new Vector3(0.5f, 0.3f, 0.5f);

        readonly List<string> said = new List<string>();
        FloatingScene scene;
        float rest;     // height of the body, m

        [UnitySetUp]
        public IEnumerator Listen()
        {
            yield return PhysicsClock.Begin(FloatingScene.Frame);
            said.Clear();
            Application.logMessageReceived += Hear;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Application.logMessageReceived -= Hear;
            Time.timeScale = 1f;
            Time.captureDeltaTime = 0f;
            scene?.Dispose();
            scene = null;
            yield return null;
        }

        void Hear(string text, string trace, LogType type) => said.Add(text);

        [UnityTest]
        public IEnumerator A_body_stays_afloat_in_slow_frames_and_one_warning_names_the_remedy([Values(3f, 5f, 12f)] float framesPerSecond,
            [Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            yield return ComeToRest(deepWater, 0.5f);
            Time.captureDeltaTime = 1f / framesPerSecond;
            yield return StayAfloat(Mathf.RoundToInt(7f * framesPerSecond));
            int needed = Mathf.RoundToInt(60f / framesPerSecond);
            Assert.That(said, Has.Count.EqualTo(1));
            Assert.That(said[0], Does.StartWith("Rill: FluidSimulation 'Fluid' drops time, and runs slower than the game: frames of ")
                .And.Contain($" need {needed} fixed steps, and Max Steps Per Frame is 4. Raise Max Steps Per Frame"));
        }

        [UnityTest]
        public IEnumerator A_body_stays_afloat_where_time_runs_fast([Values(8f, 20f)] float timeScale, [Values(0.1f, 0.9f)] float ratio)
        {
            yield return ComeToRest(DeepWater.On, ratio);
            Time.timeScale = timeScale;
            yield return StayAfloat(120);
        }

        [UnityTest]
        public IEnumerator A_body_that_is_made_in_slow_frames_stays_where_it_floats([Values(3f, 5f)] float framesPerSecond)
        {
            Time.captureDeltaTime = 1f / framesPerSecond;
            scene = new FloatingScene(ColliderShape.Box, Box, 0.5f, 0.6f, side: 22);
            yield return scene.Play(4f * FloatingScene.Frame * framesPerSecond);      // of 4 s
            Assert.That(scene.Heights.Min(), Is.GreaterThan(0.35f), "it did not fall until the fluid told of itself");
            rest = 0.62f;
            yield return StayAfloat(Mathf.RoundToInt(4f * framesPerSecond));
        }

        [UnityTest]
        public IEnumerator A_hitch_is_no_news_and_moves_no_body()
        {
            yield return ComeToRest(DeepWater.On, 0.5f);
            Time.captureDeltaTime = 1f / 3f;
            yield return StayAfloat(2);
            Time.captureDeltaTime = FloatingScene.Frame;
            yield return StayAfloat(60);
            Assert.That(said, Is.Empty);
        }

        IEnumerator ComeToRest(DeepWater deepWater, float ratio)
        {
            scene = new FloatingScene(ColliderShape.Box, Box, ratio, 0.6f + (0.5f - ratio) * Box.y, deepWater: deepWater, side: 22);
            yield return scene.Play(2.5f);
            rest = scene.Heights.Skip(scene.Heights.Count - 30).Average();
        }

        IEnumerator StayAfloat(int frames)
        {
            float lowest = float.PositiveInfinity, highest = float.NegativeInfinity, fastest = 0f;
            for (int i = 0; i < frames; i++)
            {
                yield return null;
                lowest = Mathf.Min(lowest, scene.Body.position.y);
                highest = Mathf.Max(highest, scene.Body.position.y);
                fastest = Mathf.Max(fastest, scene.Body.GetPointVelocity(scene.Body.worldCenterOfMass).magnitude);
            }
            TestContext.Out.WriteLine($"rest {rest:0.000}, {lowest:0.000} to {highest:0.000} m, at most {fastest:0.00} m/s, " +
                $"{Vector3.Angle(scene.Body.rotation * Vector3.up, Vector3.up):0}° off upright");
            Assert.That(lowest, Is.GreaterThan(rest - 0.1f));
            Assert.That(highest, Is.LessThan(rest + 0.1f));
        }
    }
}
