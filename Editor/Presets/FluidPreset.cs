using System;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>A real fluid, by the figures of it that the solver can express.</summary>
    /// <remarks>No yield or surface tension: a fluid that is made of those has no preset.</remarks>
    sealed class FluidPreset
    {
        public readonly string Name;
        /// <summary>kg/m³.</summary>
        public readonly float Density;
        /// <summary>Dynamic, Pa s.</summary>
        public readonly float Viscosity;
        /// <summary>Pa; 0 for a fluid that is not elastic.</summary>
        public readonly float ShearModulus;
        /// <summary>s.</summary>
        public readonly float RelaxationTime;
        /// <summary>What the figures are at.</summary>
        public readonly string Conditions;

        // Keep a fluid whole that is elastic or so thick that it draws threads: without tension it swells or comes apart where it is drawn out,
        // and tension without pressure between near ones makes clumps.
        const float Tension = 0.05f, TensionPressure = 0.1f;

        const float ThreadViscosity = 5f;      // Pa s

        // The largest modulus is that of fluid at rest; drawn out to twice its length, where B has the trace 5, it is this much less.
        const float DrawnOut = 3f;

        const float UsualStep = 1f / 60f;

        // Pa s. Thinner fluids are as water is: passes for their viscosity would cost time and change nothing that is seen.
        const float MinViscosity = 0.01f;

        // What the solver itself damps eddies by at least, d² a step; see NumericalViscosityTests.
        const double NumericalViscosity = 0.07;

        public FluidPreset(string name, float density, float viscosity, string conditions, float shearModulus = 0f, float relaxationTime = 1f)
        {
            Name = name;
            Density = density;
            Viscosity = viscosity;
            ShearModulus = shearModulus;
            RelaxationTime = relaxationTime;
            Conditions = conditions;
        }

        /// <summary>Its figures, the same at every spacing.</summary>
        public FluidMaterial Material
        {
            get
            {
                FluidMaterial material = FluidMaterial.Viscous(Density, Viscosity < MinViscosity ? 0f : Viscosity);
                bool isElastic = ShearModulus > 0f;
                if (isElastic)
                {
                    material.shearModulus = ShearModulus;
                    material.relaxationTime = RelaxationTime;
                }
                if (isElastic || Viscosity >= ThreadViscosity)
                {
                    material.allowedTension = Tension;
                    material.artificialPressure = TensionPressure;
                }
                return material;
            }
        }

        /// <summary>Figures, and what a spacing, m, leaves of them.</summary>
        public string Describe(float spacing)
        {
            string text = Invariant($"{Name}: {Density:0.#} kg/m³, {Viscosity:G4} Pa s{ElasticText(Material, spacing)} ({Conditions}).");
            double numerical = NumericalViscosity * Density * spacing * spacing / UsualStep;
            if (Viscosity >= numerical)
                return text;
            return Invariant($"{text} At this spacing and 60 steps a second the solver itself damps eddies as {numerical:G2} Pa s ") +
                "would, or more. Lower the spacing to see less than that.";
        }

        string ElasticText(in FluidMaterial material, float spacing)
        {
            if (ShearModulus <= 0f)
                return "";
            int substeps = (int)Math.Ceiling(Math.Sqrt(DrawnOut * ShearModulus / material.MaxShearModulus(spacing, UsualStep)));
            return Invariant($", shear modulus {ShearModulus:G4} Pa, forgotten in {RelaxationTime:G4} s; at this spacing and 60 steps a ") +
                Invariant($"second {substeps} substeps keep it up to twice the length");
        }
    }
}
