using System.Text.RegularExpressions;
using UnityEngine.Headless;

namespace UnityEngine.TestTools
{
    /// <summary>Expectations about the log. Errors, assertions and exceptions that nothing expects fail a test.</summary>
    public static class LogAssert
    {
        /// <summary>While true, unexpected errors do not fail the test.</summary>
        public static bool ignoreFailingMessages
        {
            get => LogScope.Current.IgnoreFailing;
            set => LogScope.Current.IgnoreFailing = value;
        }

        /// <summary>A message of this type and text, in the order of the calls, before or after the call.</summary>
        public static void Expect(LogType type, string message) => LogScope.Current.Expect(new ExpectedLog(type, message, null));

        public static void Expect(LogType type, Regex message) => LogScope.Current.Expect(new ExpectedLog(type, null, message));

        public static void Expect(string message) => LogScope.Current.Expect(new ExpectedLog(null, message, null));

        public static void Expect(Regex message) => LogScope.Current.Expect(new ExpectedLog(null, null, message));

        /// <summary>Fails when any message, of whatever type, was logged that nothing expected.</summary>
        public static void NoUnexpectedReceived() => LogScope.Current.NoUnexpectedReceived();
    }
}
