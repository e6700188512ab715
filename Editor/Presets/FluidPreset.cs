using System;

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

        // Keep an elastic fluid whole: without tension it swells where it is drawn out, and tension without pressure between near ones makes clumps.
        const float ElasticTension = 0.05f, ElasticPressure = 0.1f;

        // The largest modulus is that of fluid at rest; drawn out to twice its length, where B has the trace 5, it is this much less.
        const float DrawnOut = 3f;

        const float UsualStep = 1f / 60f;

        public FluidPreset(string name, float density, float viscosity, string conditions, float shearModulus = 0f, float relaxationTime = 1f)
        {
            Name = name;
            Density = density;
            Viscosity = viscosity;
            ShearModulus = shearModulus;
            RelaxationTime = relaxationTime;
            Conditions = conditions;
        }

        /// <summary>Its figures at a spacing, m, within what the solver uses.</summary>
        public FluidMaterial MaterialAt(float spacing)
        {
            FluidMaterial material = FluidMaterial.Like(Density, Viscosity, spacing);
            // Less than water's default leaves the solver's own noise; more than all of the difference in 1/60 s there is not.
            material.viscosity = Math.Min(Math.Max(material.viscosity, FluidMaterial.Water.viscosity), 1f);
            if (ShearModulus <= 0f)
                return material;
            material.shearModulus = ShearModulus;
            material.relaxationTime = RelaxationTime;
            material.allowedTension = ElasticTension;
            material.artificialPressure = ElasticPressure;
            return material;
        }

        /// <summary>Figures, and what becomes of them at a spacing.</summary>
        public string Describe(float spacing)
        {
            FluidMaterial asked = FluidMaterial.Like(Density, Viscosity, spacing), used = MaterialAt(spacing);
            string text = $"{Name}: {Density:0.#} kg/m³, {Viscosity:G4} Pa s{ElasticText(used, spacing)} ({Conditions}).";
            if (asked.viscosity < used.viscosity)
                return $"{text} At this spacing no less than {used.DynamicViscosity(spacing):G3} Pa s can be had: a viscosity below {used.viscosity} leaves the solver's noise.";
            if (asked.viscosity > used.viscosity)
                return $"{text} At this spacing no more than {used.DynamicViscosity(spacing):G3} Pa s can be had. Raise the spacing.";
            return text;
        }

        string ElasticText(in FluidMaterial material, float spacing)
        {
            if (ShearModulus <= 0f)
                return "";
            int substeps = (int)Math.Ceiling(Math.Sqrt(DrawnOut * ShearModulus / material.LargestShearModulus(spacing, UsualStep)));
            return $", shear modulus {ShearModulus:G4} Pa, forgotten in {RelaxationTime:G4} s; at this spacing and 60 steps a second {substeps} substeps keep it up to twice the length";
        }
    }
}
