using System;

namespace UnityEngine.TestTools
{
    /// <summary>Ends each test as if by <see cref="LogAssert.NoUnexpectedReceived"/>.</summary>
    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method)]
    public class TestMustExpectAllLogsAttribute : Attribute
    {
        public bool MustExpect { get; }
        public TestMustExpectAllLogsAttribute(bool mustExpect = true) => MustExpect = mustExpect;
    }
}
