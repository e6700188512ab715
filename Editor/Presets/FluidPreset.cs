using System;

namespace Rill.Editor
{
    /// <summary>A real fluid, by the two figures of it that the solver can express.</summary>
    /// <remarks>No elasticity, yield or surface tension: a fluid that is made of those has no preset.</remarks>
    sealed class FluidPreset
    {
        public readonly string Name;
        /// <summary>kg/m³.</summary>
        public readonly float Density;
        /// <summary>Dynamic, Pa s.</summary>
        public readonly float Viscosity;
        /// <summary>What the figures are at.</summary>
        public readonly string Conditions;

        public FluidPreset(string name, float density, float viscosity, string conditions)
        {
            Name = name;
            Density = density;
            Viscosity = viscosity;
            Conditions = conditions;
        }

        /// <summary>Its figures at a spacing, m, within what the solver uses.</summary>
        public FluidMaterial MaterialAt(float spacing)
        {
            FluidMaterial material = FluidMaterial.Like(Density, Viscosity, spacing);
            // Less than water's default leaves the solver's own noise; more than all of the difference in 1/60 s there is not.
            material.viscosity = Math.Min(Math.Max(material.viscosity, FluidMaterial.Water.viscosity), 1f);
            return material;
        }

        /// <summary>Figures, and what becomes of them at a spacing.</summary>
        public string Describe(float spacing)
        {
            FluidMaterial asked = FluidMaterial.Like(Density, Viscosity, spacing), used = MaterialAt(spacing);
            string text = $"{Name}: {Density:0.#} kg/m³, {Viscosity:G4} Pa s ({Conditions}).";
            if (asked.viscosity < used.viscosity)
                return $"{text} At this spacing no less than {used.DynamicViscosity(spacing):G3} Pa s can be had: a viscosity below {used.viscosity} leaves the solver's noise.";
            if (asked.viscosity > used.viscosity)
                return $"{text} At this spacing no more than {used.DynamicViscosity(spacing):G3} Pa s can be had. Raise the spacing.";
            return text;
        }
    }
}
