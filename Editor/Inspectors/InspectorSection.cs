using System.Collections.Generic;
using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Fields of an inspector that belong together, behind a foldout.</summary>
    sealed class InspectorSection
    {
        public readonly string Title;
        public readonly bool StartsOpen;
        public readonly InspectorField[] Fields;

        public InspectorSection(string title, bool startsOpen, params InspectorField[] fields)
        {
            Title = title;
            StartsOpen = startsOpen;
            Fields = fields;
        }

        /// <summary>Those with a meaning for what is inspected; with several objects, for one of them at least.</summary>
        public IEnumerable<InspectorField> Shown(SerializedObject inspected)
        {
            foreach (InspectorField field in Fields)
                if (field.IsShown(inspected))
                    yield return field;
        }
    }
}
