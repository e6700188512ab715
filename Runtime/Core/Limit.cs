using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Clamps settings and reports what it clamped.</summary>
    static class Limit
    {
        /// <summary>Clamps a value; NaN becomes <paramref name="fallback"/>.</summary>
        public static void Clamp(string name, ref float value, float low, float high, float fallback, ref string problem)
        {
            float given = value;
            if (float.IsNaN(given) || float.IsInfinity(given))
                value = fallback;
            else if (given < low)
                value = low;
            else if (given > high)
                value = high;
            else
                return;
            Append(ref problem, Invariant($"{name} {given} is outside {low} to {high}; using {value}."));
        }

        public static void Clamp(string name, ref int value, int low, int high, ref string problem)
        {
            int given = value;
            if (given < low)
                value = low;
            else if (given > high)
                value = high;
            else
                return;
            Append(ref problem, Invariant($"{name} {given} is outside {low} to {high}; using {value}."));
        }

        /// <summary>Replaces a vector with NaN or infinite components by <paramref name="fallback"/>.</summary>
        public static void Finite(string name, ref Vector3 value, Vector3 fallback, ref string problem)
        {
            Vector3 given = value;
            float sum = given.x + given.y + given.z;
            if (!float.IsNaN(sum) && !float.IsInfinity(sum))
                return;
            value = fallback;
            Append(ref problem, Invariant($"{name} {given} is not finite; using {value}."));
        }

        /// <summary>Whether all components of a transform's position and rotation are numbers.</summary>
        public static bool IsPose(Vector3 position, Quaternion rotation)
        {
            float sum = position.x + position.y + position.z + rotation.x + rotation.y + rotation.z + rotation.w;
            return !float.IsNaN(sum) && !float.IsInfinity(sum);
        }

        /// <summary>Returns the exception for misuse of the API.</summary>
        /// <remarks>The value is a part of the text: the exception itself would format it by the user's culture.</remarks>
        public static ArgumentOutOfRangeException OutOfRange(string parameter, object given, string problem) =>
            new ArgumentOutOfRangeException(parameter, Invariant($"{problem} {given} was given."));

        /// <summary>Adds a sentence to those so far; null is none.</summary>
        public static void Append(ref string problem, string text)
        {
            if (text != null)
                problem = problem == null ? text : problem + " " + text;
        }
    }
}
