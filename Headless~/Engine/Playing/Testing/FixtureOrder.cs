using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Host.Testing
{
    /// <summary>Which fixtures a worker runs, and in which order it asks for them.</summary>
    sealed class FixtureOrder
    {
        /// <summary>The category of fixtures that run alone, when all others are done.</summary>
        public const string Alone = "RunsAlone";

        readonly Func<string, bool> claim;
        readonly TestDurations durations;
        readonly bool alone;

        /// <param name="claim">True when the fixture of that name is to run here; asked once for each.</param>
        /// <param name="alone">Only fixtures that run alone, instead of all others.</param>
        public FixtureOrder(Func<string, bool> claim, TestDurations durations, bool alone)
        {
            this.claim = claim;
            this.durations = durations;
            this.alone = alone;
        }

        public bool Claim(ITest fixture) => IsAlone(fixture) == alone && claim(NameOf(fixture));

        /// <summary>Longest first, so that none of the workers is left with a long one at the end. What never ran comes before: it may be
        /// long.</summary>
        public void Sort(ITest suite)
        {
            foreach (ITest child in suite.Tests)
                if (child is not TestFixture)
                    Sort(child);
            if (suite is TestFixture || suite is not TestSuite)
                return;
            List<ITest> sorted = suite.Tests.OrderByDescending(Longest).ToList();
            for (int i = 0; i < sorted.Count; i++)
                suite.Tests[i] = sorted[i];
        }

        double Longest(ITest test) => test is TestFixture || test.Tests.Count == 0 ? durations.Of(NameOf(test)) : test.Tests.Max(Longest);

        public static bool IsAlone(ITest fixture) => fixture.Properties[PropertyNames.Category].Contains(Alone);

        /// <summary>The fixture that a test belongs to or is; null for what lies around fixtures.</summary>
        public static ITest FixtureOf(ITest test)
        {
            while (test != null && test is not TestFixture)
                test = test.Parent;
            return test;
        }

        /// <summary>Name that is equal in each process: fixtures of a source that read alike are told apart by where they are listed.</summary>
        public static string NameOf(ITest fixture) => names.GetValue(fixture, MakeName);

        // Made before fixtures are sorted.
        static readonly ConditionalWeakTable<ITest, string> names = new();

        static string MakeName(ITest fixture)
        {
            string name = $"{fixture.TypeInfo?.Assembly.GetName().Name} {fixture.FullName}";
            int twins = fixture.Parent?.Tests.TakeWhile(other => other != fixture).Count(other => other.FullName == fixture.FullName) ?? 0;
            return twins == 0 ? name : $"{name} #{twins + 1}";
        }
    }

    /// <summary>Another filter's tests, but for those of fixtures that run elsewhere. NUnit asks for a fixture's tests when it comes to the
    /// fixture.</summary>
    sealed class FixtureFilter : TestFilter
    {
        readonly TestFilter inner;
        readonly FixtureOrder order;
        readonly Dictionary<ITest, bool> here = new();

        public FixtureFilter(TestFilter inner, FixtureOrder order)
        {
            this.inner = inner;
            this.order = order;
        }

        /// <summary>Asks for a fixture the first time.</summary>
        public bool IsHere(ITest fixture)
        {
            if (!here.TryGetValue(fixture, out bool answer))
                here[fixture] = answer = order.Claim(fixture);
            return answer;
        }

        public override bool Match(ITest test) => !test.IsSuite && inner.Pass(test)
            && !(FixtureOrder.FixtureOf(test) is ITest fixture && here.TryGetValue(fixture, out bool answer) && !answer);

        public override bool IsExplicitMatch(ITest test) => inner.IsExplicitMatch(test);

        public override TNode AddToXml(TNode parent, bool recursive) => inner.AddToXml(parent, recursive);
    }
}
