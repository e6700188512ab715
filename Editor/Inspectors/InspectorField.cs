using System;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>A serialized field as an inspector shows it: with its unit, and only where the other choices give it a meaning.</summary>
    sealed class InspectorField
    {
        public readonly string Path;
        readonly Func<SerializedObject, string> unit;
        readonly Func<SerializedObject, bool> isShown;
        string tooltip;

        /// <param name="path">As SerializedObject.FindProperty takes it.</param>
        /// <param name="unit">As it stands behind the value; null for none.</param>
        /// <param name="when">Where it has a meaning; null for always.</param>
        public InspectorField(string path, string unit = null, Func<SerializedObject, bool> when = null) : this(path, _ => unit, when) { }

        /// <param name="unit">Where the unit depends on another choice.</param>
        public InspectorField(string path, Func<SerializedObject, string> unit, Func<SerializedObject, bool> when = null)
        {
            Path = path;
            this.unit = unit;
            isShown = when;
        }

        public string Unit(SerializedObject inspected) => unit(inspected);

        public bool IsShown(SerializedObject inspected) => isShown == null || isShown(inspected);

        public GUIContent Label(SerializedObject inspected, SerializedProperty property)
        {
            tooltip ??= FieldTooltip.Of(inspected.targetObject.GetType(), Path);
            return new GUIContent(Owner(inspected) + property.displayName, tooltip);
        }

        // A value of one of several structs alike, as borders.minX.width, is named with its struct: Min X Width.
        string Owner(SerializedObject inspected)
        {
            int end = Path.LastIndexOf('.');
            return end > 0 && Path.IndexOf('.') < end ? inspected.FindProperty(Path.Substring(0, end)).displayName + " " : "";
        }
    }
}
