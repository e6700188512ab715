using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace UnityEngine.Assertions
{
    /// <summary>A failed assertion throws in Unity as well, unless a script has turned that off; calls are compiled into development players only.</summary>
    [DebuggerStepThrough]
    public static class Assert
    {
        [Conditional("UNITY_ASSERTIONS")] public static void IsTrue(bool condition) => IsTrue(condition, null);
        [Conditional("UNITY_ASSERTIONS")] public static void IsTrue(bool condition, string message) { if (!condition) Fail("Value was False", "Expected: True", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void IsFalse(bool condition) => IsFalse(condition, null);
        [Conditional("UNITY_ASSERTIONS")] public static void IsFalse(bool condition, string message) { if (condition) Fail("Value was True", "Expected: False", message); }

        [Conditional("UNITY_ASSERTIONS")] public static void IsNull<T>(T value) where T : class => IsNull(value, null);
        [Conditional("UNITY_ASSERTIONS")] public static void IsNull<T>(T value, string message) where T : class { if (!Nothing(value)) Fail("Value was not Null", "Expected: Value was Null", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void IsNull(Object value, string message) { if (value != null) Fail("Value was not Null", "Expected: Value was Null", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void IsNotNull<T>(T value) where T : class => IsNotNull(value, null);
        [Conditional("UNITY_ASSERTIONS")] public static void IsNotNull<T>(T value, string message) where T : class { if (Nothing(value)) Fail("Value was Null", "Expected: Value was not Null", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void IsNotNull(Object value, string message) { if (value == null) Fail("Value was Null", "Expected: Value was not Null", message); }

        [Conditional("UNITY_ASSERTIONS")] public static void AreApproximatelyEqual(float expected, float actual) => AreApproximatelyEqual(expected, actual, Tolerance, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreApproximatelyEqual(float expected, float actual, string message) => AreApproximatelyEqual(expected, actual, Tolerance, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreApproximatelyEqual(float expected, float actual, float tolerance) => AreApproximatelyEqual(expected, actual, tolerance, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreApproximatelyEqual(float expected, float actual, float tolerance, string message) { if (!(Math.Abs(expected - actual) <= tolerance)) Fail($"Values are not approximately equal", $"Expected: {expected} == {actual} (tolerance {tolerance})", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotApproximatelyEqual(float expected, float actual) => AreNotApproximatelyEqual(expected, actual, Tolerance, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotApproximatelyEqual(float expected, float actual, string message) => AreNotApproximatelyEqual(expected, actual, Tolerance, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotApproximatelyEqual(float expected, float actual, float tolerance) => AreNotApproximatelyEqual(expected, actual, tolerance, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotApproximatelyEqual(float expected, float actual, float tolerance, string message) { if (Math.Abs(expected - actual) <= tolerance) Fail("Values are approximately equal", $"Expected: {expected} != {actual} (tolerance {tolerance})", message); }

        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual<T>(T expected, T actual) => AreEqual(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual<T>(T expected, T actual, string message) => AreEqual(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual<T>(T expected, T actual, string message, IEqualityComparer<T> comparer) { if (!Same(expected, actual, comparer)) Fail("Values are not equal", $"Expected: {Shown(expected)} == {Shown(actual)}", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(Object expected, Object actual, string message) { if (expected != actual) Fail("Values are not equal", $"Expected: {Shown(expected)} == {Shown(actual)}", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual<T>(T expected, T actual) => AreNotEqual(expected, actual, null, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual<T>(T expected, T actual, string message) => AreNotEqual(expected, actual, message, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual<T>(T expected, T actual, string message, IEqualityComparer<T> comparer) { if (Same(expected, actual, comparer)) Fail("Values are equal", $"Expected: {Shown(expected)} != {Shown(actual)}", message); }
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(Object expected, Object actual, string message) { if (expected == actual) Fail("Values are equal", $"Expected: {Shown(expected)} != {Shown(actual)}", message); }

        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(byte expected, byte actual) => AreEqual<byte>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(byte expected, byte actual, string message) => AreEqual<byte>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(char expected, char actual) => AreEqual<char>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(char expected, char actual, string message) => AreEqual<char>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(int expected, int actual) => AreEqual<int>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(int expected, int actual, string message) => AreEqual<int>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(long expected, long actual) => AreEqual<long>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(long expected, long actual, string message) => AreEqual<long>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(sbyte expected, sbyte actual) => AreEqual<sbyte>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(sbyte expected, sbyte actual, string message) => AreEqual<sbyte>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(short expected, short actual) => AreEqual<short>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(short expected, short actual, string message) => AreEqual<short>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(uint expected, uint actual) => AreEqual<uint>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(uint expected, uint actual, string message) => AreEqual<uint>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(ulong expected, ulong actual) => AreEqual<ulong>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(ulong expected, ulong actual, string message) => AreEqual<ulong>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(ushort expected, ushort actual) => AreEqual<ushort>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreEqual(ushort expected, ushort actual, string message) => AreEqual<ushort>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(byte expected, byte actual) => AreNotEqual<byte>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(byte expected, byte actual, string message) => AreNotEqual<byte>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(char expected, char actual) => AreNotEqual<char>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(char expected, char actual, string message) => AreNotEqual<char>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(int expected, int actual) => AreNotEqual<int>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(int expected, int actual, string message) => AreNotEqual<int>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(long expected, long actual) => AreNotEqual<long>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(long expected, long actual, string message) => AreNotEqual<long>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(sbyte expected, sbyte actual) => AreNotEqual<sbyte>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(sbyte expected, sbyte actual, string message) => AreNotEqual<sbyte>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(short expected, short actual) => AreNotEqual<short>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(short expected, short actual, string message) => AreNotEqual<short>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(uint expected, uint actual) => AreNotEqual<uint>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(uint expected, uint actual, string message) => AreNotEqual<uint>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(ulong expected, ulong actual) => AreNotEqual<ulong>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(ulong expected, ulong actual, string message) => AreNotEqual<ulong>(expected, actual, message);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(ushort expected, ushort actual) => AreNotEqual<ushort>(expected, actual, null);
        [Conditional("UNITY_ASSERTIONS")] public static void AreNotEqual(ushort expected, ushort actual, string message) => AreNotEqual<ushort>(expected, actual, message);

        internal const float Tolerance = 1e-5f;

        static bool Nothing<T>(T value) => value is Object o ? o == null : value == null;
        static bool Same<T>(T a, T b, IEqualityComparer<T> comparer) => a is Object || b is Object ? a as Object == b as Object : (comparer ?? EqualityComparer<T>.Default).Equals(a, b);
        static string Shown(object value) => value is null || value is Object o && o == null ? "Null" : value.ToString();
        static void Fail(string what, string expected, string message) => throw new AssertionException($"Assertion failure. {what}\n{expected}", message);
    }

    public class AssertionException : Exception
    {
        readonly string userMessage;
        public AssertionException(string message, string userMessage) : base(message) { this.userMessage = userMessage; }
        public override string Message => userMessage == null ? base.Message : userMessage + "\n" + base.Message;
    }
}
