using System;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Mean height of the water in a tank. Deep water lies level to a third of a spacing only: one probe tells no draft.</summary>
    sealed class TankLevel : IDisposable
    {
        const int Across = 16;

        readonly FluidQueryBatch batch;
        readonly int count;

        /// <param name="fluid">Its box is upright over the origin.</param>
        /// <param name="side">Of the tank, m.</param>
        /// <param name="height">At which is asked, m: in the box.</param>
        /// <param name="body">Size of what floats in the center: it and the 1.5 spacings around it are left out, m.</param>
        public TankLevel(FluidSimulation fluid, float side, float height, Vector3 body)
        {
            float margin = 1.5f * fluid.ParticleSpacing, inner = side - 2f * fluid.ParticleSpacing;
            var points = new Vector3[Across * Across];
            for (int i = 0; i < points.Length; i++)
            {
                float x = ((i % Across + 0.5f) / Across - 0.5f) * inner, z = ((i / Across + 0.5f) / Across - 0.5f) * inner;
                if (Mathf.Abs(x) > 0.5f * body.x + margin || Mathf.Abs(z) > 0.5f * body.z + margin)
                    points[count++] = new Vector3(x, height, z);
            }
            batch = new FluidQueryBatch(fluid, count);
            batch.SetPoints(points, 0, count);
        }

        /// <summary>The newest, over the world's origin, m; 0 where nothing is wet.</summary>
        public float Mean()
        {
            float sum = 0f;
            int wet = 0;
            for (int i = 0; i < count; i++)
                if (batch.TryGetSample(i, out FluidProbeSample sample) && sample.hasSurface)
                {
                    sum += sample.height;
                    wet++;
                }
            return sum / Mathf.Max(wet, 1);
        }

        public void Dispose() => batch.Dispose();
    }
}
