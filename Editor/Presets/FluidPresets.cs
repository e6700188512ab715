using System;
using System.Linq;
using System.Reflection;
using UnityEditor;
using Object = UnityEngine.Object;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Fluids to choose from.</summary>
    static class FluidPresets
    {
        const float SameFraction = 1e-3f;

        // Figures of real fluids, which are the same though somebody rounds them.
        static readonly string[] Measured = { nameof(FluidMaterial.density), nameof(FluidMaterial.velocitySmoothing),
            nameof(FluidMaterial.dynamicViscosity) };

        // All are floats, so that a new one belongs to every preset by itself.
        static readonly FieldInfo[] Fields = typeof(FluidMaterial).GetFields(BindingFlags.Instance | BindingFlags.Public);

        public static readonly FluidPreset[] All =
        {
            new FluidPreset("Water", FluidMaterial.Water, "20 °C", 0.001f),
            new FluidPreset("Seawater", FluidMaterial.Seawater, "20 °C, 35 g salt a kg", 0.00108f),
            new FluidPreset("Mercury", FluidMaterial.Mercury, "25 °C", 0.00153f),
            new FluidPreset("Olive oil", FluidMaterial.OliveOil, "20 °C"),
            new FluidPreset("Glycerol", FluidMaterial.Glycerol, "20 °C, pure"),
            new FluidPreset("Honey", FluidMaterial.Honey, "20 °C, typical; 2 to 20 by its water"),
            new FluidPreset("Basaltic lava", FluidMaterial.BasalticLava, "1200 °C, typical; 10 to 1000"),
            new FluidPreset("Viscoelastic slime", FluidMaterial.ViscoelasticSlime, "an order of magnitude, by its glue and borax", 0.001f),
            new FluidPreset("Pectin gel", FluidMaterial.PectinGel, "as jam is graded by, 150° SAG", 0.001f),
        };

        /// <summary>Names for a popup; the first entry means none of the presets.</summary>
        public static readonly string[] Names = new[] { "Custom" }.Concat(All.Select(preset => preset.Name)).ToArray();

        /// <summary>Number of the preset that a material has the values of, -1 for none.</summary>
        public static int IndexOf(in FluidMaterial material)
        {
            for (int i = 0; i < All.Length; i++)
                if (Same(material, All[i].Material))
                    return i;
            return -1;
        }

        /// <summary>Gives simulations a preset's material, as one step of undo.</summary>
        public static void Apply(FluidPreset preset, Object[] simulations)
        {
            foreach (Object target in simulations)
                using (var one = new SerializedObject(target))
                {
                    FluidMaterial material = preset.Material;
                    SerializedProperty property = one.FindProperty("material");
                    foreach (FieldInfo field in Fields)
                        property.FindPropertyRelative(field.Name).floatValue = ValueOf(field, material);
                    one.ApplyModifiedProperties();
                }
            Undo.SetCurrentGroupName($"Fluid preset {preset.Name}");
        }

        public static string SmoothingText(in FluidMaterial material, float spacing)
            => Invariant($"{material.SmoothingViscosity(spacing):G3} Pa s at this spacing");

        /// <param name="substep">s.</param>
        public static string ElasticityText(in FluidMaterial material, float spacing, float substep)
        {
            return Invariant($"up to {material.MaxShearModulus(spacing, substep):G3} Pa at this spacing, step rate and substeps; less ") +
                "where it is drawn out";
        }

        static bool Same(in FluidMaterial a, in FluidMaterial b)
        {
            foreach (FieldInfo field in Fields)
            {
                float valueOfA = ValueOf(field, a), valueOfB = ValueOf(field, b);
                if (Array.IndexOf(Measured, field.Name) >= 0 ? !Near(valueOfA, valueOfB) : valueOfA != valueOfB)
                    return false;
            }
            return true;
        }

        static float ValueOf(FieldInfo field, FluidMaterial material) => (float)field.GetValue(material);

        static bool Near(float a, float b) => Math.Abs(a - b) <= SameFraction * Math.Abs(b);
    }
}
