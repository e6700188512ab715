using System;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>Densities, viscosities, surface tensions and frictions of the phases of a fluid. A phase without a material of its own has the
    /// fluid's.</summary>
    struct PhaseMaterials
    {
        /// <summary>Number of phases that a fluid can have.</summary>
        public const int Phases = ParticleTags.MaxPhase + 1;

        /// <summary>Largest ratio of two densities in a fluid.</summary>
        public const float MaxRatio = 1000f;

        struct Row
        {
            public float density;       // kg/m³; 0 for a phase without a material of its own
            public float viscosity;     // Pa s
            public float tension;       // N/m
            public float angle;         // degrees
            public float friction;      // angle, degrees
            public float cohesion;      // Pa
        }

        int last;
        Row row1, row2, row3, row4, row5, row6, row7;
        PhasePairs diffusions;      // m²/s
        PhasePairs tensions;        // N/m; 0: by the tensions of both

        /// <summary>Largest phase with a material of its own; 0 for none.</summary>
        public int Last => last;

        /// <summary>Gives a phase a material of its own.</summary>
        /// <param name="phase">1 to 7.</param>
        /// <param name="density">kg/m³, above 0.</param>
        /// <param name="viscosity">Dynamic viscosity, Pa s.</param>
        /// <param name="tension">Surface tension, N/m.</param>
        /// <param name="angle">Contact angle, degrees.</param>
        /// <param name="friction">Friction angle of grains, degrees.</param>
        /// <param name="cohesion">Cohesion of grains, Pa.</param>
        public void Set(int phase, float density, float viscosity, float tension = 0f, float angle = 90f, float friction = 0f, float cohesion = 0f)
        {
            RowOf(ref this, phase) = new Row
            {
                density = density,
                viscosity = viscosity,
                tension = tension,
                angle = angle,
                friction = friction,
                cohesion = cohesion,
            };
            last = math.max(last, phase);
        }

        /// <summary>Says how two phases act on each other.</summary>
        /// <param name="a">Phase, 0 or one with a material of its own.</param>
        /// <param name="b">Another one.</param>
        /// <param name="diffusion">m²/s.</param>
        /// <param name="interfaceTension">N/m; 0: the difference of their tensions.</param>
        public void SetPair(int a, int b, float diffusion, float interfaceTension = 0f)
        {
            diffusions[a, b] = diffusions[b, a] = diffusion;
            tensions[a, b] = tensions[b, a] = interfaceTension;
        }

        /// <summary>Returns how fast two phases mix, m²/s; 0 where they stay apart.</summary>
        public float Diffusion(int a, int b) => diffusions[Has(a) ? a : 0, Has(b) ? b : 0];

        /// <summary>Returns the tension between two phases that their pair has, N/m; 0 where it has none of its own.</summary>
        public float InterfaceTension(int a, int b) => tensions[Has(a) ? a : 0, Has(b) ? b : 0];

        /// <summary>Returns whether two phases mix, by themselves or through others.</summary>
        public bool AreMixing(int a, int b)
        {
            int found = 1 << a, before = MaxDiffusion > 0f ? 0 : found;
            while (found != before)
            {
                before = found;
                for (int phase = 0; phase < Phases; phase++)
                    for (int other = 0; other < Phases; other++)
                        if ((before >> other & 1) != 0 && Diffusion(phase, other) > 0f)
                            found |= 1 << phase;
            }
            return (found >> b & 1) != 0;
        }

        /// <summary>How fast phases mix at most, m²/s.</summary>
        public float MaxDiffusion
        {
            get
            {
                float4 most = 0f;
                for (int phase = 0; phase <= last; phase++)
                    most = math.max(most, math.max(diffusions.low[phase], diffusions.high[phase]));
                return math.cmax(most);
            }
        }

        /// <summary>Returns the density of a phase, kg/m³.</summary>
        /// <param name="own">The fluid's own material.</param>
        public float Density(int phase, in FluidMaterial own) => Density(phase, own.density);

        /// <summary>Returns the density of a phase, kg/m³.</summary>
        /// <param name="own">Density of the fluid's own material.</param>
        public float Density(int phase, float own) => Has(phase) ? RowOf(ref this, phase).density : own;

        /// <summary>Returns the dynamic viscosity of a phase, Pa s.</summary>
        /// <param name="own">The fluid's own material.</param>
        public float Viscosity(int phase, in FluidMaterial own) => Has(phase) ? RowOf(ref this, phase).viscosity : own.dynamicViscosity;

        /// <summary>Returns the surface tension of a phase, N/m.</summary>
        /// <param name="own">The fluid's own material.</param>
        public float Tension(int phase, in FluidMaterial own) => Has(phase) ? RowOf(ref this, phase).tension : own.surfaceTension;

        /// <summary>Returns the contact angle of a phase, degrees.</summary>
        /// <param name="own">The fluid's own material.</param>
        public float Angle(int phase, in FluidMaterial own) => Has(phase) ? RowOf(ref this, phase).angle : own.contactAngle;

        /// <summary>Returns the friction angle of a phase, degrees.</summary>
        /// <param name="own">The fluid's own material.</param>
        public float FrictionAngle(int phase, in FluidMaterial own) => Has(phase) ? RowOf(ref this, phase).friction : own.frictionAngle;

        /// <summary>Returns the cohesion of a phase, Pa.</summary>
        /// <param name="own">The fluid's own material.</param>
        public float Cohesion(int phase, in FluidMaterial own) => Has(phase) ? RowOf(ref this, phase).cohesion : own.cohesion;

        /// <summary>Returns the largest friction angle, degrees.</summary>
        public float MaxFrictionAngle(in FluidMaterial own)
        {
            float most = own.frictionAngle;
            for (int phase = 1; phase <= last; phase++)
                most = math.max(most, FrictionAngle(phase, own));
            return most;
        }

        /// <summary>Returns the largest cohesion, Pa.</summary>
        public float MaxCohesion(in FluidMaterial own)
        {
            float most = own.cohesion;
            for (int phase = 1; phase <= last; phase++)
                most = math.max(most, Cohesion(phase, own));
            return most;
        }

        /// <summary>Returns whether any phase is of grains; loose balls are none.</summary>
        public bool HaveGrains(in FluidMaterial own) => !own.contacts && (MaxFrictionAngle(own) > 0f || MaxCohesion(own) > 0f);

        /// <summary>Returns whether any phase has surface tension; loose balls have none.</summary>
        public bool HaveTension(in FluidMaterial own)
        {
            bool any = own.surfaceTension > 0f;
            for (int phase = 1; phase <= last; phase++)
                any |= Tension(phase, own) > 0f;
            return any && !own.contacts;
        }

        /// <summary>Returns the density of the heaviest phase, kg/m³.</summary>
        public float Heaviest(in FluidMaterial own)
        {
            float heaviest = own.density;
            for (int phase = 1; phase <= last; phase++)
                heaviest = math.max(heaviest, Density(phase, own));
            return heaviest;
        }

        /// <summary>Returns the ratio of the heaviest phase's density to the lightest's.</summary>
        public float Ratio(in FluidMaterial own)
        {
            float lightest = own.density;
            for (int phase = 1; phase <= last; phase++)
                lightest = math.min(lightest, Density(phase, own));
            return Heaviest(own) / lightest;
        }

        /// <summary>Returns the largest dynamic viscosity, Pa s.</summary>
        public float MaxViscosity(in FluidMaterial own)
        {
            float most = own.dynamicViscosity;
            for (int phase = 1; phase <= last; phase++)
                most = math.max(most, Viscosity(phase, own));
            return most;
        }

        /// <summary>Returns the largest kinematic viscosity, m²/s.</summary>
        public double MaxKinematicViscosity(in FluidMaterial own)
        {
            double most = 0.0;
            for (int phase = 0; phase <= last; phase++)
                most = math.max(most, Viscosity(phase, own) / (double)Density(phase, own));
            return most;
        }

        /// <summary>Returns whether a phase differs from the fluid's own material.</summary>
        public bool Differ(in FluidMaterial own)
        {
            bool differ = false;
            for (int phase = 1; phase <= last; phase++)
                differ |= Density(phase, own) != own.density || Viscosity(phase, own) != own.dynamicViscosity
                    || FrictionAngle(phase, own) != own.frictionAngle || Cohesion(phase, own) != own.cohesion
                    || math.any(tensions.low[phase] != 0f) || math.any(tensions.high[phase] != 0f)
                    || Tension(phase, own) != own.surfaceTension || Tension(phase, own) > 0f && Angle(phase, own) != own.contactAngle;
            return differ;
        }

        /// <summary>Returns the same materials without viscosity.</summary>
        public PhaseMaterials WithoutViscosity()
        {
            PhaseMaterials thin = this;
            for (int phase = 1; phase <= last; phase++)
                RowOf(ref thin, phase).viscosity = 0f;
            return thin;
        }

        /// <summary>Returns the same materials as liquids.</summary>
        public PhaseMaterials WithoutFriction()
        {
            PhaseMaterials liquid = this;
            for (int phase = 1; phase <= last; phase++)
                RowOf(ref liquid, phase).friction = RowOf(ref liquid, phase).cohesion = 0f;
            return liquid;
        }

        /// <summary>Returns the same materials, which stay apart.</summary>
        public PhaseMaterials WithoutDiffusion()
        {
            PhaseMaterials apart = this;
            apart.diffusions = default;
            return apart;
        }

        bool Has(int phase) => phase > 0 && phase <= last && RowOf(ref this, phase).density > 0f;

        static ref Row RowOf(ref PhaseMaterials of, int phase)
        {
            switch (phase)
            {
                case 1: return ref of.row1;
                case 2: return ref of.row2;
                case 3: return ref of.row3;
                case 4: return ref of.row4;
                case 5: return ref of.row5;
                case 6: return ref of.row6;
                case 7: return ref of.row7;
                default: throw new ArgumentOutOfRangeException(nameof(phase));
            }
        }
    }
}
