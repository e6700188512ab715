using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidCollider))]
    [CanEditMultipleObjects]
    sealed class FluidColliderEditor : RillEditor
    {
        const string ShapeTitle = "Shape";

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection(ShapeTitle, true,
                new InspectorField("shape"),
                new InspectorField("center", "m", When.IsNot("shape", ColliderShape.Mesh, ColliderShape.HeightField)),
                new InspectorField("size", "m", When.Is("shape", ColliderShape.Box)),
                new InspectorField("radius", "m", When.Is("shape", ColliderShape.Sphere, ColliderShape.Capsule)),
                new InspectorField("height", "m", When.Is("shape", ColliderShape.Capsule)),
                new InspectorField("field", when: When.Is("shape", ColliderShape.Mesh)),
                new InspectorField("insideOut", when: When.IsNot("shape", ColliderShape.HeightField))),
            new InspectorSection("Surface", true,
                new InspectorField("friction"),
                new InspectorField("bounciness"),
                new InspectorField("contributesDensity")),
            new InspectorSection("Reaction", false,
                new InspectorField("measuresForce")),
            new InspectorSection("Contacts", false,
                new InspectorField("contacts.hitImpulse", "N s"),
                new InspectorField("contacts.onEnter"),
                new InspectorField("contacts.onHit"),
                new InspectorField("contacts.onExit")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidCollider)of, out bounds);

        private protected override void DrawBelow(string title)
        {
            if (title == ShapeTitle)
                BakeButton.Draw<FluidCollider>(targets, NeedsField);
        }

        internal override void ListLive(List<(string label, string text)> live)
        {
            var collider = (FluidCollider)target;
            bool known = collider.TryGetForce(out Vector3 force, out Vector3 torque);
            if (!known && !collider.MeasuresForce)
                return;
            live.Add(("Force", known ? Invariant($"{force.x:0.##}, {force.y:0.##}, {force.z:0.##} N") : "not known yet"));
            if (known)
                live.Add(("Torque", Invariant($"{torque.x:0.##}, {torque.y:0.##}, {torque.z:0.##} N m about its center")));
        }

        static bool NeedsField(FluidCollider collider)
            => collider.Shape == ColliderShape.Mesh && collider.Field == null && collider.Deforming == null;

        void OnSceneGUI() => ColliderHandles.Draw((FluidCollider)target);
    }
}
