using System;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Texts on a preset, and on the material that it gives.</summary>
    static class PresetText
    {
        // The largest modulus is that of fluid at rest; drawn out to twice its length, where B has the trace 5, it is this much less.
        const float DrawnOut = 3f;

        const float UsualStep = 1f / 60f;

        // Smallest viscosity by which the solver itself damps eddies, d² a step; see NumericalViscosityTests.
        const double NumericalViscosity = 0.07;

        /// <summary>Figures, and what a spacing, m, leaves of them.</summary>
        public static string Describe(FluidPreset preset, float spacing)
        {
            FluidMaterial material = preset.Material;
            string conditions = preset.Conditions.Length > 0 ? $" ({preset.Conditions})" : "";
            if (material.frictionAngle > 0f || material.cohesion > 0f)
                return Invariant($"{preset.name}: {material.density:0.#} kg/m³, friction angle {material.frictionAngle:0.#}°, cohesion ") +
                    Invariant($"{material.cohesion:0.#} Pa{conditions}.");
            string text = Invariant($"{preset.name}: {material.density:0.#} kg/m³, {preset.RealViscosity:G4} Pa s{ElasticText(material, spacing)}") +
                $"{conditions}.";
            double numerical = NumericalViscosity * material.density * spacing * spacing / UsualStep;
            if (preset.RealViscosity >= numerical)
                return text;
            return Invariant($"{text} At this spacing and 60 steps a second the solver itself damps eddies as {numerical:G2} Pa s ") +
                "would, or more. Lower the spacing to see less than that.";
        }

        public static string SmoothingText(in FluidMaterial material, float spacing)
            => Invariant($"{material.SmoothingViscosity(spacing):G3} Pa s at this spacing");

        /// <param name="substep">s.</param>
        public static string ElasticityText(in FluidMaterial material, float spacing, float substep)
        {
            return Invariant($"up to {material.MaxShearModulus(spacing, substep):G3} Pa at this spacing, step rate and substeps; less ") +
                "where it is drawn out";
        }

        /// <param name="substep">s.</param>
        public static string TensionText(in FluidMaterial material, in SolverSettings settings, float spacing, float substep)
            => SurfaceTension.Text(material, settings, spacing, substep, settings.deepWater == DeepWater.On);

        static string ElasticText(in FluidMaterial material, float spacing)
        {
            if (material.shearModulus <= 0f)
                return "";
            int substeps = (int)Math.Ceiling(Math.Sqrt(DrawnOut * material.shearModulus / material.MaxShearModulus(spacing, UsualStep)));
            return Invariant($", shear modulus {material.shearModulus:G4} Pa, forgotten in {material.relaxationTime:G4} s; at this spacing ") +
                Invariant($"and 60 steps a second {substeps} substeps keep it up to twice the length");
        }
    }
}
