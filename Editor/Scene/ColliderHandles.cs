using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Handles for colliders, which have a center of their own and follow their object's scale. Drags go through undo.</summary>
    static class ColliderHandles
    {
        static readonly BoxBoundsHandle box = new BoxBoundsHandle();
        static readonly SphereBoundsHandle sphere = new SphereBoundsHandle();
        static readonly CapsuleBoundsHandle capsule = new CapsuleBoundsHandle { heightAxis = CapsuleBoundsHandle.HeightAxis.Y };

        public static void Draw(FluidCollider collider)
        {
            PrimitiveBoundsHandle handle = HandleOf(collider.Shape);
            Transform at = collider.transform;
            Vector3 scale = at.lossyScale;
            if (handle == null || !Limit.IsPose(at.position, at.rotation) || scale.x * scale.y * scale.z == 0f)
                return;
            using (var target = new SerializedObject(collider))
            using (new Handles.DrawingScope(Matrix4x4.TRS(at.position, at.rotation, Vector3.one)))
            {
                Put(handle, target, scale);
                handle.SetColor(GizmoColors.Collider);
                EditorGUI.BeginChangeCheck();
                handle.DrawHandle();
                if (!EditorGUI.EndChangeCheck())
                    return;
                ApplyHandle(handle, target, scale);
                target.ApplyModifiedProperties();
            }
        }

        static PrimitiveBoundsHandle HandleOf(ColliderShape shape)
        {
            switch (shape)
            {
                case ColliderShape.Sphere: return sphere;
                case ColliderShape.Box: return box;
                case ColliderShape.Capsule: return capsule;
                default: return null;
            }
        }

        // Meters along the object's axes, as the collider is in the world.
        static void Put(PrimitiveBoundsHandle handle, SerializedObject from, Vector3 scale)
        {
            handle.center = Vector3.Scale(from.FindProperty("center").vector3Value, scale);
            if (handle == box)
                box.size = Vector3.Scale(from.FindProperty("size").vector3Value, Abs(scale));
            else if (handle == sphere)
                sphere.radius = from.FindProperty("radius").floatValue * EvenScale(scale);
            else
            {
                capsule.radius = from.FindProperty("radius").floatValue * AcrossScale(scale);
                capsule.height = from.FindProperty("height").floatValue * Mathf.Abs(scale.y);
            }
        }

        static void ApplyHandle(PrimitiveBoundsHandle handle, SerializedObject to, Vector3 scale)
        {
            to.FindProperty("center").vector3Value = Divide(handle.center, scale);
            if (handle == box)
                to.FindProperty("size").vector3Value = Divide(box.size, Abs(scale));
            else if (handle == sphere)
                to.FindProperty("radius").floatValue = sphere.radius / EvenScale(scale);
            else
            {
                to.FindProperty("radius").floatValue = capsule.radius / AcrossScale(scale);
                to.FindProperty("height").floatValue = capsule.height / Mathf.Abs(scale.y);
            }
        }

        static float EvenScale(Vector3 scale) => Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
        static float AcrossScale(Vector3 scale) => Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.z));
        static Vector3 Abs(Vector3 v) => new Vector3(Mathf.Abs(v.x), Mathf.Abs(v.y), Mathf.Abs(v.z));
        static Vector3 Divide(Vector3 a, Vector3 b) => new Vector3(a.x / b.x, a.y / b.y, a.z / b.z);
    }
}
