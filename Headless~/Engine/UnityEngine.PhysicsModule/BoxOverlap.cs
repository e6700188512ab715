namespace UnityEngine.Headless
{
    /// <summary>Whether shapes reach into a box.</summary>
    static class BoxOverlap
    {
        /// <summary>By the separating axes of two boxes: their sides and the products of their edges (Gottschalk, Lin and Manocha 1996).</summary>
        public static bool WithBox(Vector3 center, Vector3 half, Quaternion rotation, Vector3 otherCenter, Vector3 otherHalf,
            Quaternion otherRotation)
        {
            Vector3 between = otherCenter - center;
            for (int i = 0; i < 15; i++)
            {
                Vector3 axis = i < 3 ? rotation * Unit(i) : i < 6 ? otherRotation * Unit(i - 3)
                    : Vector3.Cross(rotation * Unit((i - 6) / 3), otherRotation * Unit((i - 6) % 3));
                if (axis.sqrMagnitude < 1e-6f)
                    continue;       // parallel edges
                if (Mathf.Abs(Vector3.Dot(between, axis)) > Reach(half, rotation, axis) + Reach(otherHalf, otherRotation, axis))
                    return false;
            }
            return true;
        }

        /// <summary>By the distance of the segment from the box, which has one minimum along it.</summary>
        public static bool WithCapsule(Vector3 center, Vector3 half, Quaternion rotation, Vector3 start, Vector3 end, float radius)
        {
            Quaternion back = Quaternion.Inverse(rotation);
            Vector3 from = back * (start - center), to = back * (end - center);
            float low = 0f, high = 1f;
            for (int i = 0; i < 60; i++)
            {
                float third = (high - low) / 3f;
                if (Distance(half, Vector3.Lerp(from, to, low + third)) < Distance(half, Vector3.Lerp(from, to, high - third)))
                    high -= third;
                else
                    low += third;
            }
            return Distance(half, Vector3.Lerp(from, to, 0.5f * (low + high))) <= radius;
        }

        static float Distance(Vector3 half, Vector3 point)
        {
            return new Vector3(Mathf.Max(Mathf.Abs(point.x) - half.x, 0f), Mathf.Max(Mathf.Abs(point.y) - half.y, 0f),
                Mathf.Max(Mathf.Abs(point.z) - half.z, 0f)).magnitude;
        }

        static float Reach(Vector3 half, Quaternion rotation, Vector3 axis)
        {
            Vector3 local = Quaternion.Inverse(rotation) * axis;
            return half.x * Mathf.Abs(local.x) + half.y * Mathf.Abs(local.y) + half.z * Mathf.Abs(local.z);
        }

        static Vector3 Unit(int axis)
        {
            Vector3 unit = Vector3.zero;
            unit[axis] = 1f;
            return unit;
        }
    }
}
