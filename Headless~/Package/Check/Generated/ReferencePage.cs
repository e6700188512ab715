using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using UnityEditor;
using UnityEngine;

namespace Host.Check
{
    /// <summary>The manual's page of every component's fields, from their tooltips, ranges and default values.</summary>
    sealed class ReferencePage : GeneratedFile
    {
        const string OfThePackage = "Runtime/Simulation/FluidSimulation.cs";

        // Those of the render pipelines are compiled against stand-ins and stay out.
        static readonly string[] Assemblies = { "Rill", "Rill.Physics", "Rill.Terrain" };

        public override string Path => "Documentation~/reference.md";

        public override string Text(PackageTree package, Findings findings)
        {
            if (!package.Has(OfThePackage))
                return null;
            var components = new List<Type>();
            foreach (string name in Assemblies)
            {
                Assembly assembly = Compiled(package, name, findings);
                if (assembly == null)
                    return null;
                components.AddRange(assembly.GetTypes().Where(type => !type.IsAbstract && type.IsPublic
                    && typeof(MonoBehaviour).IsAssignableFrom(type) && type.GetCustomAttribute<AddComponentMenu>() != null));
            }

            var text = new StringBuilder();
            text.Append("<!-- Made by `Headless~/rill generate` from the tooltips, ranges and default values in the code; `rill check` " +
                "compares it. Do not edit. -->\n");
            text.Append("# Component reference\n\n");
            text.Append("Every field of every component, as its tooltip has it. *Range* is what the inspector's control allows; where it is " +
                "empty, the text names the limits.\n\n");
            text.Append("*Cost* is GPU time of a step of 100,000 / 1,000,000 particles on an NVIDIA H100, unless noted otherwise; " +
                "`Headless~/rill bench fields` measures it, [Cost by class of GPU](cost.md) scales it to others. Where it is empty, a field costs " +
                "nothing of its own.\n");
            var costs = FieldCosts.Of(package.Read(FieldCosts.File), findings);
            foreach (Type type in components.OrderBy(type => type.Name != "FluidSimulation").ThenBy(Title, StringComparer.Ordinal))
                text.Append(Describe(type, costs));
            costs.FindUnused(findings);
            return text.ToString();
        }

        /// <summary>A component's part of the page: its heading, and a table for its own fields and for each group of settings.</summary>
        /// <param name="costs">Null for a page without them.</param>
        public static string Describe(Type component, FieldCosts costs = null)
        {
            // Inactive: nothing of it begins, but its fields have the values that a new component has.
            var holder = new GameObject("Reference");
            holder.SetActive(false);
            try
            {
                object instance = holder.AddComponent(component);
                string title = Title(component);
                var text = new StringBuilder($"\n## {title}\n");
                if (costs?.For(title, "") is string whole && whole.Length > 0)
                    text.Append($"\nCost: {whole}.\n");
                var groups = new List<(string name, object value)>();
                var rows = new List<string>();
                foreach (FieldInfo field in Fields(component).OrderBy(field => ObjectNames.NicifyVariableName(field.Name), StringComparer.Ordinal))
                {
                    object value = field.GetValue(instance);
                    if (IsGroup(field.FieldType))
                        groups.Add((ObjectNames.NicifyVariableName(field.Name), value));
                    else
                        rows.Add(Row(field, value, title, costs));
                }
                AppendTable(text, null, rows, costs);
                foreach ((string name, object value) in groups)
                    AppendGroup(text, name, value, title, costs);
                return text.ToString();
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(holder);
            }
        }

        // Groups within a group are alike and get one table, named after their type.
        static void AppendGroup(StringBuilder text, string name, object value, string component, FieldCosts costs)
        {
            FieldInfo[] fields = Fields(value.GetType()).ToArray();
            AppendTable(text, name, fields.Select(field => Row(field, field.GetValue(value), component, costs)), costs);
            foreach (var inner in fields.Where(field => IsGroup(field.FieldType)).GroupBy(field => field.FieldType))
                AppendGroup(text, ObjectNames.NicifyVariableName(inner.Key.Name), inner.First().GetValue(value), component, costs);
        }

        static string Title(Type component) => component.GetCustomAttribute<AddComponentMenu>().componentMenu.Split('/').Last();

        // Order as declared. Over several files it is unknown, so components sort their fields by name.
        static IEnumerable<FieldInfo> Fields(Type type)
        {
            const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            IEnumerable<FieldInfo> inherited = type.BaseType == null || type.BaseType == typeof(MonoBehaviour) ? Enumerable.Empty<FieldInfo>()
                : Fields(type.BaseType);
            return inherited.Concat(type.GetFields(Own).Where(IsShown).OrderBy(field => field.MetadataToken));
        }

        static bool IsShown(FieldInfo field) => (field.IsPublic || field.GetCustomAttribute<SerializeField>() != null) && !field.IsNotSerialized
            && !field.IsInitOnly && field.GetCustomAttribute<HideInInspector>() == null;

        static bool IsGroup(Type type) => type.IsValueType && !type.IsPrimitive && !type.IsEnum && type.Namespace != nameof(UnityEngine)
            && type.GetCustomAttribute<SerializableAttribute>() != null;

        static void AppendTable(StringBuilder text, string title, IEnumerable<string> rows, FieldCosts costs)
        {
            if (!rows.Any())
                return;
            text.Append(title == null ? "\n" : $"\n**{title}**\n\n");
            text.Append(costs == null ? "| field | default | range | |\n| --- | --- | --- | --- |\n"
                : "| field | default | range | | cost |\n| --- | --- | --- | --- | --- |\n");
            foreach (string row in rows)
                text.Append(row).Append('\n');
        }

        static string Row(FieldInfo field, object value, string component, FieldCosts costs)
        {
            string description = field.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";
            string name = ObjectNames.NicifyVariableName(field.Name);
            string row = $"| {name} | {Value(value)} | {Range(field)} | {description.Replace("|", "\\|").Replace("\n", " ")} |";
            return costs == null ? row : $"{row} {costs.For(component, name)} |";
        }

        static string Range(FieldInfo field)
        {
            if (field.GetCustomAttribute<RangeAttribute>() is RangeAttribute range)
                return $"{Number(range.min)} to {Number(range.max)}";
            if (field.GetCustomAttribute<MinAttribute>() is MinAttribute min)
                return $"{Number(min.min)} or more";
            return field.FieldType.IsEnum ? string.Join(", ", Enum.GetNames(field.FieldType).Select(ObjectNames.NicifyVariableName)) : "";
        }

        static string Value(object value) => value switch
        {
            null => "none",
            UnityEngine.Events.UnityEventBase => "none",
            UnityEngine.Object asset => asset == null ? "none" : asset.name,
            LayerMask layers => layers.value == 0 ? "nothing" : layers.value == ~0 ? "everything" : "some layers",
            bool isOn => isOn ? "on" : "off",
            float number => Number(number),
            Vector3 vector => $"{Number(vector.x)}, {Number(vector.y)}, {Number(vector.z)}",
            Color color => $"{Number(color.r)}, {Number(color.g)}, {Number(color.b)}",
            Rect rect => $"{Number(rect.x)}, {Number(rect.y)}, {Number(rect.width)}, {Number(rect.height)}",
            ICollection list => list.Count == 0 ? "none" : $"{list.Count} entries",
            Enum choice => ObjectNames.NicifyVariableName(choice.ToString()),
            _ => Convert.ToString(value, CultureInfo.InvariantCulture),
        };

        static string Number(float number) => number.ToString("0.#######", CultureInfo.InvariantCulture);
    }
}
