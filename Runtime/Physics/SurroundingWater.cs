using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>The water around a body, asked of one fluid at points beside it: levels and motion of the surface, a few frames old.</summary>
    sealed class SurroundingWater : IDisposable
    {
        public const int MaxPoints = 8;

        readonly FluidQueryBatch batch;
        readonly Vector3[] points = new Vector3[MaxPoints];
        readonly float[] levels = new float[MaxPoints];
        int asked, wet, dry;

        public SurroundingWater(FluidSimulation fluid)
        {
            Fluid = fluid;
            batch = new FluidQueryBatch(fluid, MaxPoints);
        }

        public FluidSimulation Fluid { get; }

        /// <summary>Whether an answer has come yet.</summary>
        public bool IsAnswered => wet + dry > 0;

        /// <summary>Takes a level instead of an answer that has not come yet.</summary>
        public void Assume(float level)
        {
            wet = 1;
            Level = levels[0] = level;
        }

        /// <summary>Whether most of the points that were answered have water.</summary>
        public bool HasWater => wet > 0 && wet >= dry;

        /// <summary>Mean height of the surface where there is water, against gravity from the world's origin, m.</summary>
        public float Level { get; private set; }

        /// <summary>Mean velocity of the surface there relative to the fluid's box, m/s.</summary>
        public Vector3 Velocity { get; private set; }

        /// <summary>Mean density of the water where there is some beside the points, kg/m³; 0 where none is known.</summary>
        public float Density { get; private set; }

        /// <summary>Begins the points of the next question.</summary>
        public void Clear() => asked = 0;

        /// <param name="point">World space, m.</param>
        public void AddPoint(Vector3 point) => points[asked++] = point;

        /// <summary>Asks at the points, and takes the newest answer.</summary>
        public void Update()
        {
            batch.SetPoints(points, 0, asked);
            Read();
        }

        /// <summary>Takes the newest answer.</summary>
        public void Read()
        {
            wet = dry = 0;
            Level = 0f;
            Velocity = Vector3.zero;
            float density = 0f;
            int weighed = 0;
            for (int i = 0; i < MaxPoints; i++)
            {
                if (!batch.TryGetSample(i, out FluidProbeSample sample))
                    continue;
                if (sample.hasVelocity)
                {
                    density += Fluid.Phases.Density(sample.phase, Fluid.Material.density);
                    weighed++;
                }
                if (!sample.hasSurface)
                {
                    dry++;
                    continue;
                }
                levels[wet++] = sample.height;
                Level += sample.height;
                Velocity += sample.surfaceVelocity;
            }
            Level /= Math.Max(wet, 1);
            Velocity /= Math.Max(wet, 1);
            Density = weighed > 0 ? density / weighed : Density;
        }

        /// <summary>Puts the answers, and those that are pending, into a snapshot.</summary>
        public void Save(SnapshotWater to, SnapshotCapture capture) => batch.Save(to, capture);

        /// <summary>Takes them out of one. Of one that has asked nothing.</summary>
        /// <param name="moved">How far the fluid is from where it was, m.</param>
        public void Load(SnapshotWater from, Vector3 moved) => batch.Load(from, moved);

        /// <summary>Mean depth of a height under the surface, m: 0 over it, and without water.</summary>
        public float DepthOf(float height)
        {
            float sum = 0f;
            for (int i = 0; i < wet; i++)
                sum += math.max(levels[i] - height, 0f);
            return sum / Math.Max(wet + dry, 1);
        }

        public void Dispose() => batch.Dispose();
    }
}
