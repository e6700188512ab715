using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>Materials of the phases, for the kernels that weigh particles.</summary>
    [GenerateHlsl("Phases", ConstantBuffer = "RillPhases")]
    [StructLayout(LayoutKind.Sequential)]
    struct PhaseConstants
    {
        /// <summary>x: mass over the heaviest phase's; y: its inverse; z: viscosity over the largest; w: bits of those that it mixes with</summary>
        public PhaseRows phases;

        /// <summary>x: attraction by walls, relative to that of a pair with the largest surface tension; y: friction of grains over the mass of
        /// a particle, z: their cohesion, d²</summary>
        public PhaseRows walls;

        /// <summary>attraction of a pair with phases 0 to 3, relative to that of one with the largest surface tension</summary>
        public PhaseRows lowAttractions;

        /// <summary>the same with phases 4 to 7</summary>
        public PhaseRows highAttractions;

        /// <summary>largest phase of a particle</summary>
        [GenerateHlsl("Phases")] public const int MaxPhase = ParticleTags.MaxPhase;

        /// <param name="spacing">m.</param>
        /// <param name="deepWater">Whether the coarse grid acts.</param>
        public static PhaseConstants For(in StepInput input, float spacing, bool deepWater)
        {
            FluidMaterial own = input.material;
            float heaviest = input.phases.Heaviest(own), maxViscosity = math.max(input.phases.MaxViscosity(own), 1e-12f);
            double maxTension = math.max(SurfaceTension.Strength(input, spacing, deepWater), 1e-30);
            var constants = new PhaseConstants();
            for (int phase = 0; phase < PhaseMaterials.Phases; phase++)
            {
                float mass = math.max(input.phases.Density(phase, own) / heaviest, 1f / PhaseMaterials.MaxRatio);
                float tension = (float)(SurfaceTension.Strength(input, phase, spacing, deepWater) / maxTension);
                double wall = SurfaceTension.WallFraction(input.phases.Angle(phase, own));
                constants.phases[phase] = new float4(mass, 1f / mass, input.phases.Viscosity(phase, own) / maxViscosity,
                    MixesWith(phase, input.phases));
                float angle = input.phases.FrictionAngle(phase, own), friction = GrainFriction.Coefficient(angle) / mass;
                float cohesion = GrainFriction.Cohesion(input.phases.Cohesion(phase, own), angle, mass * heaviest, spacing, input.SubstepTime);
                constants.walls[phase] = new float4((float)(tension * wall), friction, cohesion, 0f);
            }
            if (SurfaceTension.IsNeeded(input))
                SetAttractions(ref constants, input, spacing, deepWater, 1.0 / maxTension);
            return constants;
        }

        static void SetAttractions(ref PhaseConstants constants, in StepInput input, float spacing, bool deepWater, double scale)
        {
            var attractions = new PhasePairs();
            for (int phase = 0; phase < PhaseMaterials.Phases; phase++)
                for (int other = 0; other < PhaseMaterials.Phases; other++)
                    attractions[phase, other] = (float)(scale * SurfaceTension.Attraction(input, phase, other, spacing, deepWater));
            constants.lowAttractions = attractions.low;
            constants.highAttractions = attractions.high;
        }

        static float MixesWith(int phase, in PhaseMaterials phases)
        {
            int bits = 0;
            for (int other = 0; other < PhaseMaterials.Phases; other++)
                if (phases.Diffusion(phase, other) > 0f)
                    bits |= 1 << other;
            return bits;
        }
    }

    /// <summary>A row for each phase: an array to the shaders.</summary>
    struct PhaseRows
    {
        public float4 phase0, phase1, phase2, phase3, phase4, phase5, phase6, phase7;

        public float4 this[int phase]
        {
            readonly get
            {
                switch (phase)
                {
                    case 0: return phase0;
                    case 1: return phase1;
                    case 2: return phase2;
                    case 3: return phase3;
                    case 4: return phase4;
                    case 5: return phase5;
                    case 6: return phase6;
                    case 7: return phase7;
                    default: throw new ArgumentOutOfRangeException(nameof(phase));
                }
            }
            set
            {
                switch (phase)
                {
                    case 0: phase0 = value; break;
                    case 1: phase1 = value; break;
                    case 2: phase2 = value; break;
                    case 3: phase3 = value; break;
                    case 4: phase4 = value; break;
                    case 5: phase5 = value; break;
                    case 6: phase6 = value; break;
                    case 7: phase7 = value; break;
                    default: throw new ArgumentOutOfRangeException(nameof(phase));
                }
            }
        }
    }

    /// <summary>A value for each pair of phases, as PhasePairs.hlsl reads it.</summary>
    struct PhasePairs
    {
        /// <summary>Values of each phase with phases 0 to 3, and with phases 4 to 7.</summary>
        public PhaseRows low, high;

        public float this[int phase, int other]
        {
            readonly get => other < 4 ? low[phase][other] : high[phase][other - 4];
            set
            {
                float4 row = other < 4 ? low[phase] : high[phase];
                row[other & 3] = value;
                if (other < 4)
                    low[phase] = row;
                else
                    high[phase] = row;
            }
        }
    }
}
