using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>How much foam a fluid makes and how long it lasts. The same values mean the same at any particle spacing and any size of a
    /// scene.</summary>
    [Serializable]
    public struct FoamSettings
    {
        /// <summary>Most foam particles of one fluid.</summary>
        public const int MaxBudget = 1 << 22;

        /// <summary>Foam particles, as a multiple of what breaking water makes by default. 0 (none new) to 10. Costs grow with the foam
        /// that is alive, see Budget.</summary>
        [Tooltip("Foam particles, as a multiple of what breaking water makes by default. 0 (none new) to 10. Costs grow with the foam " +
            "that is alive, see Budget.")]
        [Range(0f, 10f)] public float amount;

        /// <summary>Most foam particles at a time, 1 to 4,194,304. Each takes 64 bytes of GPU memory; what does not fit is refused and
        /// counted, and none that is there is taken away.</summary>
        [Tooltip("Most foam particles at a time, 1 to 4,194,304. Each takes 64 bytes of GPU memory; what does not fit is refused and " +
            "counted, and none that is there is taken away.")]
        public int budget;

        /// <summary>Longest time that foam floats, s: each particle gets a half of it to all of it. 0.1 to 200. In the air and under water
        /// it ages a quarter as fast.</summary>
        [Tooltip("Longest time that foam floats, s: each particle gets a half of it to all of it. 0.1 to 200. In the air and under " +
            "water it ages a quarter as fast.")]
        [Range(0.1f, 200f)] public float lifetime;

        /// <summary>Speed of the scene, m/s, in which limits are measured: foam needs water that is faster than a quarter of it. 0: that of
        /// a wave as deep as the water, √(g H), with H the extent along gravity of all fluid that was put in. 0 to 1000.</summary>
        [Tooltip("Speed of the scene, m/s, in which limits are measured: foam needs water that is faster than a quarter of it. 0: that " +
            "of a wave as deep as the water, √(g H), with H the extent along gravity of all fluid that was put in. 0 to 1000.")]
        [Min(0f)] public float referenceSpeed;

        /// <summary>Depth of the scene, m, in which amounts are measured: half of it makes sixteen times the particles at twice the pace.
        /// 0: the extent along gravity of all fluid that was put in. 0 to 10,000.</summary>
        [Tooltip("Depth of the scene, m, in which amounts are measured: half of it makes sixteen times the particles at twice the " +
            "pace. 0: the extent along gravity of all fluid that was put in. 0 to 10,000.")]
        [Min(0f)] public float referenceDepth;

        /// <summary>Kinds to simulate. Particles of a disabled kind are removed: spray as it leaves the water, bubbles as they sink.</summary>
        [Tooltip("Kinds to simulate. Particles of a disabled kind are removed: spray as it leaves the water, bubbles as they sink.")]
        public FoamKinds kinds;

        /// <summary>100,000 particles that float 4 seconds.</summary>
        public static FoamSettings Default => new FoamSettings
        {
            amount = 1f,
            budget = 100000,
            lifetime = 4f,
            kinds = FoamKinds.All,
        };

        /// <summary>Puts every value into its range.</summary>
        /// <param name="problem">What was wrong and what it became; null if nothing was.</param>
        /// <returns>Whether the settings were valid as they stood.</returns>
        public bool Validate(out string problem)
        {
            problem = null;
            FoamSettings usual = Default;
            Limit.Clamp("amount", ref amount, 0f, 10f, usual.amount, ref problem);
            Limit.Clamp("budget", ref budget, 1, MaxBudget, ref problem);
            Limit.Clamp("lifetime", ref lifetime, 0.1f, 200f, usual.lifetime, ref problem);
            Limit.Clamp("reference speed", ref referenceSpeed, 0f, 1000f, 0f, ref problem);
            Limit.Clamp("reference depth", ref referenceDepth, 0f, 10000f, 0f, ref problem);
            FoamKinds given = kinds;
            kinds &= FoamKinds.All;
            if (kinds == 0)
                kinds = FoamKinds.All;
            if (kinds != given)
                Limit.Append(ref problem, Invariant($"kinds {(int)given} names none or others than spray (1), foam (2) and bubbles (4); ") +
                    Invariant($"using {(int)kinds}."));
            return problem == null;
        }
    }
}
