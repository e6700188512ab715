using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Result of a <see cref="FluidProbe"/> at the end of one step. World space, SI units.</summary>
    public struct FluidProbeSample
    {
        /// <summary>Whether all below was measured. False before the first result since a restart, and where the probe was outside the
        /// fluid's box.</summary>
        public bool valid;
        /// <summary>Fixed step since the restart after which it was measured.</summary>
        public int step;
        /// <summary>Fluid time of that step, s.</summary>
        public double time;
        /// <summary>Fluid time from there to the current frame when this sample was asked for, s.</summary>
        public float age;
        /// <summary>Position of the probe, m.</summary>
        public Vector3 position;
        /// <summary>Density of the water there relative to rest: about 1 in water, 0.5 at its surface, 0 in air.</summary>
        public float density;
        /// <summary>Whether <see cref="velocity"/> and <see cref="phase"/> were measured: there is water within two particle spacings.</summary>
        public bool hasVelocity;
        /// <summary>Velocity of the water around the probe relative to the box, m/s; 0 where <see cref="hasVelocity"/> is false.</summary>
        public Vector3 velocity;
        /// <summary>Phase of most of the water around the probe, 0 to 7.</summary>
        public int phase;
        /// <summary>Whether there is a surface on the line through the probe along gravity. Without one the values below are 0.</summary>
        public bool hasSurface;
        /// <summary>The highest point of that line that is in water, m.</summary>
        public Vector3 surfacePoint;
        /// <summary>Height of that point against gravity over the world's origin, m: its y where gravity points down.</summary>
        public float height;
        /// <summary>How fast that height grows by the velocity of the water there, m/s.</summary>
        public float heightRate;
        /// <summary>How far the probe is below that point along gravity, m; negative above it.</summary>
        public float depth;
        /// <summary>Normal of the surface there, out of the water, length 1.</summary>
        public Vector3 normal;
        /// <summary>Velocity of the water at the surface there relative to the box, m/s.</summary>
        public Vector3 surfaceVelocity;
        /// <summary>Fraction of a ball around the probe, of its <see cref="FluidProbe.Radius"/>, that lies below the plane of the surface:
        /// 0 to 1.</summary>
        public float submerged;

        /// <summary>The height that <see cref="heightRate"/> makes of <see cref="height"/> until the frame in which the sample was asked
        /// for, m: without the lag, and wrong by what changed its course since.</summary>
        public float ExtrapolatedHeight => height + heightRate * age;

        /// <summary>Returns what was found in one line, with units.</summary>
        public override string ToString()
        {
            if (!valid)
                return "not measured";
            string water = hasVelocity ? Invariant($"density {density:0.00} of rest, velocity {velocity:0.00} m/s") : "no water near";
            string surface = hasSurface ? Invariant($"surface at {height:0.000} m, {depth:0.000} m above") : "no surface";
            return Invariant($"at {position:0.000} m, step {step}, {age:0.000} s old: ") + water + ", " + surface;
        }

        /// <param name="by">By which the box and its water were put elsewhere since, m.</param>
        /// <param name="up">Against gravity, length 1; 0 without gravity.</param>
        internal void Shift(Vector3 by, Vector3 up)
        {
            position += by;
            if (!hasSurface)
                return;
            surfacePoint += by;
            height += Vector3.Dot(by, up);
        }
    }
}
