using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Handles for shapes that are centered on their object and do not follow its scale. Drags go through undo.</summary>
    static class ShapeHandles
    {
        static readonly BoxBoundsHandle box = new BoxBoundsHandle();
        static readonly SphereBoundsHandle sphere = new SphereBoundsHandle();

        /// <param name="path">Property path of the size, m.</param>
        /// <param name="flat">Whether only x and y count.</param>
        public static void Box(Component of, string path, bool flat, Color color)
        {
            using (var target = new SerializedObject(of))
            {
                SerializedProperty size = target.FindProperty(path);
                box.center = Vector3.zero;
                box.size = flat ? Vector3.Scale(size.vector3Value, new Vector3(1f, 1f, 0f)) : size.vector3Value;
                box.axes = flat ? PrimitiveBoundsHandle.Axes.X | PrimitiveBoundsHandle.Axes.Y : PrimitiveBoundsHandle.Axes.All;
                if (!Drag(box, of.transform, color))
                    return;
                Vector3 dragged = Centered(box.center, box.size);
                size.vector3Value = flat ? new Vector3(dragged.x, dragged.y, size.vector3Value.z) : dragged;
                target.ApplyModifiedProperties();
            }
        }

        /// <param name="path">Property path of the radius, m.</param>
        /// <param name="flat">Whether it is a disc across the forward axis.</param>
        public static void Sphere(Component of, string path, bool flat, Color color)
        {
            using (var target = new SerializedObject(of))
            {
                SerializedProperty radius = target.FindProperty(path);
                sphere.center = Vector3.zero;
                sphere.axes = flat ? PrimitiveBoundsHandle.Axes.X | PrimitiveBoundsHandle.Axes.Y : PrimitiveBoundsHandle.Axes.All;
                sphere.radius = radius.floatValue;
                if (!Drag(sphere, of.transform, color))
                    return;
                radius.floatValue = sphere.radius;
                target.ApplyModifiedProperties();
            }
        }

        /// <summary>Size of a box around the origin whose dragged face is where a box that is not centered has it.</summary>
        public static Vector3 Centered(Vector3 center, Vector3 size)
        {
            return size + 2f * new Vector3(Mathf.Abs(center.x), Mathf.Abs(center.y), Mathf.Abs(center.z));
        }

        static bool Drag(PrimitiveBoundsHandle handle, Transform at, Color color)
        {
            if (!Limit.IsPose(at.position, at.rotation))
                return false;
            handle.SetColor(color);
            using (new Handles.DrawingScope(Matrix4x4.TRS(at.position, at.rotation, Vector3.one)))
            {
                EditorGUI.BeginChangeCheck();
                handle.DrawHandle();
                return EditorGUI.EndChangeCheck();
            }
        }
    }
}
