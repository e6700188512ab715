using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Result of a <see cref="FluidDetector"/> for its shape at the end of one step. World space, SI units.</summary>
    public struct FluidDetectorSample
    {
        /// <summary>Whether all below was measured. False before the first result since a restart; a volume of 0 that is valid is an empty
        /// shape.</summary>
        public bool valid;
        /// <summary>Fixed step since the restart after which it was measured.</summary>
        public int step;
        /// <summary>Fluid time of that step, s.</summary>
        public double time;
        /// <summary>Fluid time from there to the current frame when this sample was asked for, s.</summary>
        public float age;
        /// <summary>Position of the detector's center, m.</summary>
        public Vector3 position;
        /// <summary>Volume of the water in the shape at rest, m³: each particle stands for a cube of the spacing.</summary>
        public float volume;
        /// <summary>Volume over that of the shape, 0 to 1.</summary>
        public float fill;
        /// <summary>Mass of the water in the shape, kg.</summary>
        public float mass;
        /// <summary>Whether <see cref="velocity"/> was measured: there is water in the shape.</summary>
        public bool hasVelocity;
        /// <summary>Mean velocity of the water relative to the box, m/s; 0 where <see cref="hasVelocity"/> is false.</summary>
        public Vector3 velocity;
        /// <summary>Momentum of the water relative to the box, kg m/s: mass times mean velocity, which is an estimate where liquids of different
        /// densities pass each other.</summary>
        public Vector3 momentum;

        internal PhaseValues phases, masses;

        /// <summary>Volume of the water of one phase in the shape, m³.</summary>
        /// <param name="phase">As an emitter gives it, 0 to 7.</param>
        /// <exception cref="System.ArgumentOutOfRangeException">No phase has this number.</exception>
        public float VolumeOf(int phase) => phases[phase];

        /// <summary>Mass of the water of one phase in the shape, kg: its volume times the density of its material.</summary>
        /// <param name="phase">As an emitter gives it, 0 to 7.</param>
        /// <exception cref="System.ArgumentOutOfRangeException">No phase has this number.</exception>
        public float MassOf(int phase) => masses[phase];

        /// <summary>Returns what was found in one line, with units.</summary>
        public override string ToString() => !valid ? "not measured"
            : Invariant($"{volume:0.#####} m³, {fill:P0} full, velocity {velocity:0.00} m/s, step {step}, {age:0.000} s old");
    }
}
