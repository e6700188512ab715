using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Simulations and what acts on them in the scene view.</summary>
    static class FluidGizmos
    {
        const float ArrowTime = 0.1f;       // s of the path that an arrow shows
        const float BorderArrowTime = 1f;   // s, at an open side of the box
        const float ArrowLength = 0.3f;     // m, of what has no speed
        const int DiscSides = 24;

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawDomain(FluidSimulation simulation, GizmoType type)
        {
            DrawBox(simulation.transform, simulation.DomainSize, GizmoColors.Domain);
            FluidBorders borders = simulation.Borders.In(simulation.DomainSize, simulation.ParticleSpacing);
            for (int side = 0; side < FluidBorders.Sides; side++)
            {
                if (borders[side].kind != BorderKind.Wall)
                    DrawBorder(simulation, side, borders[side]);
            }
        }

        // The inner edge of the band; of an open side also the level, and the velocity as an arrow.
        static void DrawBorder(FluidSimulation simulation, int side, in FluidBorder border)
        {
            Vector3 box = simulation.DomainSize, inwards = Vector3.zero;
            int axis = FluidBorders.AxisOf(side);
            inwards[axis] = FluidBorders.IsUpper(side) ? -1f : 1f;
            Transform at = simulation.transform;
            bool isOpen = border.kind == BorderKind.Open;
            Gizmos.color = !isOpen || border.velocity == 0f ? GizmoColors.Domain : border.velocity > 0f ? GizmoColors.Emitter : GizmoColors.Drain;
            // The floor at the center of the side is the origin, and z points into the box.
            Gizmos.matrix = Matrix4x4.TRS(at.position, at.rotation, Vector3.one) *
                Matrix4x4.TRS(-0.5f * (box[axis] * inwards + box.y * Vector3.up), Quaternion.LookRotation(inwards), Vector3.one);
            float length = box[2 - axis];
            Gizmos.DrawWireCube(new Vector3(0f, 0.5f * box.y, border.width), new Vector3(length, box.y, 0f));
            if (!isOpen)
                return;
            Gizmos.DrawWireCube(new Vector3(0f, border.level, 0.5f * border.width), new Vector3(length, 0f, border.width));
            Gizmos.matrix *= Matrix4x4.Translate(border.level * Vector3.up);
            DrawArrow(BorderArrowTime * border.velocity);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawVolume(FluidVolume volume, GizmoType type)
        {
            Color color = GizmoColors.Volume;
            if (volume.Shape == VolumeShape.SignedDistanceField)
            {
                SetPose(volume.transform, volume.transform.lossyScale, color);
                if (volume.Field != null)
                    Gizmos.DrawWireCube(volume.Field.Bounds.center, volume.Field.Bounds.size);
            }
            else if (volume.Shape == VolumeShape.Sphere)
                DrawSphere(volume.transform, volume.Radius, color);
            else
                DrawBox(volume.transform, volume.Size, color);
            VolumePreview.Draw(volume);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawEmitter(FluidEmitter emitter, GizmoType type)
        {
            Color color = GizmoColors.Emitter;
            switch (emitter.Shape)
            {
                case EmitterShape.Box:
                    DrawBox(emitter.transform, emitter.Mode == EmitterMode.Fill ? emitter.Size
                        : Vector3.Scale(emitter.Size, new Vector3(1f, 1f, 0f)), color);
                    break;
                case EmitterShape.Sphere when emitter.Mode == EmitterMode.Fill:
                    DrawSphere(emitter.transform, emitter.Radius, color);
                    break;
                case EmitterShape.MeshSurface:
                    SetPose(emitter.transform, emitter.transform.lossyScale, color);
                    if (emitter.Mesh != null)
                        Gizmos.DrawWireMesh(emitter.Mesh);
                    return;
                default:
                    DrawDisc(emitter.transform, emitter.Radius, color);
                    break;
            }
            Vector3 leaves = emitter.LeavingVelocity;       // aside where the emitter moves
            Gizmos.matrix = Matrix4x4.TRS(emitter.transform.position, leaves == Vector3.zero ? emitter.transform.rotation
            : Quaternion.LookRotation(leaves, emitter.transform.up), Vector3.one);
            DrawArrow(ArrowTime * leaves.magnitude);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawDrain(FluidDrain drain, GizmoType type)
        {
            Color color = GizmoColors.Drain;
            if (drain.Shape == DrainShape.Sphere)
                DrawSphere(drain.transform, drain.Radius, color);
            else
                DrawBox(drain.transform, drain.Size, color);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawField(FluidForceField field, GizmoType type)
        {
            Color color = GizmoColors.ForceField;
            if (field.Bounds == ForceFieldBounds.Sphere)
                DrawSphere(field.transform, field.Radius, color);
            else if (field.Bounds == ForceFieldBounds.Box)
                DrawBox(field.transform, field.Size, color);
            if (field.Kind != ForceFieldKind.Point)
                DrawArrow(field.transform, field.Kind == ForceFieldKind.Wind ? ArrowTime * field.Strength : ArrowLength, color);
            else
                DrawSphere(field.transform, 0.1f * ArrowLength, color);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawSmokeSource(FluidSmokeSource source, GizmoType type)
        {
            DrawSphere(source.transform, source.Radius, GizmoColors.Emitter);
            if (source.Speed > 0f)
                DrawArrow(source.transform, ArrowTime * source.Speed, GizmoColors.Emitter);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawProbe(FluidProbe probe, GizmoType type)
        {
            DrawSphere(probe.transform, probe.Radius, GizmoColors.Query);
            if (!probe.TryGetSample(out FluidProbeSample sample) || !sample.hasSurface)
                return;
            Gizmos.matrix = Matrix4x4.identity;
            Gizmos.DrawLine(sample.position, sample.surfacePoint);
            Gizmos.DrawLine(sample.surfacePoint, sample.surfacePoint + 2f * probe.Radius * sample.normal);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawDetector(FluidDetector detector, GizmoType type)
        {
            if (detector.Shape == DetectorShape.Box)
                DrawBox(detector.transform, detector.Size, GizmoColors.Query);
            else if (detector.Shape == DetectorShape.Mesh)
                DrawField(detector.transform, detector.Field, GizmoColors.Query);
            else
                DrawSphere(detector.transform, detector.Radius, GizmoColors.Query);
            if (detector.Shape != DetectorShape.Capsule)
                return;
            float straight = Mathf.Max(0.5f * detector.Height - detector.Radius, 0f);
            Gizmos.DrawWireSphere(straight * Vector3.up, detector.Radius);
            Gizmos.DrawWireSphere(straight * Vector3.down, detector.Radius);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawCollider(FluidCollider collider, GizmoType type)
        {
            Transform at = collider.transform;
            Vector3 scale = at.lossyScale;
            float even = Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
            Gizmos.color = collider.isActiveAndEnabled ? GizmoColors.Collider : GizmoColors.Collider * new Color(1f, 1f, 1f, 0.3f);
            Gizmos.matrix = Matrix4x4.TRS(collider.WorldCenter, at.rotation, Vector3.one);
            switch (collider.Shape)
            {
                case ColliderShape.Sphere:
                    Gizmos.DrawWireSphere(Vector3.zero, even * collider.Radius);
                    break;
                case ColliderShape.Capsule:
                    float radius = Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.z)) * collider.Radius;
                    float straight = Mathf.Max(0.5f * Mathf.Abs(scale.y) * collider.Height - radius, 0f);
                    Gizmos.DrawWireSphere(straight * Vector3.up, radius);
                    Gizmos.DrawWireSphere(straight * Vector3.down, radius);
                    break;
                case ColliderShape.Box:
                    Gizmos.DrawWireCube(Vector3.zero, Vector3.Scale(collider.Size, scale));
                    break;
                case ColliderShape.Plane:
                    Gizmos.DrawWireCube(Vector3.zero, new Vector3(2f, 0f, 2f));
                    Gizmos.DrawLine(Vector3.zero, 0.5f * Vector3.up);
                    break;
                case ColliderShape.HeightField when collider.Heights != null:
                    Gizmos.matrix = Matrix4x4.Translate(collider.WorldCenter);
                    Gizmos.DrawWireCube(Vector3.zero, 2f * (Vector3)collider.Heights.Extents);
                    break;
                case ColliderShape.Mesh when collider.Deforming != null:
                    Gizmos.matrix = collider.Deforming.FieldToWorld;
                    Gizmos.DrawWireCube(Vector3.zero, collider.Deforming.Grid.Bounds.size);
                    break;
                case ColliderShape.Mesh when collider.Field != null:
                    Gizmos.DrawWireCube(Vector3.zero, even * collider.Field.Bounds.size);
                    break;
            }
        }

        static void DrawBox(Transform at, Vector3 size, Color color)
        {
            SetPose(at, Vector3.one, color);
            Gizmos.DrawWireCube(Vector3.zero, size);
        }

        static void DrawField(Transform at, SignedDistanceField field, Color color)
        {
            SetPose(at, at.lossyScale, color);
            if (field != null)
                Gizmos.DrawWireCube(field.Bounds.center, field.Bounds.size);
        }

        static void DrawSphere(Transform at, float radius, Color color)
        {
            SetPose(at, Vector3.one, color);
            Gizmos.DrawWireSphere(Vector3.zero, radius);
        }

        static void DrawDisc(Transform at, float radius, Color color)
        {
            SetPose(at, Vector3.one, color);
            for (int side = 0; side < DiscSides; side++)
                Gizmos.DrawLine(Rim(side, radius), Rim(side + 1, radius));
        }

        static void DrawArrow(Transform at, float length, Color color)
        {
            SetPose(at, Vector3.one, color);
            DrawArrow(length);
        }

        // Along the forward axis of what is drawn in.
        static void DrawArrow(float length)
        {
            Vector3 tip = Vector3.forward * length;
            Gizmos.DrawLine(Vector3.zero, tip);
            Gizmos.DrawLine(tip, tip + new Vector3(0.1f, 0f, -0.2f) * length);
            Gizmos.DrawLine(tip, tip + new Vector3(-0.1f, 0f, -0.2f) * length);
        }

        static Vector3 Rim(int side, float radius)
        {
            float angle = side * 2f * Mathf.PI / DiscSides;
            return new Vector3(Mathf.Cos(angle), Mathf.Sin(angle), 0f) * radius;
        }

        static void SetPose(Transform at, Vector3 scale, Color color)
        {
            Gizmos.color = color;
            Gizmos.matrix = Matrix4x4.TRS(at.position, at.rotation, scale);
        }
    }
}
