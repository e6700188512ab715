using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidPhysicsColliders))]
    [CanEditMultipleObjects]
    sealed class FluidPhysicsCollidersEditor : RillEditor
    {
        const string CollidersTitle = "Colliders";

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection(CollidersTitle, true,
                new InspectorField("colliderLayers"),
                new InspectorField("floatingLayers"),
                new InspectorField("meshFields")),
            new InspectorSection("Surface", true,
                new InspectorField("friction"),
                new InspectorField("bounciness"),
                new InspectorField("contributesDensity")),
            new InspectorSection("Contacts", false,
                new InspectorField("contacts.hitImpulse", "N s"),
                new InspectorField("contacts.onEnter"),
                new InspectorField("contacts.onHit"),
                new InspectorField("contacts.onExit")),
        };

        internal override InspectorSection[] Sections => AllSections;

        readonly List<string> problems = new List<string>();

        private protected override void DrawMessages()
        {
            // Both passes of a frame have to draw the same rows.
            if (Event.current.type == EventType.Layout)
            {
                problems.Clear();
                foreach (Object one in targets)
                    problems.AddIfAny(ProblemOf((FluidPhysicsColliders)one));
            }
            foreach (string problem in problems)
                EditorGUILayout.HelpBox(problem, MessageType.Warning);
        }

        // A mask of no layers carries nothing.
        static string ProblemOf(FluidPhysicsColliders colliders) => colliders.FloatingLayers.value != 0
            && colliders.TryGetComponent(out FluidSimulation fluid) ? DeepWaterState.FloatingProblem(fluid) : null;

        private protected override void DrawBelow(string title)
        {
            if (title == CollidersTitle)
                MissingFields.Draw(targets);
        }

        internal override void ListLive(List<(string label, string text)> live)
            => live.Add(("Colliders near the box", Invariant($"{((FluidPhysicsColliders)target).Taken.Count}")));
    }
}
