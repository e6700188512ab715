using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;
using NUnit.Framework.Internal.Execution;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.TestTools;
using PropertyNames = NUnit.Framework.Internal.PropertyNames;

namespace Host.Tests
{
    public class RunnerTests
    {
        [Test]
        public void A_coroutine_test_takes_a_frame_for_each_yield()
        {
            ITestResult result = Play(typeof(Planted<int>), nameof(Planted<int>.Three_frames));
            Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Passed), result.Message);
            Assert.That(Planted<int>.Frames, Is.EqualTo(new[] { 0, 1, 2, 3 }));
        }

        [Test]
        public void A_nested_enumerator_is_stepped_to_its_end_before_its_parent_goes_on()
        {
            ITestResult result = Play(typeof(Planted<int>), nameof(Planted<int>.Nested));
            Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Passed), result.Message);
            Assert.That(Planted<int>.Trace, Is.EqualTo("a1b2c"));
        }

        [TestCase(nameof(Planted<int>.Throws_after_a_frame), "planted")]
        [TestCase(nameof(Planted<int>.Throws_in_a_nested_enumerator), "planted")]
        [TestCase(nameof(Planted<int>.Fails_an_assertion_after_a_frame), "Expected: 2")]
        [TestCase(nameof(Planted<int>.Logs_an_error), "Unhandled log message: '[Error] planted'")]
        [TestCase(nameof(Planted<int>.Logs_an_error_in_a_frame), "Unhandled log message: '[Error] planted'")]
        [TestCase(nameof(Planted<int>.Logs_an_exception), "[Exception] InvalidOperationException: planted")]
        [TestCase(nameof(Planted<int>.Expects_what_does_not_come), "Expected log did not appear: [Warning] never")]
        [TestCase(nameof(Planted<int>.Expects_in_another_order), "Unhandled log message: '[Error] second'")]
        [TestCase(nameof(Planted<int>.Wants_no_other_message), "Unhandled log message: '[Log] stray'")]
        [TestCase(nameof(Planted<int>.Never_ends), "Timeout value of 100 ms was exceeded")]
        [TestCase(nameof(Planted<int>.Waits_for_the_end_of_frame), "WaitForEndOfFrame")]
        public void A_faulty_test_fails_and_says_why(string method, string message)
        {
            ITestResult result = Play(typeof(Planted<int>), method);
            Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Failed));
            Assert.That(result.Message, Does.Contain(message));
        }

        [TestCase(nameof(Planted<int>.Expects_an_error))]
        [TestCase(nameof(Planted<int>.Expects_an_error_by_pattern_after_it_came))]
        [TestCase(nameof(Planted<int>.Ignores_errors))]
        [TestCase(nameof(Planted<int>.Logs_a_warning))]
        public void A_test_that_expects_its_log_passes(string method)
        {
            ITestResult result = Play(typeof(Planted<int>), method);
            Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Passed), result.Message);
        }

        [Test]
        public void Set_up_and_tear_down_run_in_Unitys_order()
        {
            SetUpOrder<int>.Trace = "";
            ITestResult result = Play(typeof(SetUpOrder<int>), nameof(SetUpOrder<int>.Body));
            Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Passed), result.Message);
            Assert.That(SetUpOrder<int>.Trace, Is.EqualTo("UnitySetUp SetUp Body TearDown UnityTearDown "));
        }

        [Test]
        public void A_coroutine_test_takes_a_value_source_and_refuses_test_cases()
        {
            Assert.That(Build(typeof(Parametrized<int>), nameof(Parametrized<int>.From_a_source)).Tests.Select(test => test.Name),
                Is.EqualTo(new[] { "From_a_source(3)", "From_a_source(5)" }));
            ITest refused = Build(typeof(Parametrized<int>), nameof(Parametrized<int>.From_cases)).Tests.First();
            Assert.That(refused.RunState, Is.EqualTo(RunState.NotRunnable));
            Assert.That((string)refused.Properties.Get(PropertyNames.SkipReason), Does.Contain("non-void return value"));
        }

        [UnityTest]
        public IEnumerator The_suites_own_coroutine_tests_see_frames_of_a_sixtieth_second()
        {
            int before = Time.frameCount;
            yield return null;
            Assert.That(Time.frameCount, Is.EqualTo(before + 1));
            Assert.That(Time.deltaTime, Is.EqualTo(1f / 60).Within(1e-6f));
        }

        [UnityTest]
        public IEnumerator Waiting_for_seconds_waits_in_game_time()
        {
            float start = Time.time;
            yield return new WaitForSeconds(0.25f);
            Assert.That(Time.time - start, Is.InRange(0.25f, 0.25f + 2f / 60));
        }

        static ITestResult Play(Type fixture, string method)
        {
            ITest test = Build(fixture, method);
            PlayedMethod.ApplyTo(test);
            TestExecutionContext outer = TestExecutionContext.CurrentContext;
            LogScope scope = LogScope.Suspend();
            try
            {
                var work = WorkItem.CreateWorkItem(test, TestFilter.Empty);
                work.InitializeContext(new TestExecutionContext { Dispatcher = new SimpleWorkItemDispatcher(),
                    TestObject = Activator.CreateInstance(fixture) });
                work.Execute();
                return work.Result.HasChildren ? work.Result.Children.Single() : work.Result;
            }
            finally
            {
                LogScope.Resume(scope);
                outer.EstablishExecutionEnvironment();
            }
        }

        static Test Build(Type fixture, string method)
            => new DefaultTestCaseBuilder().BuildFrom(new MethodWrapper(fixture, method), new TestFixture(new TypeWrapper(fixture)));

        // NUnit passes over generic classes that no attribute closes, so the suite does not run what is planted in these.
        class Planted<T>
        {
            public static List<int> Frames;
            public static string Trace;

            [UnityTest]
            public IEnumerator Three_frames()
            {
                int first = Time.frameCount;
                Frames = new List<int>();
                for (int i = 0; i < 3; i++)
                {
                    Frames.Add(Time.frameCount - first);
                    yield return null;
                }
                Frames.Add(Time.frameCount - first);
            }

            [UnityTest]
            public IEnumerator Nested()
            {
                Trace = "a";
                yield return Inner();
                Trace += "c";
            }

            static IEnumerator Inner()
            {
                int first = Time.frameCount;
                yield return null;
                Trace += Time.frameCount - first + "b";
                yield return null;
                Trace += Time.frameCount - first;
            }

            [UnityTest]
            public IEnumerator Throws_after_a_frame()
            {
                yield return null;
                throw new InvalidOperationException("planted");
            }

            [UnityTest]
            public IEnumerator Throws_in_a_nested_enumerator() { yield return Throws_after_a_frame(); }

            [UnityTest]
            public IEnumerator Fails_an_assertion_after_a_frame()
            {
                yield return null;
                Assert.That(1 + 2, Is.EqualTo(2));
            }

            [Test]
            public void Logs_an_error() => Debug.LogError("planted");

            [UnityTest]
            public IEnumerator Logs_an_error_in_a_frame()
            {
                yield return null;
                Debug.LogError("planted");
                yield return null;
                Assert.Fail("went on after the error");
            }

            [Test]
            public void Logs_an_exception() => Debug.LogException(new InvalidOperationException("planted"));

            [Test]
            public void Expects_what_does_not_come() => LogAssert.Expect(LogType.Warning, "never");

            [Test]
            public void Expects_in_another_order()
            {
                LogAssert.Expect(LogType.Error, "first");
                LogAssert.Expect(LogType.Error, "second");
                Debug.LogError("second");
                Debug.LogError("first");
            }

            [Test]
            public void Wants_no_other_message()
            {
                Debug.Log("stray");
                LogAssert.NoUnexpectedReceived();
            }

            [UnityTest, Timeout(100)]
            public IEnumerator Never_ends() { while (true) yield return null; }

            [UnityTest]
            public IEnumerator Waits_for_the_end_of_frame() { yield return new WaitForEndOfFrame(); }

            [Test]
            public void Expects_an_error()
            {
                LogAssert.Expect(LogType.Error, "planted");
                Debug.LogError("planted");
            }

            [Test]
            public void Expects_an_error_by_pattern_after_it_came()
            {
                Debug.LogError("planted number 7");
                LogAssert.Expect(LogType.Error, new Regex("number \\d"));
            }

            [Test]
            public void Ignores_errors()
            {
                LogAssert.ignoreFailingMessages = true;
                Debug.LogError("planted");
            }

            [Test]
            public void Logs_a_warning() => Debug.LogWarning("planted");
        }

        class SetUpOrder<T>
        {
            public static string Trace;

            [UnitySetUp]
            public IEnumerator Before()
            {
                yield return null;
                Trace += "UnitySetUp ";
            }

            [SetUp]
            public void SetUp() => Trace += "SetUp ";

            [Test]
            public void Body() => Trace += "Body ";

            [TearDown]
            public void TearDown() => Trace += "TearDown ";

            [UnityTearDown]
            public IEnumerator After()
            {
                yield return null;
                Trace += "UnityTearDown ";
            }
        }

        class Parametrized<T>
        {
            static readonly int[] values = { 3, 5 };

            [UnityTest]
            public IEnumerator From_a_source([ValueSource(nameof(values))] int value) { yield return null; }

            [UnityTest, TestCase(3)]
            public IEnumerator From_cases(int value) { yield return null; }
        }
    }
}
