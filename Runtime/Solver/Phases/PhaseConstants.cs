using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>Materials of the phases, for the kernels that weigh particles.</summary>
    [GenerateHlsl("Phases", ConstantBuffer = "RillPhases")]
    [StructLayout(LayoutKind.Sequential)]
    struct PhaseConstants
    {
        /// <summary>x: mass of a particle, relative to the heaviest phase's; y: its inverse; z: viscosity, relative to the largest</summary>
        public PhaseRows phases;

        /// <summary>largest phase of a particle</summary>
        [GenerateHlsl("Phases")] public const int MaxPhase = ParticleTags.MaxPhase;

        public static PhaseConstants For(in StepInput input)
        {
            FluidMaterial own = input.material;
            PhaseMaterials phases = input.phases;
            float heaviest = phases.Heaviest(own), maxViscosity = math.max(phases.MaxViscosity(own), 1e-12f);
            float4 Row(int phase)
            {
                float mass = math.max(phases.Density(phase, own) / heaviest, 1f / PhaseMaterials.MaxRatio);
                return new float4(mass, 1f / mass, phases.Viscosity(phase, own) / maxViscosity, 0f);
            }
            return new PhaseConstants
            {
                phases = new PhaseRows
                {
                    phase0 = Row(0),
                    phase1 = Row(1),
                    phase2 = Row(2),
                    phase3 = Row(3),
                    phase4 = Row(4),
                    phase5 = Row(5),
                    phase6 = Row(6),
                    phase7 = Row(7),
                },
            };
        }
    }

    /// <summary>A row for each phase: an array to the shaders.</summary>
    struct PhaseRows
    {
        public float4 phase0, phase1, phase2, phase3, phase4, phase5, phase6, phase7;
    }
}
