using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Reason that keeps the water of two fluids apart.</summary>
    enum ConnectionFault
    {
        None,
        NoFluids,
        SameFluid,
        Spacings,
        Materials,
        StepRates,
        Rotations,
        NoEnd,
        SmallOverlap,
    }

    /// <summary>Whether the particles of one fluid can become those of another, wherever their boxes are.</summary>
    static class ConnectionFaults
    {
        const float SameFraction = 1e-4f;

        public static ConnectionFault Between(FluidSimulation a, FluidSimulation b)
        {
            if (a == null || b == null)
                return ConnectionFault.NoFluids;
            if (a == b)
                return ConnectionFault.SameFluid;
            if (math.abs(a.ParticleSpacing - b.ParticleSpacing) > SameFraction * a.ParticleSpacing)
                return ConnectionFault.Spacings;
            if (!StructBytes.AreSame(a.Material, b.Material))
                return ConnectionFault.Materials;
            return a.StepRate != b.StepRate ? ConnectionFault.StepRates : ConnectionFault.None;
        }

        /// <summary>In words, with what to do; null where there is none.</summary>
        public static string Describe(ConnectionFault fault, FluidSimulation a, FluidSimulation b)
        {
            switch (fault)
            {
                case ConnectionFault.NoFluids:
                    return "it has no two fluids. Set First and Second.";
                case ConnectionFault.SameFluid:
                    return $"both ends are '{a.name}'. Set First and Second to two fluids.";
                case ConnectionFault.Spacings:
                    return Invariant($"'{a.name}' has a particle spacing of {a.ParticleSpacing} m and '{b.name}' one of ") +
                        Invariant($"{b.ParticleSpacing} m. Make them equal.");
                case ConnectionFault.Materials:
                    return $"'{a.name}' and '{b.name}' have different materials. Make them equal.";
                case ConnectionFault.StepRates:
                    return Invariant($"'{a.name}' takes {a.StepRate} steps a second and '{b.name}' {b.StepRate}. Make their Step Rates ") +
                        "equal.";
                case ConnectionFault.Rotations:
                    return $"'{a.name}' and '{b.name}' are turned differently. Give both the same rotation.";
                default:
                    return null;
            }
        }
    }
}
