using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Events;

namespace Rill
{
    /// <summary>Asks the water of a <see cref="FluidSimulation"/> at one point: density, velocity, phase, and the surface above or below.</summary>
    /// <remarks>
    /// Measured after the last step of each frame; the result comes two or three frames later, without waiting, and says of which step it
    /// is. A simulation takes 64 probes. The surface is where half the rest density is, the highest such point on the line along gravity.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Probe"), Icon(PackagePaths.Icon), ManualPage("queries", "fluid-probe")]
    public sealed class FluidProbe : FluidQuery, IProbe
    {
        [Tooltip("Radius of the ball whose submerged fraction is given, m. Above 0.")]
        [SerializeField] float radius = 0.1f;

        [Tooltip("Change of the height of the surface after which On Level Changed is called again, m. 0 calls it at each change.")]
        [SerializeField] float levelStep = 0.01f;

        [Tooltip("Called with the height of the surface, m, when it has changed by Level Step, and with the first one.")]
        [SerializeField] UnityEvent<float> onLevelChanged = new UnityEvent<float>();

        FluidProbeSample latest;
        QueryFrame frame;       // of which it is
        [NonSerialized] bool isNew;
        [NonSerialized] LevelWatch level;
        Delegates<Action<float>> levelChanged;

        /// <summary>Radius of the ball whose submerged fraction is given, m. Out-of-range values are clamped with a warning.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }

        /// <summary>Change of the height of the surface after which <see cref="OnLevelChanged"/> is called again, m. Out-of-range
        /// values are clamped with a warning.</summary>
        public float LevelStep { get => levelStep; set { levelStep = value; Changed(); } }

        /// <summary>Called with the height of the surface, m, as in <see cref="FluidProbeSample.height"/>, when it has changed by
        /// <see cref="LevelStep"/> since the last call, and with the first one since the fluid started. Not called without a surface.</summary>
        public event Action<float> OnLevelChanged { add => levelChanged.Add(value); remove => levelChanged.Remove(value); }

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
                sample.Shift(Simulation.Box.WorldShift - frame.shift, frame.up);
            sample.age = latest.step > 0 || latest.valid ? AgeOf(latest.time) : 0f;
            return sample.valid;
        }

        /// <summary>Measures the water as it stands at this moment and waits for it: see <see cref="FluidSimulation.MeasureQueriesNow"/>, which costs
        /// no more for all of a fluid at once.</summary>
        /// <returns>The sample, which is not valid while this or the fluid is off.</returns>
        public FluidProbeSample MeasureNow()
        {
            Measure();
            return Latest;
        }

        internal override PartKind PartKind => PartKind.Probe;

        internal override void OnRestart()
        {
            base.OnRestart();
            latest = default;
            frame = default;
            isNew = false;
            level = default;
        }

        /// <param name="words">What came back, of this probe from <paramref name="at"/> on.</param>
        void IProbe.SetResult(in QueryFrame frame, Vector3 position, bool isOutside, NativeArray<uint> words, int at)
        {
            this.frame = frame;
            latest = QueryResults.Probe(frame, words, at, position, isOutside, radius);
            isNew = true;
        }

        internal override void RaiseEvents()
        {
            if (!isNew)
                return;
            isNew = false;
            if (TryGetSample(out FluidProbeSample now) && now.hasSurface && level.Follow(now.height, levelStep))
                Listeners.Raise(onLevelChanged, levelChanged, now.height, this);
        }

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Clamp("radius", ref radius, 1e-4f, 1e4f, 0.1f, ref problem);
            Limit.Clamp("level step", ref levelStep, 0f, 1e6f, 0.01f, ref problem);
            return problem;
        }

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems) { }
    }
}
