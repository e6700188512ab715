using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    public class EngineLoopTests : EngineFixture
    {
        class Counter : MonoBehaviour
        {
            public int Fixed, Updates;
            public readonly List<float> Times = new List<float>();
            void FixedUpdate()
            {
                Fixed++;
                Times.Add(Time.time);
                Assert.That(Time.inFixedTimeStep);
                Assert.That(Time.deltaTime, Is.EqualTo(Time.fixedDeltaTime));
            }
            void Update()
            {
                Updates++;
                Assert.That(Time.inFixedTimeStep, Is.False);
            }
        }

        [TestCase(0.02f, 50, 50)]
        [TestCase(0.01f, 50, 25)]
        [TestCase(0.05f, 20, 50)]
        [TestCase(1f / 60, 60, 50)]
        [TestCase(0.1f, 10, 50)]
        public void Fixed_steps_keep_up_with_time(float deltaTime, int frames, int expected)
        {
            Counter counter = Add<Counter>();
            Frames(frames, deltaTime);
            Assert.That(counter.Updates, Is.EqualTo(frames));
            Assert.That(counter.Fixed, Is.EqualTo(expected));
            for (int i = 0; i < counter.Times.Count; i++)
                Assert.That(counter.Times[i], Is.EqualTo((i + 1) * 0.02f).Within(1e-4));
            Assert.That(Time.frameCount, Is.EqualTo(frames));
            Assert.That(Time.time, Is.EqualTo(frames * deltaTime).Within(1e-4));
        }

        [Test]
        public void A_long_frame_counts_as_the_maximum()
        {
            Counter counter = Add<Counter>();
            Time.maximumDeltaTime = 0.1f;
            Frames(1, 5);
            Assert.That(Time.deltaTime, Is.EqualTo(0.1f));
            Assert.That(Time.unscaledDeltaTime, Is.EqualTo(5f));
            Assert.That(counter.Fixed, Is.EqualTo(5));
        }

        [Test]
        public void Time_runs_at_its_scale_and_stands_still_at_zero()
        {
            Counter counter = Add<Counter>();
            Time.timeScale = 0.5f;
            Frames(10, 0.02f);
            Assert.That(Time.time, Is.EqualTo(0.1f).Within(1e-5));
            Assert.That(Time.unscaledTime, Is.EqualTo(0.2f).Within(1e-5));
            Assert.That(counter.Fixed, Is.EqualTo(5));
            Time.timeScale = 0;
            Frames(10, 0.02f);
            Assert.That(counter.Fixed, Is.EqualTo(5));
            Assert.That(counter.Updates, Is.EqualTo(20));
            Assert.That(Time.deltaTime, Is.EqualTo(0));
        }

        [Test]
        public void A_capture_rate_sets_every_frame()
        {
            Time.captureDeltaTime = 0.25f;
            Frames(4, 123);
            Assert.That(Time.time, Is.EqualTo(1));
        }

        // ---- order within a frame
        class Witness : MonoBehaviour
        {
            public readonly List<string> Seen = new List<string>();
            void FixedUpdate() => Seen.Add("FixedUpdate");
            void Update() => Seen.Add("Update");
            void LateUpdate() => Seen.Add("LateUpdate");

            public IEnumerator EachFrame() { while (true) { yield return null; Seen.Add("null"); } }
            public IEnumerator EachFixed() { while (true) { yield return new WaitForFixedUpdate(); Seen.Add("fixed"); } }
            public IEnumerator EachEnd() { while (true) { yield return new WaitForEndOfFrame(); Seen.Add("end"); } }
        }

        [Test]
        public void A_frame_runs_in_Unitys_order()
        {
            Witness witness = Add<Witness>();
            witness.StartCoroutine(witness.EachFrame());
            witness.StartCoroutine(witness.EachFixed());
            witness.StartCoroutine(witness.EachEnd());
            Action begin = () => witness.Seen.Add("begin"), render = () => witness.Seen.Add("render");
            PlayerLoop.BeginFrame += begin;
            PlayerLoop.Render += render;
            try
            {
                Frames(1);
                string[] frame = { "begin", "FixedUpdate", "fixed", "Update", "null", "LateUpdate", "render", "end" };
                Assert.That(witness.Seen, Is.EqualTo(frame));
                witness.Seen.Clear();
                Frames(1);
                Assert.That(witness.Seen, Is.EqualTo(frame));
            }
            finally
            {
                PlayerLoop.BeginFrame -= begin;
                PlayerLoop.Render -= render;
            }
        }

        class Maker : MonoBehaviour
        {
            public Born Made;
            void Update()
            {
                if (Made is null)
                    Made = new GameObject("born").AddComponent<Born>();
            }
        }

        class Born : MonoBehaviour
        {
            void Start() => Story.Tell($"Start {Time.frameCount}");
            void Update() => Story.Tell($"Update {Time.frameCount}");
        }

        [Test]
        public void A_script_made_during_an_update_starts_in_the_next_frame()
        {
            Add<Maker>();
            Frames(2);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Start 2", "Update 2" }));
        }

        // ---- coroutines
        class Runner : MonoBehaviour
        {
            public bool Flag;
            public readonly List<string> Seen = new List<string>();
            void Say(string what) => Seen.Add($"{what}@{Time.frameCount}");

            public IEnumerator Steps()
            {
                Say("a");
                yield return null;
                Say("b");
                yield return 5;     // anything else waits a frame too
                Say("c");
            }

            public IEnumerator Waits()
            {
                yield return new WaitForSeconds(0.05f);
                Say("seconds");
                yield return new WaitUntil(() => Flag);
                Say("until");
                yield return new WaitWhile(() => Flag);
                Say("while");
            }

            public IEnumerator Outer()
            {
                yield return Inner();
                Say("after enumerator");
                yield return StartCoroutine(Inner());
                Say("after coroutine");
            }

            IEnumerator Inner()
            {
                yield return null;
                Say("inner");
                yield return null;
            }

            public IEnumerator Throws()
            {
                yield return null;
                throw new InvalidOperationException("in a coroutine");
            }

            public IEnumerator Operation(AsyncOperation operation)
            {
                yield return operation;
                Say("done");
            }

            public IEnumerator StopsItself()
            {
                Say("on");
                yield return null;
                StopAllCoroutines();
                Say("last");
                yield return null;
                Say("never");
            }

            IEnumerator ByName(int count)
            {
                for (int i = 0; i < count; i++)
                {
                    Say("named");
                    yield return null;
                }
            }
        }

        [Test]
        public void A_coroutine_runs_at_once_to_its_first_yield_and_then_a_step_a_frame()
        {
            Runner runner = Add<Runner>();
            runner.StartCoroutine(runner.Steps());
            Assert.That(runner.Seen, Is.EqualTo(new[] { "a@0" }));
            Frames(5);
            Assert.That(runner.Seen, Is.EqualTo(new[] { "a@0", "b@1", "c@2" }));
        }

        [Test]
        public void Coroutines_wait_for_time_and_conditions()
        {
            Runner runner = Add<Runner>();
            runner.StartCoroutine(runner.Waits());
            Frames(2);
            Assert.That(runner.Seen, Is.Empty);
            Frames(3);
            Assert.That(runner.Seen, Is.EqualTo(new[] { "seconds@3" }));
            runner.Flag = true;
            Frames(1);
            Assert.That(runner.Seen[1], Is.EqualTo("until@6"));
            Frames(2);
            runner.Flag = false;
            Frames(1);
            Assert.That(runner.Seen[2], Is.EqualTo("while@9"));
        }

        [Test]
        public void A_coroutine_waits_for_those_inside_of_it()
        {
            Runner runner = Add<Runner>();
            runner.StartCoroutine(runner.Outer());
            Frames(6);
            Assert.That(runner.Seen, Is.EqualTo(new[] { "inner@1", "after enumerator@2", "inner@3", "after coroutine@4" }));
        }

        [Test]
        public void A_coroutine_waits_for_an_operation()
        {
            Runner runner = Add<Runner>();
            var operation = new AsyncOperation();
            runner.StartCoroutine(runner.Operation(operation));
            Frames(3);
            Assert.That(runner.Seen, Is.Empty);
            operation.Complete();
            Frames(1);
            Assert.That(runner.Seen, Is.EqualTo(new[] { "done@4" }));
        }

        [Test]
        public void An_exception_ends_its_coroutine_alone()
        {
            Runner runner = Add<Runner>();
            runner.StartCoroutine(runner.Throws());
            runner.StartCoroutine(runner.Steps());
            Frames(3);
            Assert.That(runner.Seen, Has.Count.EqualTo(3));
            Assert.That(Errors(), Is.EqualTo(new[] { "InvalidOperationException: in a coroutine" }));
        }

        [Test]
        public void Coroutines_end_with_their_object_but_not_with_their_script_disabled()
        {
            Runner runner = Add<Runner>();
            runner.StartCoroutine(runner.Steps());
            runner.enabled = false;
            Frames(1);
            Assert.That(runner.Seen, Has.Count.EqualTo(2));
            runner.gameObject.SetActive(false);
            runner.gameObject.SetActive(true);
            Frames(3);
            Assert.That(runner.Seen, Has.Count.EqualTo(2));
            runner.gameObject.SetActive(false);
            Assert.That(runner.StartCoroutine(runner.Steps()), Is.Null);
            Assert.That(Errors()[0], Does.Contain("inactive"));
        }

        [Test]
        public void Coroutines_can_be_stopped_by_handle_by_name_and_by_themselves()
        {
            Runner runner = Add<Runner>();
            Coroutine steps = runner.StartCoroutine(runner.Steps());
            runner.StopCoroutine(steps);
            runner.StartCoroutine("ByName", 10);
            Frames(1);
            runner.StopCoroutine("ByName");
            runner.StartCoroutine(runner.StopsItself());
            Frames(3);
            Assert.That(runner.Seen, Is.EqualTo(new[] { "a@0", "named@0", "named@1", "on@1", "last@2" }));
        }

        class StartsAsCoroutine : MonoBehaviour
        {
            IEnumerator Start()
            {
                Story.Tell($"first {Time.frameCount}");
                yield return null;
                Story.Tell($"second {Time.frameCount}");
            }
        }

        [Test]
        public void Start_may_be_a_coroutine()
        {
            Add<StartsAsCoroutine>();
            Frames(3);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "first 1", "second 2" }));
        }

        class Invoker : MonoBehaviour
        {
            public int Once, Often;
            void DoOnce() => Once++;
            void DoOften() => Often++;
        }

        [Test]
        public void Invoke_calls_later_and_InvokeRepeating_until_canceled()
        {
            Invoker invoker = Add<Invoker>();
            invoker.Invoke("DoOnce", 0.05f);
            invoker.InvokeRepeating("DoOften", 0.02f, 0.04f);
            Frames(2);
            Assert.That(invoker.Once, Is.EqualTo(0));
            Frames(8);
            Assert.That(invoker.Once, Is.EqualTo(1));
            Assert.That(invoker.Often, Is.EqualTo(5));
            invoker.CancelInvoke("DoOften");
            Frames(8);
            Assert.That(invoker.Often, Is.EqualTo(5));
            Assert.That(invoker.IsInvoking(), Is.False);
        }

        // ---- the player
        static int registrations;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Register() => registrations++;

        [Test]
        public void A_reset_runs_subsystem_registration_and_leaves_nothing_behind()
        {
            Counter counter = Add<Counter>();
            Object.DontDestroyOnLoad(counter);
            Frames(3);
            RenderSettings.fog = true;
            int before = registrations;
            PlayerLoop.Reset();
            Assert.That(registrations, Is.EqualTo(before + 1));
            Assert.That(RenderSettings.fog, Is.False, "that of a scene that is gone");
            Assert.That(counter == null);
            Assert.That(Time.frameCount, Is.EqualTo(0));
            Assert.That(Object.FindObjectsByType<Component>(FindObjectsInactive.Include, FindObjectsSortMode.None), Is.Empty);
        }

        [Test]
        public void Quitting_can_be_refused()
        {
            Application.wantsToQuit += () => false;
            Application.Quit(3);
            Assert.That(Application.QuitRequested, Is.False);
            PlayerLoop.Reset();
            Application.Quit(3);
            Assert.That(Application.QuitRequested);
            Assert.That(Application.ExitCode, Is.EqualTo(3));
        }

        [Test]
        public void The_log_reaches_the_application_with_its_kind()
        {
            var heard = new List<string>();
            Application.logMessageReceived += (text, stack, type) => heard.Add($"{type}: {text}");
            Debug.Log(null);
            Debug.LogFormat("{0} of {1:F1}", 1, 2.5f);
            Debug.LogWarning(1.5f);
            Debug.LogError("{0}");
            Debug.Assert(false, "no");
            Debug.LogException(new ArgumentException("bad"));
            Assert.That(heard, Is.EqualTo(new[] { "Log: Null", "Log: 1 of 2.5", "Warning: 1.5", "Error: {0}", "Assert: no",
                "Exception: ArgumentException: bad" }));
            Assert.That(Errors(), Has.Count.EqualTo(3));
        }
    }
}
