using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidEmitter))]
    [CanEditMultipleObjects]
    sealed class FluidEmitterEditor : RillEditor
    {
        const string FlowTitle = "Flow";

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Shape", true,
                new InspectorField("simulation"),
                new InspectorField("shape"),
                new InspectorField("size", "m", When.Is("shape", EmitterShape.Box)),
                new InspectorField("radius", "m", When.Is("shape", EmitterShape.Sphere, EmitterShape.Disc)),
                new InspectorField("mesh", when: When.Is("shape", EmitterShape.MeshSurface))),
            new InspectorSection(FlowTitle, true,
                new InspectorField("mode", when: When.IsNot("shape", EmitterShape.MeshSurface)),
                new InspectorField("rate", "m³/s"),
                new InspectorField("speed", "m/s"),
                new InspectorField("spread", "degrees"),
                new InspectorField("inheritVelocity")),
            new InspectorSection("Time", false,
                new InspectorField("playOnEnable"),
                new InspectorField("delay", "s"),
                new InspectorField("duration", "s")),
            new InspectorSection("Particles", false,
                new InspectorField("material"),
                new InspectorField("phase", when: When.IsNull("material")),
                new InspectorField("lifetime", "s")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidEmitter)of, out bounds);

        private protected override void DrawBelow(string title)
        {
            if (title != FlowTitle || targets.Length > 1)
                return;
            var emitter = (FluidEmitter)target;
            FluidSimulation fluid = MissingPart.FluidOf(emitter);
            if (fluid == null || !(fluid.ParticleSpacing > 0f))
                return;
            InspectorRows.Text("Lets in", EmissionEstimate.RateText(emitter, fluid));
            InspectorRows.Text("Capacity", EmissionEstimate.CapacityText(emitter, fluid));
        }

        internal override void ListLive(List<(string label, string text)> live)
        {
            var emitter = (FluidEmitter)target;
            live.Add(("State", emitter.IsEmitting ? "lets fluid in" : "off"));
            live.Add(("Leaves at", Invariant($"{emitter.LeavingVelocity.magnitude:0.##} m/s, its own velocity included")));
            live.Add(("Emitted",
                Invariant($"{emitter.Emitted:N0} particles, {emitter.EmittedVolume:0.####} m³ of {emitter.DueVolume:0.####} m³ due ") +
                "since its start"));
            live.Add(("Waiting for room", Invariant($"{emitter.Waiting:N0}, given up {emitter.Blocked:N0}, refused by the capacity ") +
                Invariant($"{emitter.Refused:N0}")));
        }

        private protected override void DrawLive()
        {
            var emitter = (FluidEmitter)target;
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button("Start"))
                    emitter.StartEmission();
                if (GUILayout.Button("Stop"))
                    emitter.StopEmission();
            }
        }

        void OnSceneGUI()
        {
            var emitter = (FluidEmitter)target;
            bool fills = emitter.Mode == EmitterMode.Fill;
            switch (emitter.Shape)
            {
                case EmitterShape.Box:
                    ShapeHandles.Box(emitter, "size", !fills, GizmoColors.Emitter);
                    break;
                case EmitterShape.Sphere:
                case EmitterShape.Disc:
                    ShapeHandles.Sphere(emitter, "radius", !fills || emitter.Shape == EmitterShape.Disc, GizmoColors.Emitter);
                    break;
            }
        }
    }
}
