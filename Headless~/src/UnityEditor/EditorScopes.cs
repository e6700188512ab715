using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public partial class EditorGUI
    {
        public struct DisabledScope : System.IDisposable
        {
            public DisabledScope(bool disabled) { }
            public void Dispose() { }
        }

        public class IndentLevelScope : GUI.Scope
        {
            public IndentLevelScope() { }
            public IndentLevelScope(int increment) { }
            protected override void CloseScope() { }
        }

        public class ChangeCheckScope : GUI.Scope
        {
            public bool changed => false;
            protected override void CloseScope() { }
        }
    }

    public partial class EditorGUILayout
    {
        public class HorizontalScope : GUI.Scope
        {
            public HorizontalScope(params GUILayoutOption[] options) { }
            public HorizontalScope(GUIStyle style, params GUILayoutOption[] options) { }
            public Rect rect { get; protected set; }
            protected override void CloseScope() { }
        }

        public class VerticalScope : GUI.Scope
        {
            public VerticalScope(params GUILayoutOption[] options) { }
            public VerticalScope(GUIStyle style, params GUILayoutOption[] options) { }
            public Rect rect { get; protected set; }
            protected override void CloseScope() { }
        }
    }

    public partial class Handles
    {
        public struct DrawingScope : System.IDisposable
        {
            public DrawingScope(Color color) { }
            public DrawingScope(Matrix4x4 matrix) { }
            public DrawingScope(Color color, Matrix4x4 matrix) { }
            public void Dispose() { }
        }
    }

    public enum MessageType { None = 0, Info = 1, Warning = 2, Error = 3 }

    // What has an effect besides being undoable.
    public partial class Undo
    {
        public static T AddComponent<T>(GameObject gameObject) where T : Component => gameObject.AddComponent<T>();
        public static Component AddComponent(GameObject gameObject, System.Type type) => gameObject.AddComponent(type);
        public static void DestroyObjectImmediate(Object objectToUndo) => Object.DestroyImmediate(objectToUndo, true);
        public static void SetTransformParent(Transform transform, Transform newParent, string name) => transform.SetParent(newParent, true);
        public static void SetTransformParent(Transform transform, Transform newParent, bool worldPositionStays, string name) => transform.SetParent(newParent, worldPositionStays);
        public static void SetSiblingIndex(Transform transform, int siblingIndex, string name) => transform.SetSiblingIndex(siblingIndex);
    }
}
