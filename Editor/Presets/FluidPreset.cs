using System;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>A real fluid to choose, with a text on it.</summary>
    sealed class FluidPreset
    {
        public readonly string Name;
        /// <summary>Dynamic, Pa s: also of one so thin that its material has none.</summary>
        public readonly float Viscosity;
        /// <summary>Its figures, the same at every spacing.</summary>
        public readonly FluidMaterial Material;
        /// <summary>Conditions that the figures hold for.</summary>
        public readonly string Conditions;

        // The largest modulus is that of fluid at rest; drawn out to twice its length, where B has the trace 5, it is this much less.
        const float DrawnOut = 3f;

        const float UsualStep = 1f / 60f;

        // Smallest viscosity by which the solver itself damps eddies, d² a step; see NumericalViscosityTests.
        const double NumericalViscosity = 0.07;

        /// <param name="thinViscosity">Pa s, of one whose material has none.</param>
        public FluidPreset(string name, FluidMaterial material, string conditions, float thinViscosity = 0f)
        {
            Name = name;
            Material = material;
            Viscosity = thinViscosity > 0f ? thinViscosity : material.dynamicViscosity;
            Conditions = conditions;
        }

        /// <summary>Figures, and what a spacing, m, leaves of them.</summary>
        public string Describe(float spacing)
        {
            string text = Invariant($"{Name}: {Material.density:0.#} kg/m³, {Viscosity:G4} Pa s{ElasticText(spacing)} ({Conditions}).");
            double numerical = NumericalViscosity * Material.density * spacing * spacing / UsualStep;
            if (Viscosity >= numerical)
                return text;
            return Invariant($"{text} At this spacing and 60 steps a second the solver itself damps eddies as {numerical:G2} Pa s ") +
                "would, or more. Lower the spacing to see less than that.";
        }

        string ElasticText(float spacing)
        {
            if (Material.shearModulus <= 0f)
                return "";
            int substeps = (int)Math.Ceiling(Math.Sqrt(DrawnOut * Material.shearModulus / Material.MaxShearModulus(spacing, UsualStep)));
            return Invariant($", shear modulus {Material.shearModulus:G4} Pa, forgotten in {Material.relaxationTime:G4} s; at this spacing ") +
                Invariant($"and 60 steps a second {substeps} substeps keep it up to twice the length");
        }
    }
}
