using System;
using System.Collections.Generic;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;
using UnityEngine.Headless;
using PropertyNames = NUnit.Framework.Internal.PropertyNames;

namespace UnityEngine.TestTools
{
    /// <summary>A test that returns IEnumerator and is played over frames. Parameters come from ValueSource and Values, not from TestCase.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTestAttribute : CombiningStrategyAttribute, IImplyFixture, ISimpleTestBuilder, ITestBuilder, IApplyToTest
    {
        readonly NUnitTestCaseBuilder builder = new NUnitTestCaseBuilder();

        public UnityTestAttribute() : base(new CombinatorialStrategy(), new ParameterDataSourceProvider()) { }

        TestMethod ISimpleTestBuilder.BuildFrom(IMethodInfo method, Test suite) => Single(method, suite);

        // NUnit asks here for methods without parameters too, as it does for every attribute that can combine them.
        IEnumerable<TestMethod> ITestBuilder.BuildFrom(IMethodInfo method, Test suite) =>
            method.GetParameters().Length == 0 ? new[] { Single(method, suite) } : BuildFrom(new PlayedMethod(method), suite);

        // NUnit refuses a test method that returns something without an expected result; PlayedMethod reports void.
        TestMethod Single(IMethodInfo method, Test suite) => builder.BuildTestMethod(new PlayedMethod(method), suite, null);

        void IApplyToTest.ApplyToTest(Test test) => ApplyToTest(test);

        public new void ApplyToTest(Test test)
        {
            if (test.Method != null && test.Method.MethodInfo.ReturnType != typeof(System.Collections.IEnumerator))
            {
                test.RunState = RunState.NotRunnable;
                test.Properties.Set(PropertyNames.SkipReason, "A [UnityTest] must return IEnumerator.");
            }
        }
    }

    /// <summary>Runs before each test of the class; returns IEnumerator and is played over frames.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnitySetUpAttribute : NUnitAttribute { }

    /// <summary>Runs after each test of the class; returns IEnumerator and is played over frames.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTearDownAttribute : NUnitAttribute { }
}
