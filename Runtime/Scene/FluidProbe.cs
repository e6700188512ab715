using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Asks the water of a <see cref="FluidSimulation"/> at one point: density, velocity, phase, and the surface above or below.</summary>
    /// <remarks>
    /// Measured after the last step of each frame; the result comes two or three frames later, without waiting, and says of which step it
    /// is. A simulation takes 64 probes. The surface is where half the rest density is, the highest such point on the line along gravity.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Probe")]
    public sealed class FluidProbe : FluidQuery
    {
        [Tooltip("Radius of the ball whose submerged fraction is given, m. Above 0.")]
        [SerializeField] float radius = 0.1f;

        const float MinSteepness = 0.2f;        // of the normal along gravity: a steeper surface rises no faster

        FluidProbeSample latest;

        /// <summary>Radius of the ball whose submerged fraction is given, m. Out-of-range values are clamped with a warning.</summary>
        public float Radius { get => radius; set { radius = value; Validate(); } }

        /// <summary>The newest sample, whether it is valid or not.</summary>
        public FluidProbeSample Latest
        {
            get
            {
                TryGetSample(out FluidProbeSample sample);
                return sample;
            }
        }

        /// <summary>The newest sample, a few frames old; its age is that of this call.</summary>
        /// <returns>Whether it is valid: false before the first since the fluid started, while this or the fluid is off, and where the
        /// probe was outside the fluid's box.</returns>
        public bool TryGetSample(out FluidProbeSample sample)
        {
            sample = default;
            if (!IsAnswered)
                return false;
            sample = latest;
            sample.age = latest.step > 0 ? AgeOf(latest.time) : 0f;
            return sample.valid;
        }

        internal override void OnRestart()
        {
            base.OnRestart();
            latest = default;
        }

        internal void SetResult(in QueryFrame frame, Vector3 position, bool isOutside, Queries queries, int slot, int index)
        {
            latest = default;
            latest.step = frame.step;
            latest.time = frame.time;
            latest.position = position;
            if (isOutside)
                return;
            var flags = (ProbeFlag)queries.ProbeResult(slot, index, ProbeWord.Flags);
            latest.valid = true;
            latest.density = queries.ProbeValue(slot, index, ProbeWord.Density);
            latest.hasVelocity = (flags & ProbeFlag.NearWater) != 0;
            if (latest.hasVelocity)
            {
                latest.velocity = frame.rotation * (queries.ProbeVector(slot, index, ProbeWord.Velocity) * frame.spacing);
                latest.phase = (int)queries.ProbeResult(slot, index, ProbeWord.Phase);
            }
            latest.hasSurface = (flags & ProbeFlag.HasSurface) != 0;
            if (!latest.hasSurface)
                return;
            float above = queries.ProbeValue(slot, index, ProbeWord.Height) * frame.spacing;
            latest.depth = above;
            latest.surfacePoint = position + frame.up * above;
            latest.height = Vector3.Dot(latest.surfacePoint, frame.up);
            latest.normal = frame.rotation * queries.ProbeVector(slot, index, ProbeWord.Normal);
            latest.surfaceVelocity = frame.rotation * (queries.ProbeVector(slot, index, ProbeWord.SurfaceVelocity) * frame.spacing);
            latest.heightRate = Vector3.Dot(latest.surfaceVelocity, latest.normal) / math.max(Vector3.Dot(latest.normal, frame.up), MinSteepness);
            latest.submerged = FractionOfBall(above * Vector3.Dot(latest.normal, frame.up) / radius);
        }

        /// <summary>Fraction of a ball that lies below a plane this far above its centre, in radii.</summary>
        internal static float FractionOfBall(float above)
        {
            float h = math.clamp(above, -1f, 1f) + 1f;
            return h * h * (3f - h) * 0.25f;
        }

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Clamp("radius", ref radius, 1e-4f, 1e4f, 0.1f, ref problem);
            return problem;
        }

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems) { }
    }
}
