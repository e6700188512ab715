using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor
{
    /// <summary>Presets to choose from: those of the package, then those of the project, each by name.</summary>
    static class FluidPresets
    {
        /// <summary>Folder of the package's own.</summary>
        public const string Folder = PackagePaths.Root + "Runtime/Rendering/Presets/";

        const float SameFraction = 1e-3f;

        // Figures of real fluids, which are the same though somebody rounds them.
        static readonly string[] Measured = { nameof(FluidMaterial.density), nameof(FluidMaterial.velocitySmoothing),
            nameof(FluidMaterial.dynamicViscosity) };

        // All are floats, so that a new one belongs to every preset by itself.
        static readonly FieldInfo[] MaterialFields = typeof(FluidMaterial).GetFields(BindingFlags.Instance | BindingFlags.Public);
        static readonly FieldInfo[] LookFields = typeof(SurfaceLook).GetFields(BindingFlags.Instance | BindingFlags.Public);

        static FluidPreset[] all;
        static string[] names;

        /// <summary>All of the package and the project; a deleted one is left out.</summary>
        public static IReadOnlyList<FluidPreset> All
        {
            get
            {
                if (all == null || Array.Exists(all, preset => preset == null))
                    Find();
                return all;
            }
        }

        /// <summary>Names for a popup; the first entry means none of the presets.</summary>
        public static string[] Names => All != null ? names : null;

        [InitializeOnLoadMethod]
        static void Watch() => EditorApplication.projectChanged += Refresh;

        /// <summary>Looks for presets again when they are next asked for.</summary>
        public static void Refresh() => all = null;

        static void Find()
        {
            (FluidPreset preset, string path)[] found = AssetDatabase.FindAssets("t:" + nameof(FluidPreset)).Select(AssetDatabase.GUIDToAssetPath)
                .Select(path => (preset: AssetDatabase.LoadAssetAtPath<FluidPreset>(path), path)).Where(one => one.preset != null)
                .OrderBy(one => one.path.StartsWith(Folder, StringComparison.Ordinal) ? 0 : 1)
                .ThenBy(one => one.preset.name, StringComparer.OrdinalIgnoreCase).ThenBy(one => one.path, StringComparer.Ordinal).ToArray();
            all = found.Select(one => one.preset).ToArray();
            // A popup shows equal entries once. A slash would begin a menu below it.
            names = new[] { "Custom" }.Concat(found.Select(one => found.Count(other => other.preset.name == one.preset.name) == 1
                ? one.preset.name : $"{one.preset.name} ({one.path.Replace('/', '\u2215')})")).ToArray();
        }

        /// <summary>Number of the preset that a fluid has the material and the look of, -1 for none. A fluid without a Fluid Surface has any
        /// look.</summary>
        public static int IndexOf(FluidSimulation fluid)
        {
            var surface = fluid.GetComponent<FluidSurface>();
            for (int i = 0; i < All.Count; i++)
                if (Same(fluid.Material, All[i].Material) && (surface == null || Same(surface, All[i])))
                    return i;
            return -1;
        }

        /// <summary>Gives simulations a preset's material, and their surfaces its look, as one step of undo.</summary>
        public static void Apply(FluidPreset preset, Object[] simulations)
        {
            foreach (Object target in simulations)
            {
                using (var one = new SerializedObject(target))
                {
                    Set(one.FindProperty("material"), MaterialFields, preset.Material);
                    one.ApplyModifiedProperties();
                }
                if (!((FluidSimulation)target).TryGetComponent(out FluidSurface surface))
                    continue;
                using (var one = new SerializedObject(surface))
                {
                    one.FindProperty("preset").intValue = (int)preset.Surface;
                    Set(one.FindProperty("look"), LookFields, preset.Look);
                    one.ApplyModifiedProperties();
                }
            }
            Undo.SetCurrentGroupName($"Fluid preset {preset.name}");
        }

        /// <summary>Asks for a file and writes what a fluid has now into it as a preset.</summary>
        public static void SaveAs(FluidSimulation fluid)
        {
            string path = EditorUtility.SaveFilePanelInProject("Save as Fluid Preset", FieldAssets.FileName(fluid.name), "asset",
                "Where to keep how this fluid flows and looks.");
            if (path != "")
                Save(fluid, path);
        }

        /// <param name="path">Path in the project; a preset that is there is replaced, and references to it stay.</param>
        internal static FluidPreset Save(FluidSimulation fluid, string path)
        {
            var preset = AssetDatabase.LoadAssetAtPath<FluidPreset>(path);
            bool isNew = preset == null;
            if (isNew)
                preset = ScriptableObject.CreateInstance<FluidPreset>();
            preset.Material = fluid.Material;
            if (fluid.TryGetComponent(out FluidSurface surface))
            {
                preset.Look = surface.Look;
                preset.Surface = surface.Preset;
            }
            if (isNew)
                AssetDatabase.CreateAsset(preset, path);
            EditorUtility.SetDirty(preset);
            AssetDatabase.SaveAssetIfDirty(preset);
            Refresh();
            return preset;
        }

        static void Set(SerializedProperty property, FieldInfo[] fields, object values)
        {
            foreach (FieldInfo field in fields)
            {
                SerializedProperty one = property.FindPropertyRelative(field.Name);
                if (field.FieldType == typeof(Color))
                    one.colorValue = (Color)field.GetValue(values);
                else if (field.FieldType == typeof(bool))
                    one.boolValue = (bool)field.GetValue(values);
                else
                    one.floatValue = (float)field.GetValue(values);
            }
        }

        static bool Same(FluidSurface surface, FluidPreset preset) => preset.Surface == SurfacePreset.Custom
            ? surface.Preset == SurfacePreset.Custom && surface.Look.Equals(preset.Look) : surface.Preset == preset.Surface;

        static bool Same(in FluidMaterial a, in FluidMaterial b)
        {
            foreach (FieldInfo field in MaterialFields)
            {
                float valueOfA = ValueOf(field, a), valueOfB = ValueOf(field, b);
                if (Array.IndexOf(Measured, field.Name) >= 0 ? !Near(valueOfA, valueOfB) : valueOfA != valueOfB)
                    return false;
            }
            return true;
        }

        static float ValueOf(FieldInfo field, FluidMaterial material) => Convert.ToSingle(field.GetValue(material), CultureInfo.InvariantCulture);

        static bool Near(float a, float b) => Math.Abs(a - b) <= SameFraction * Math.Abs(b);
    }
}
