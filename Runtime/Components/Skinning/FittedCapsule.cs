using System;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The capsule around points: the one of least volume, among a few axes, that holds a given fraction of them.</summary>
    struct FittedCapsule
    {
        const int PowerSteps = 32;

        public float3 center;
        /// <summary>Axis, of length 1.</summary>
        public float3 axis;
        /// <summary>From end to end.</summary>
        public float height;
        public float radius;

        public float Volume => math.PI * radius * radius * (height - 2f / 3f * radius);

        /// <param name="points">At least one.</param>
        /// <param name="weights">Weight of each point, above 0: the area that it stands for.</param>
        /// <param name="coverage">Fraction of the weight that is to be within the radius, and between the ends; 0 to 1.</param>
        /// <param name="axes">Directions to try beside the one along which the points lie; need not have length 1.</param>
        public static FittedCapsule Around(float3[] points, float[] weights, float coverage, float3[] axes)
        {
            float3 center = Center(points, weights);
            FittedCapsule best = Along(MaxAxis(points, weights, center), center, points, weights, coverage);
            foreach (float3 axis in axes)
            {
                if (!(math.lengthsq(axis) > 0f))
                    continue;
                FittedCapsule other = Along(math.normalize(axis), center, points, weights, coverage);
                if (other.Volume < best.Volume)
                    best = other;
            }
            return best;
        }

        static FittedCapsule Along(float3 axis, float3 mid, float3[] points, float[] weights, float coverage)
        {
            var across = new float[points.Length];
            var along = new float[points.Length];
            for (int i = 0; i < points.Length; i++)
            {
                float3 offset = points[i] - mid;
                along[i] = math.dot(offset, axis);
                across[i] = math.length(offset - along[i] * axis);
            }
            float radius = Quantile(across, weights, coverage);
            // A point lies within the round end of a capsule if that is centered no further in than this.
            var low = new float[points.Length];
            var high = new float[points.Length];
            for (int i = 0; i < points.Length; i++)
            {
                float depth = math.sqrt(math.max(radius * radius - across[i] * across[i], 0f));
                low[i] = along[i] + depth;
                high[i] = along[i] - depth;
            }
            float left = 0.5f * (1f - coverage);
            float from = Quantile(low, weights, left), to = Quantile(high, weights, 1f - left);
            if (from > to)
                from = to = 0.5f * (from + to);
            return new FittedCapsule
            {
                center = mid + 0.5f * (from + to) * axis, axis = axis, radius = radius, height = to - from + 2f * radius
            };
        }

        static float3 Center(float3[] points, float[] weights)
        {
            double3 sum = 0.0;
            double all = 0.0;
            for (int i = 0; i < points.Length; i++)
            {
                sum += weights[i] * (double3)points[i];
                all += weights[i];
            }
            return (float3)(sum / all);
        }

        // The direction of the largest spread, by power iteration on the covariance.
        static float3 MaxAxis(float3[] points, float[] weights, float3 center)
        {
            float3 x = 0f, y = 0f, z = 0f;
            for (int i = 0; i < points.Length; i++)
            {
                float3 offset = points[i] - center;
                x += weights[i] * offset.x * offset;
                y += weights[i] * offset.y * offset;
                z += weights[i] * offset.z * offset;
            }
            // Not at right angles to the largest: the column of the largest diagonal.
            float3 axis = x.x >= y.y && x.x >= z.z ? x : y.y >= z.z ? y : z;
            for (int i = 0; i < PowerSteps && math.lengthsq(axis) > 0f; i++)
            {
                axis = math.normalize(axis);
                axis = x * axis.x + y * axis.y + z * axis.z;
            }
            return math.lengthsq(axis) > 0f ? math.normalize(axis) : new float3(0f, 1f, 0f);
        }

        /// <summary>The least value at or below which that fraction of the weight lies.</summary>
        static float Quantile(float[] values, float[] weights, float fraction)
        {
            var sorted = (float[])values.Clone();
            var weight = (float[])weights.Clone();
            Array.Sort(sorted, weight);
            double all = 0.0, sum = 0.0;
            foreach (float w in weight)
                all += w;
            for (int i = 0; i < sorted.Length; i++)
            {
                sum += weight[i];
                if (sum >= fraction * all * (1.0 - 1e-6))
                    return sorted[i];
            }
            return sorted[sorted.Length - 1];
        }
    }
}
