using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;

namespace Rill
{
    /// <summary>Asks the water of a <see cref="FluidSimulation"/> at one point: density, velocity, phase, and the surface above or below.</summary>
    /// <remarks>
    /// Measured after the last step of each frame; the result comes two or three frames later, without waiting, and says of which step it
    /// is. A simulation takes 64 probes. The surface is where half the rest density is, the highest such point on the line along gravity.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Probe"), Icon(PackagePaths.Icon), ManualPage("queries.md")]
    public sealed class FluidProbe : FluidQuery
    {
        [Tooltip("Radius of the ball whose submerged fraction is given, m. Above 0.")]
        [SerializeField] float radius = 0.1f;

        FluidProbeSample latest;
        QueryFrame frame;       // of which it is

        /// <summary>Radius of the ball whose submerged fraction is given, m. Out-of-range values are clamped with a warning.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }

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
            if (frame.spacing > 0f)
                sample.Shift(Simulation.WorldShift - frame.shift, frame.up);
            sample.age = latest.step > 0 || latest.valid ? AgeOf(latest.time) : 0f;
            return sample.valid;
        }

        internal override void OnRestart()
        {
            base.OnRestart();
            latest = default;
            frame = default;
        }

        /// <param name="words">What came back, of this probe from <paramref name="at"/> on.</param>
        internal void SetResult(in QueryFrame frame, Vector3 position, bool isOutside, NativeArray<uint> words, int at)
        {
            this.frame = frame;
            latest = QueryResults.Probe(frame, words, at, position, isOutside, radius);
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
