using System;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The limits of foam in a scene, as FoamSources.compute takes them: fixed fractions of the scene's own speed and depth, in d
    /// and s.</summary>
    readonly struct FoamScales
    {
        /// <summary>Fractions of the scene's speed: slower water makes no foam, water faster than the second makes all that it can.</summary>
        public const double MinSpeed = 0.25, MaxSpeed = 0.5;
        /// <summary>Fraction of the scene's speed over its depth: water that is sheared and pressed together more slowly traps no air, faster
        /// than twice that all that it can.</summary>
        public const double MinStrain = 2.0;
        /// <summary>Strain times the length of a substep that the solver's passes leave in nine of ten particles of water that flows as one.
        /// Its square is subtracted from what is measured.</summary>
        public const double SolverStrain = 0.025;
        /// <summary>Mean of 1 - cosine between normals from which a bend is a crest, and from which it is all of one.</summary>
        public const double MinBend = 0.1, MaxBend = 0.5;
        /// <summary>Foam particles along the scene's depth that broken water, and crests, make while a wave goes as far.</summary>
        public const double TrappedAir = 50.0, Crest = 50.0;
        /// <summary>Fraction of the scene's speed with which bubbles rise.</summary>
        public const double Rise = 0.1;

        /// <summary>d/s and d.</summary>
        public readonly double Speed, Depth;
        /// <summary>See _FoamLimits and _FoamRates in FoamSources.compute.</summary>
        public readonly float4 Limits, Rates;

        /// <param name="settings">Validated.</param>
        /// <param name="gravity">Its strength, m/s².</param>
        /// <param name="depth">Depth of the water, d.</param>
        /// <param name="spacing">d, m.</param>
        /// <param name="step">s.</param>
        /// <param name="substeps">Number of substeps of the step.</param>
        public FoamScales(in FoamSettings settings, double gravity, double depth, double spacing, double step, int substeps)
        {
            Depth = settings.referenceDepth > 0f ? settings.referenceDepth / spacing : depth;
            Speed = settings.referenceSpeed > 0f ? settings.referenceSpeed / spacing : Math.Sqrt(gravity / spacing * Depth);
            bool isKnown = Speed > 0.0 && Depth > 0.0;
            double low = MinSpeed * Speed, high = MaxSpeed * Speed;
            double rate = isKnown ? Speed / Depth : 0.0, made = settings.amount * rate * step;
            double solver = SolverStrain * substeps / step;
            Limits = new float4(isKnown ? (float)(low * low) : float.MaxValue, isKnown ? (float)(1.0 / (high * high - low * low)) : 0f,
                isKnown ? (float)(MinStrain * rate) : 1f, (float)(solver * solver));
            Rates = isKnown ? new float4((float)(made * Math.Pow(TrappedAir / Depth, 3.0)), (float)(made * Math.Pow(Crest / Depth, 3.0)),
                (float)MinBend, (float)(1.0 / (MaxBend - MinBend))) : 0f;
        }
    }
}
