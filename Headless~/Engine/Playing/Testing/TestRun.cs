using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Testing
{
    /// <summary>Runs test assemblies one test after the other on this thread, and reports each fixture with what worked on the device.</summary>
    sealed class TestRun : ITestListener
    {
        readonly Action<FixtureReport> report;
        readonly bool showsAll;
        readonly FixtureOrder order;
        readonly List<ITestResult> failuresOfFixture = new();

        readonly Dictionary<string, string> madeBy = new();
        readonly EngineStatics statics;
        bool isOfHost;
        FixtureFilter claimed;
        StringWriter output = new();
        FixtureReport counts = new();
        string assemblyName;
        List<string> aliveBefore;
        string leftStatics;     // fault of the fixture that ends
        long dispatchesBefore;

        /// <param name="report">Gets each fixture as it ends; not through Console.Out, which NUnit takes away while tests run.</param>
        /// <param name="showsAll">Also what tests wrote that passed.</param>
        /// <param name="order">Which fixtures run here and which of them first; null for all, as they are listed.</param>
        /// <param name="watchesStatics">Settings of the engine go back to what they are now after each fixture. One of a package that leaves
        /// them changed fails: in Unity it would change the fixtures after it.</param>
        public TestRun(Action<FixtureReport> report, bool showsAll = false, FixtureOrder order = null, bool watchesStatics = false)
        {
            statics = watchesStatics ? new EngineStatics() : null;
            this.report = report;
            this.showsAll = showsAll;
            this.order = order;
        }

        /// <summary>Set-ups and tear-downs of the assembly and of its namespaces run here once, whichever fixtures do.</summary>
        public void Run(Assembly assembly, TestFilter filter)
        {
            var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
            ITest tests = Load(runner, assembly);
            if (runner.CountTestCases(filter) == 0)
                return;
            assemblyName = assembly.GetName().Name;
            isOfHost = TestAssemblies.IsOfHost(assemblyName);
            if (order == null)
                report(new FixtureReport { Assembly = assemblyName });
            order?.Sort(tests);
            claimed = order == null ? null : new FixtureFilter(filter, order);
            LogSink.Received += Receive;
            BuildSetups.Setup(tests);
            try
            {
                runner.Run(this, claimed ?? filter);
            }
            finally
            {
                LogSink.Received -= Receive;
                BuildSetups.Cleanup(tests);
            }
            // A set-up or tear-down around the fixtures may have failed after the last of them.
            if (failuresOfFixture.Count > 0 || counts.Failed > 0)
                Send(null, 0.0, whole: false);
        }

        /// <summary>Full names of the tests that pass the filter.</summary>
        public static IEnumerable<string> List(Assembly assembly, TestFilter filter) =>
            Leaves(Load(assembly)).Where(test => filter.Pass(test)).Select(test => test.FullName);

        /// <summary>Categories of tests and fixtures, each once.</summary>
        public static IEnumerable<string> Categories(Assembly assembly) => CategoriesOf(Load(assembly)).Distinct();

        static IEnumerable<string> CategoriesOf(ITest test)
            => test.Properties[NUnit.Framework.Internal.PropertyNames.Category].Cast<string>().Concat(test.Tests.SelectMany(CategoriesOf));

        /// <summary>The fixtures of which a test passes the filter.</summary>
        public static IEnumerable<(string Name, bool IsAlone)> Fixtures(Assembly assembly, TestFilter filter) =>
            Leaves(Load(assembly)).Where(test => filter.Pass(test)).Select(FixtureOrder.FixtureOf).Distinct()
            .Select(fixture => (FixtureOrder.NameOf(fixture), FixtureOrder.IsAlone(fixture)));

        // In Unity all tests of an Editor assembly start there; on this host those that ask for it.
        static bool IsOfEditMode(ITest test) => test != null
            && (test.Properties[NUnit.Framework.Internal.PropertyNames.Category].Contains("EditMode") || IsOfEditMode(test.Parent));

        static ITest Load(Assembly assembly) => Load(new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder()), assembly);

        static ITest Load(NUnitTestAssemblyRunner runner, Assembly assembly)
        {
            ITest tests = runner.Load(assembly, new Dictionary<string, object>());
            PlayedMethod.ApplyTo(tests);
            return tests;
        }

        static IEnumerable<ITest> Leaves(ITest test) => test.IsSuite ? test.Tests.SelectMany(Leaves) : new[] { test };

        public void TestStarted(ITest test)
        {
            if (test is TestFixture)
                claimed?.IsHere(test);
            if (test.IsSuite)
                return;
            EditMode.IsOn = IsOfEditMode(test);
            dispatchesBefore = GpuWork.Dispatches;
            aliveBefore = LiveObjects.Report();
        }

        public void TestFinished(ITestResult result)
        {
            // If a set-up around them failed, tests of all fixtures end without a start.
            if (claimed != null && FixtureOrder.FixtureOf(result.Test) is ITest fixture && !claimed.IsHere(fixture))
                return;
            if (!result.Test.IsSuite)
            {
                EditMode.IsOn = false;
                Count(result);
            }
            else if (result.ResultState.Status == TestStatus.Failed && result.ResultState.Site == FailureSite.TearDown)
                Fail(result);
            if (result.Test is TestFixture)
            {
                List<string> left = statics?.PutBack() ?? new List<string>();
                if (left.Count > 0 && !isOfHost)
                    leftStatics = $"it leaves {string.Join(", ", left)}: put back what a test sets";
                ReportFixture(result);
            }
        }

        public void TestOutput(TestOutput text) { }

        /// <summary>Adds to objects that were left the test that made them.</summary>
        public IEnumerable<string> NameLeft(IEnumerable<string> left)
            => left.Select(thing => madeBy.TryGetValue(thing, out string test) ? $"{thing} was left by {test}" : $"{thing} was left");

        static void Receive(LogEntry entry) => LogScope.Receive(entry.Message, entry.StackTrace, entry.Type);

        void Count(ITestResult result)
        {
            if (aliveBefore != null && LiveObjects.Count > aliveBefore.Count)
                foreach (string thing in LiveObjects.Report().Skip(aliveBefore.Count))
                    madeBy[thing] = result.Test.FullName;

            switch (result.ResultState.Status)
            {
                case TestStatus.Passed:
                    counts.Passed++;
                    if (showsAll && !string.IsNullOrWhiteSpace(result.Output))
                    {
                        output.WriteLine($"    {result.Test.Name}");
                        Indent(result.Output);
                    }
                    break;
                case TestStatus.Failed:
                    Fail(result);
                    break;
                default:
                    counts.Skipped++;
                    return;
            }
            MethodInfo method = result.Test.Method.MethodInfo;
            string name = $"{assemblyName} {method.ReflectedType} {method}";
            counts.Methods.Add(name);
            if (GpuWork.Dispatches != dispatchesBefore)
                counts.DispatchingMethods.Add(name);
        }

        void Fail(ITestResult result)
        {
            counts.Failed++;
            failuresOfFixture.Add(result);
        }

        void ReportFixture(ITestResult fixture)
        {
            string failed = fixture.FailCount > 0 ? $", {fixture.FailCount} FAILED" : "";
            string skipped = fixture.SkipCount + fixture.InconclusiveCount > 0 ? $", {fixture.SkipCount + fixture.InconclusiveCount} skipped" : "";
            output.WriteLine($"  {fixture.Test.Name,-44} {fixture.PassCount,4} passed{failed}{skipped}  {fixture.Duration:0.0} s");
            if (leftStatics != null)
            {
                counts.Failed++;
                output.WriteLine($"    FAILED {fixture.Test.Name}");
                Indent(leftStatics);
                leftStatics = null;
            }
            Send(FixtureOrder.NameOf(fixture.Test), fixture.Duration, fixture.PassCount + fixture.FailCount + fixture.SkipCount
                + fixture.InconclusiveCount == fixture.Test.TestCaseCount);
        }

        void Send(string fixture, double seconds, bool whole)
        {
            foreach (ITestResult failure in failuresOfFixture)
                ReportFailure(failure);
            failuresOfFixture.Clear();
            counts.Assembly = assemblyName;
            counts.Fixture = fixture;
            counts.Seconds = seconds;
            counts.IsWhole = whole;
            counts.Text = output.ToString();
            report(counts);
            counts = new FixtureReport();
            output = new StringWriter();
        }

        void ReportFailure(ITestResult result)
        {
            output.WriteLine($"    FAILED {result.Test.Name}");
            Indent(result.Message);
            Indent(string.Join("\n", (result.StackTrace ?? "").Split('\n').Where(line => !Machinery.Any(line.TrimStart().StartsWith))));
            if (!string.IsNullOrWhiteSpace(result.Output))
            {
                output.WriteLine("      output:");
                Indent(result.Output);
            }
        }

        // Frames between a test and this runner say nothing about a failure.
        static readonly string[] Machinery = { "at System.Reflection.", "at System.RuntimeMethodHandle.", "at InvokeStub_", "at NUnit.",
            "at UnityEngine.Headless.PlayedMethod.", "at UnityEngine.Headless.FramePlayer." };

        void Indent(string text)
        {
            foreach (string line in (text ?? "").TrimEnd().Split('\n').Where(line => line.Length > 0))
                output.WriteLine("      " + line.TrimEnd());
        }
    }
}
