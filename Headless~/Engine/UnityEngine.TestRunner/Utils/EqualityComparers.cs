using System;
using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils
{
    public static class Utils
    {
        /// <summary>Difference relative to the larger of the two and 1.</summary>
        public static bool AreFloatsEqual(float expected, float actual, float epsilon)
        {
            if (expected == actual)
                return true;
            return Math.Abs(actual - expected) <= epsilon * Mathf.Max(1f, Mathf.Max(Mathf.Abs(expected), Mathf.Abs(actual)));
        }

        public static bool AreFloatsEqualAbsoluteError(float expected, float actual, float allowedAbsoluteError)
            => Math.Abs(actual - expected) <= allowedAbsoluteError;
    }

    public class FloatEqualityComparer : IEqualityComparer<float>
    {
        readonly float error;
        public static FloatEqualityComparer Instance { get; } = new FloatEqualityComparer(0.0001f);
        public FloatEqualityComparer(float allowedError) => error = allowedError;
        public bool Equals(float expected, float actual) => Utils.AreFloatsEqual(expected, actual, error);
        public int GetHashCode(float value) => 0;
    }

    public class ColorEqualityComparer : IEqualityComparer<Color>
    {
        readonly float error;
        public static ColorEqualityComparer Instance { get; } = new ColorEqualityComparer(0.01f);
        public ColorEqualityComparer(float error) => this.error = error;
        public bool Equals(Color expected, Color actual) =>
            Utils.AreFloatsEqualAbsoluteError(expected.r, actual.r, error) && Utils.AreFloatsEqualAbsoluteError(expected.g, actual.g, error) &&
            Utils.AreFloatsEqualAbsoluteError(expected.b, actual.b, error) && Utils.AreFloatsEqualAbsoluteError(expected.a, actual.a, error);
        public int GetHashCode(Color color) => 0;
    }

    /// <summary>Two quaternions of the same rotation are equal, whichever sign they have.</summary>
    public class QuaternionEqualityComparer : IEqualityComparer<Quaternion>
    {
        readonly float error;
        public static QuaternionEqualityComparer Instance { get; } = new QuaternionEqualityComparer(0.00001f);
        public QuaternionEqualityComparer(float allowedError) => error = allowedError;
        public bool Equals(Quaternion expected, Quaternion actual) => Mathf.Abs(Quaternion.Dot(expected, actual)) > 1.0f - error;
        public int GetHashCode(Quaternion quaternion) => 0;
    }

    public class Vector2EqualityComparer : IEqualityComparer<Vector2>
    {
        readonly float error;
        public static Vector2EqualityComparer Instance { get; } = new Vector2EqualityComparer(0.0001f);
        public Vector2EqualityComparer(float error) => this.error = error;
        public bool Equals(Vector2 expected, Vector2 actual) => Utils.AreFloatsEqual(expected.x, actual.x, error)
            && Utils.AreFloatsEqual(expected.y, actual.y, error);
        public int GetHashCode(Vector2 vec2) => 0;
    }

    public class Vector3EqualityComparer : IEqualityComparer<Vector3>
    {
        readonly float error;
        public static Vector3EqualityComparer Instance { get; } = new Vector3EqualityComparer(0.0001f);
        public Vector3EqualityComparer(float allowedError) => error = allowedError;
        public bool Equals(Vector3 expected, Vector3 actual) =>
            Utils.AreFloatsEqual(expected.x, actual.x, error) && Utils.AreFloatsEqual(expected.y, actual.y, error)
            && Utils.AreFloatsEqual(expected.z, actual.z, error);
        public int GetHashCode(Vector3 vec3) => 0;
    }

    public class Vector4EqualityComparer : IEqualityComparer<Vector4>
    {
        readonly float error;
        public static Vector4EqualityComparer Instance { get; } = new Vector4EqualityComparer(0.0001f);
        public Vector4EqualityComparer(float allowedError) => error = allowedError;
        public bool Equals(Vector4 expected, Vector4 actual) =>
            Utils.AreFloatsEqual(expected.x, actual.x, error) && Utils.AreFloatsEqual(expected.y, actual.y, error) &&
            Utils.AreFloatsEqual(expected.z, actual.z, error) && Utils.AreFloatsEqual(expected.w, actual.w, error);
        public int GetHashCode(Vector4 vec4) => 0;
    }

    public class Vector2ComparerWithEqualsOperator : IEqualityComparer<Vector2>
    {
        public static Vector2ComparerWithEqualsOperator Instance { get; } = new Vector2ComparerWithEqualsOperator();
        public bool Equals(Vector2 expected, Vector2 actual) => expected == actual;
        public int GetHashCode(Vector2 vec2) => 0;
    }

    public class Vector3ComparerWithEqualsOperator : IEqualityComparer<Vector3>
    {
        public static Vector3ComparerWithEqualsOperator Instance { get; } = new Vector3ComparerWithEqualsOperator();
        public bool Equals(Vector3 expected, Vector3 actual) => expected == actual;
        public int GetHashCode(Vector3 vec3) => 0;
    }

    public class Vector4ComparerWithEqualsOperator : IEqualityComparer<Vector4>
    {
        public static Vector4ComparerWithEqualsOperator Instance { get; } = new Vector4ComparerWithEqualsOperator();
        public bool Equals(Vector4 expected, Vector4 actual) => expected == actual;
        public int GetHashCode(Vector4 vec4) => 0;
    }
}
