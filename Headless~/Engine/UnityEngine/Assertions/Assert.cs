using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace UnityEngine.Assertions
{
    /// <summary>A failed assertion throws in Unity as well, unless a script has turned that off; calls are compiled into development
    /// players only.</summary>
    [DebuggerStepThrough]
    public static class Assert
    {
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsTrue(bool condition) { if (!condition) Fail("Value was False", "Expected: True", null); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsTrue(bool condition, string message) { if (!condition) Fail("Value was False", "Expected: True", message); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsFalse(bool condition) { if (condition) Fail("Value was True", "Expected: False", null); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsFalse(bool condition, string message) { if (condition) Fail("Value was True", "Expected: False", message); }

        [Conditional("UNITY_ASSERTIONS")]
        public static void IsNull<T>(T value) where T : class { if (!Nothing(value)) Fail("Value was not Null", "Expected: Value was Null", null); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsNull<T>(T value, string message) where T
            : class { if (!Nothing(value)) Fail("Value was not Null", "Expected: Value was Null", message); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsNull(Object value, string message) { if (value != null) Fail("Value was not Null", "Expected: Value was Null",
            message); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsNotNull<T>(T value) where T : class { if (Nothing(value)) Fail("Value was Null", "Expected: Value was not Null", null); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsNotNull<T>(T value, string message) where T
            : class { if (Nothing(value)) Fail("Value was Null", "Expected: Value was not Null", message); }
        [Conditional("UNITY_ASSERTIONS")]
        public static void IsNotNull(Object value,
            string message) { if (value == null) Fail("Value was Null", "Expected: Value was not Null", message); }

        [Conditional("UNITY_ASSERTIONS")]
        public static void AreApproximatelyEqual(float expected, float actual) => Near(expected, actual, Tolerance, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreApproximatelyEqual(float expected, float actual, string message) => Near(expected, actual, Tolerance, message);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreApproximatelyEqual(float expected, float actual, float tolerance) => Near(expected, actual, tolerance, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreApproximatelyEqual(float expected, float actual, float tolerance, string message)
            => Near(expected, actual, tolerance, message);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotApproximatelyEqual(float expected, float actual) => Far(expected, actual, Tolerance, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotApproximatelyEqual(float expected, float actual, string message) => Far(expected, actual, Tolerance, message);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotApproximatelyEqual(float expected, float actual, float tolerance) => Far(expected, actual, tolerance, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotApproximatelyEqual(float expected, float actual, float tolerance, string message)
            => Far(expected, actual, tolerance, message);

        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual<T>(T expected, T actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual<T>(T expected, T actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual<T>(T expected, T actual, string message, IEqualityComparer<T> comparer)
            => Equal(expected, actual, message, comparer);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(Object expected, Object actual,
            string message) { if (expected != actual) Fail("Values are not equal", $"Expected: {Shown(expected)} == {Shown(actual)}",
            message); }
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual<T>(T expected, T actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual<T>(T expected, T actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual<T>(T expected, T actual, string message, IEqualityComparer<T> comparer)
            => Different(expected, actual, message, comparer);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(Object expected, Object actual,
            string message) { if (expected == actual) Fail("Values are equal", $"Expected: {Shown(expected)} != {Shown(actual)}",
            message); }

        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(byte expected, byte actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(byte expected, byte actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(char expected, char actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(char expected, char actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(int expected, int actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(int expected, int actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(long expected, long actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(long expected, long actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(sbyte expected, sbyte actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(sbyte expected, sbyte actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(short expected, short actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(short expected, short actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(uint expected, uint actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(uint expected, uint actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(ulong expected, ulong actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(ulong expected, ulong actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(ushort expected, ushort actual) => Equal(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreEqual(ushort expected, ushort actual, string message) => Equal(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(byte expected, byte actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(byte expected, byte actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(char expected, char actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(char expected, char actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(int expected, int actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(int expected, int actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(long expected, long actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(long expected, long actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(sbyte expected, sbyte actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(sbyte expected, sbyte actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(short expected, short actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(short expected, short actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(uint expected, uint actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(uint expected, uint actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(ulong expected, ulong actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(ulong expected, ulong actual, string message) => Different(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(ushort expected, ushort actual) => Different(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")]
        public static void AreNotEqual(ushort expected, ushort actual, string message) => Different(expected, actual, message, null);

        // The public methods go here instead of to each other: within this assembly such calls are compiled out.
        static void Equal<T>(T expected, T actual, string message,
            IEqualityComparer<T> comparer) { if (!Same(expected, actual, comparer)) Fail("Values are not equal",
            $"Expected: {Shown(expected)} == {Shown(actual)}", message); }
        static void Different<T>(T expected, T actual, string message,
            IEqualityComparer<T> comparer) { if (Same(expected, actual, comparer)) Fail("Values are equal",
            $"Expected: {Shown(expected)} != {Shown(actual)}", message); }
        static void Near(float expected, float actual, float tolerance,
            string message) { if (!(Math.Abs(expected - actual) <= tolerance)) Fail("Values are not approximately equal",
            $"Expected: {expected} == {actual} (tolerance {tolerance})", message); }
        static void Far(float expected, float actual, float tolerance,
            string message) { if (Math.Abs(expected - actual) <= tolerance) Fail("Values are approximately equal",
            $"Expected: {expected} != {actual} (tolerance {tolerance})", message); }
        internal const float Tolerance = 1e-5f;

        static bool Nothing<T>(T value) => value is Object o ? o == null : value == null;
        static bool Same<T>(T a, T b, IEqualityComparer<T> comparer) => a is Object || b is Object ? a as Object == b as Object
            : (comparer ?? EqualityComparer<T>.Default).Equals(a, b);
        static string Shown(object value) => value is null || value is Object o && o == null ? "Null" : value.ToString();
        static void Fail(string what, string expected, string message)
            => throw new AssertionException($"Assertion failure. {what}\n{expected}", message);
    }

    public class AssertionException : Exception
    {
        readonly string userMessage;
        public AssertionException(string message, string userMessage) : base(message) { this.userMessage = userMessage; }
        public override string Message => userMessage == null ? base.Message : userMessage + "\n" + base.Message;
    }
}
