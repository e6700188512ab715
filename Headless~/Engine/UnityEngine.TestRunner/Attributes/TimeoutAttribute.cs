using System;
using System.Reflection;

namespace NUnit.Framework
{
    /// <summary>Milliseconds that a test may take.</summary>
    /// <remarks>
    /// Unity's nunit.framework.dll has this attribute, NUnit's .NET Standard build has not. It sets no property of that
    /// name: NUnit would move the test to another thread, and Unity's tests run on the main one.
    /// </remarks>
    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method, Inherited = false)]
    public class TimeoutAttribute : NUnitAttribute
    {
        readonly int milliseconds;

        public TimeoutAttribute(int timeout) => milliseconds = timeout;

        /// <summary>The limit on a method, else on its class, else on its assembly; 0 when there is none.</summary>
        internal static int Of(MethodInfo method, Type fixture)
        {
            var attribute = method.GetCustomAttribute<TimeoutAttribute>() ?? fixture.GetCustomAttribute<TimeoutAttribute>()
                ?? fixture.Assembly.GetCustomAttribute<TimeoutAttribute>();
            return attribute?.milliseconds ?? 0;
        }
    }
}
