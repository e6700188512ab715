using System;
using System.Collections.Generic;
using System.Diagnostics;
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
    /// <summary>Runs test assemblies one test after the other on this thread, reports each fixture, and counts what worked on the device.</summary>
    sealed class TestRun : ITestListener
    {
        readonly TextWriter output;
        readonly bool showsAll;
        readonly HashSet<MethodInfo> methods = new(), dispatchingMethods = new();
        readonly List<ITestResult> failuresOfFixture = new();

        readonly Dictionary<string, string> madeBy = new();
        List<string> aliveBefore;
        long dispatchesBefore;

        /// <param name="output">Where the report goes; NUnit takes Console.Out away while tests run.</param>
        /// <param name="showsAll">Also what tests wrote that passed.</param>
        public TestRun(TextWriter output, bool showsAll = false)
        {
            this.output = output;
            this.showsAll = showsAll;
        }

        public int Passed { get; private set; }
        public int Failed { get; private set; }
        public int Skipped { get; private set; }

        /// <summary>Test methods that ran, and those of them that dispatched compute work to the device.</summary>
        public int Methods => methods.Count;
        public int DispatchingMethods => dispatchingMethods.Count;

        public void Run(Assembly assembly, TestFilter filter)
        {
            var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
            ITest tests = Load(runner, assembly);
            if (runner.CountTestCases(filter) == 0)
                return;
            output.WriteLine(assembly.GetName().Name);
            LogSink.Received += Receive;
            BuildSetups.Setup(tests);
            try
            {
                runner.Run(this, filter);
            }
            finally
            {
                LogSink.Received -= Receive;
                BuildSetups.Cleanup(tests);
            }
        }

        /// <summary>Full names of the tests that pass the filter.</summary>
        public static IEnumerable<string> List(Assembly assembly, TestFilter filter) =>
            Leaves(Load(new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder()), assembly)).Where(test => filter.Pass(test)).Select(test => test.FullName);

        static ITest Load(NUnitTestAssemblyRunner runner, Assembly assembly)
        {
            ITest tests = runner.Load(assembly, new Dictionary<string, object>());
            PlayedMethod.ApplyTo(tests);
            return tests;
        }

        static IEnumerable<ITest> Leaves(ITest test) => test.IsSuite ? test.Tests.SelectMany(Leaves) : new[] { test };

        public void TestStarted(ITest test)
        {
            if (test.IsSuite)
                return;
            dispatchesBefore = GpuWork.Dispatches;
            aliveBefore = LiveObjects.Report();
        }

        public void TestFinished(ITestResult result)
        {
            if (!result.Test.IsSuite)
                Count(result);
            else if (result.ResultState.Status == TestStatus.Failed && result.ResultState.Site == FailureSite.TearDown)
                Fail(result);
            if (result.Test is TestFixture)
                ReportFixture(result);
        }

        public void TestOutput(TestOutput text) { }

        /// <summary>Adds to objects that were left the test that made them.</summary>
        public IEnumerable<string> NameLeft(IEnumerable<string> left) => left.Select(thing => madeBy.TryGetValue(thing, out string test) ? $"{thing} was left by {test}" : $"{thing} was left");

        static void Receive(LogEntry entry) => LogScope.Receive(entry.Message, entry.StackTrace, entry.Type);

        void Count(ITestResult result)
        {
            if (LiveObjects.Count > aliveBefore.Count)
                foreach (string thing in LiveObjects.Report().Skip(aliveBefore.Count))
                    madeBy[thing] = result.Test.FullName;

            MethodInfo method = result.Test.Method.MethodInfo;
            switch (result.ResultState.Status)
            {
                case TestStatus.Passed:
                    Passed++;
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
                    Skipped++;
                    return;
            }
            methods.Add(method);
            if (GpuWork.Dispatches != dispatchesBefore)
                dispatchingMethods.Add(method);
        }

        void Fail(ITestResult result)
        {
            Failed++;
            failuresOfFixture.Add(result);
        }

        void ReportFixture(ITestResult fixture)
        {
            string failed = fixture.FailCount > 0 ? $", {fixture.FailCount} FAILED" : "";
            string skipped = fixture.SkipCount + fixture.InconclusiveCount > 0 ? $", {fixture.SkipCount + fixture.InconclusiveCount} skipped" : "";
            output.WriteLine($"  {fixture.Test.Name,-44} {fixture.PassCount,4} passed{failed}{skipped}  {fixture.Duration:0.0} s");
            foreach (ITestResult failure in failuresOfFixture)
                ReportFailure(failure);
            failuresOfFixture.Clear();
            output.Flush();
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
        static readonly string[] Machinery = { "at System.Reflection.", "at System.RuntimeMethodHandle.", "at InvokeStub_", "at NUnit.", "at UnityEngine.Headless.PlayedMethod.", "at UnityEngine.Headless.FramePlayer." };

        void Indent(string text)
        {
            foreach (string line in (text ?? "").TrimEnd().Split('\n').Where(line => line.Length > 0))
                output.WriteLine("      " + line.TrimEnd());
        }
    }
}
