using System;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public class Editor : ScriptableObject
    {
        Object[] edited = Array.Empty<Object>();
        SerializedObject serialized;

        public Object target { get => edited.FirstOrDefault(); set => edited = new[] { value }; }
        public Object[] targets => edited;
        public SerializedObject serializedObject => serialized ??= new SerializedObject(edited);
        public bool hasUnsavedChanges { get; protected set; }
        public string saveChangesMessage { get; protected set; } = "";

        public virtual void OnInspectorGUI() => DrawDefaultInspector();
        public virtual bool RequiresConstantRepaint() => false;
        public virtual bool UseDefaultMargins() => true;
        public virtual bool HasPreviewGUI() => false;
        public virtual GUIContent GetPreviewTitle() => new GUIContent(target ? target.name : "");
        public virtual string GetInfoString() => "";
        public virtual void OnPreviewGUI(Rect r, GUIStyle background) { }
        public virtual void OnInteractivePreviewGUI(Rect r, GUIStyle background) => OnPreviewGUI(r, background);
        public virtual void OnPreviewSettings() { }
        public virtual void DrawPreview(Rect previewArea) { }
        public virtual void ReloadPreviewInstances() { }
        public virtual void SaveChanges() => hasUnsavedChanges = false;
        public virtual void DiscardChanges() => hasUnsavedChanges = false;
        public virtual Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height) => null;
        protected virtual void OnHeaderGUI() { }
        protected virtual bool ShouldHideOpenButton() => false;

        /// <summary>Visits every serialized property, as drawing it would.</summary>
        public bool DrawDefaultInspector()
        {
            DrawPropertiesExcluding(serializedObject);
            return false;
        }

        protected static void DrawPropertiesExcluding(SerializedObject obj, params string[] propertyToExclude)
        {
            foreach (FieldInfo field in SerializedFields.Of(obj.targetObject.GetType()))
                if (Array.IndexOf(propertyToExclude, field.Name) < 0)
                    EditorGUILayout.PropertyField(obj.FindProperty(field.Name), true);
        }

        public void DrawHeader() => OnHeaderGUI();
        public void Repaint() { }

        /// <summary>A reload of scripts keeps the targets alone.</summary>
        internal void LoseSerializedObject() => serialized = null;

        public static Editor CreateEditor(Object targetObject) => CreateEditor(targetObject, null);
        public static Editor CreateEditor(Object targetObject, Type editorType) => CreateEditor(new[] { targetObject }, editorType);
        public static Editor CreateEditor(Object[] targetObjects) => CreateEditor(targetObjects, null);

        public static Editor CreateEditor(Object[] targetObjects, Type editorType)
        {
            Editor editor = (Editor)ObjectFactory.CreateScriptableObject(editorType ?? TypeFor(targetObjects[0].GetType()));
            editor.edited = targetObjects;
            editor.hideFlags = HideFlags.HideAndDontSave;
            Lifecycle.Wake(editor);
            return editor;
        }

        public static void CreateCachedEditor(Object targetObject, Type editorType, ref Editor previousEditor)
            => CreateCachedEditor(new[] { targetObject }, editorType, ref previousEditor);

        public static void CreateCachedEditor(Object[] targetObjects, Type editorType, ref Editor previousEditor)
        {
            if (previousEditor && previousEditor.edited.SequenceEqual(targetObjects)
                && (editorType == null || editorType == previousEditor.GetType()))
                return;
            if (previousEditor)
                DestroyImmediate(previousEditor);
            previousEditor = CreateEditor(targetObjects, editorType);
        }

        // The [CustomEditor] of the nearest base class; an editor for children only counts if it is marked so.
        static Type TypeFor(Type inspected)
        {
            for (Type at = inspected; at != null; at = at.BaseType)
                foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
                    if (!assembly.IsDynamic && assembly.GetReferencedAssemblies().Any(r => r.Name == "UnityEditor"))
                        foreach (Type type in assembly.GetTypes())
                            foreach (CustomEditor mark in type.GetCustomAttributes<CustomEditor>(false))
                                if (mark.Inspected == at && (at == inspected || mark.ForChildren))
                                    return type;
            return typeof(Editor);
        }
    }

    [AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
    public class CustomEditor : Attribute
    {
        internal readonly Type Inspected;
        internal readonly bool ForChildren;
        public CustomEditor(Type inspectedType) : this(inspectedType, false) { }
        public CustomEditor(Type inspectedType, bool editorForChildClasses) { Inspected = inspectedType; ForChildren = editorForChildClasses; }
        public bool isFallback { get; set; }
    }

    [AttributeUsage(AttributeTargets.Class)] public class CanEditMultipleObjects : Attribute { }

    [AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
    public sealed class CustomPropertyDrawer : Attribute
    {
        public CustomPropertyDrawer(Type type) { }
        public CustomPropertyDrawer(Type type, bool useForChildren) { }
    }

    public abstract class GUIDrawer { }

    public abstract class PropertyDrawer : GUIDrawer
    {
        public PropertyAttribute attribute { get; internal set; }
        public FieldInfo fieldInfo { get; internal set; }
        public string preferredLabel { get; internal set; }
        public virtual void OnGUI(Rect position, SerializedProperty property, GUIContent label) { }
        public virtual float GetPropertyHeight(SerializedProperty property, GUIContent label) => EditorGUIUtility.singleLineHeight;
    }

    public abstract class EditorWindow : ScriptableObject
    {
        public GUIContent titleContent { get; set; } = new GUIContent();
        public Rect position { get; set; }
        public Vector2 minSize { get; set; }
        public Vector2 maxSize { get; set; }
        public bool wantsMouseMove { get; set; }
        public bool autoRepaintOnSceneChange { get; set; }
        public bool hasFocus => false;

        public static T GetWindow<T>() where T : EditorWindow => GetWindow<T>(false, null, true);
        public static T GetWindow<T>(bool utility) where T : EditorWindow => GetWindow<T>(utility, null, true);
        public static T GetWindow<T>(string title) where T : EditorWindow => GetWindow<T>(false, title, true);
        public static T GetWindow<T>(string title, bool focus) where T : EditorWindow => GetWindow<T>(false, title, focus);
        public static T GetWindow<T>(bool utility, string title) where T : EditorWindow => GetWindow<T>(utility, title, true);

        public static T GetWindow<T>(bool utility, string title, bool focus) where T : EditorWindow
        {
            T window = Resources.FindObjectsOfTypeAll<T>().FirstOrDefault() ?? CreateInstance<T>();
            if (title != null)
                window.titleContent = new GUIContent(title);
            return window;
        }

        public static bool HasOpenInstances<T>() where T : EditorWindow => Resources.FindObjectsOfTypeAll<T>().Length > 0;
        public void Show() { }
        public void ShowUtility() { }
        public void Focus() { }
        public void Repaint() { }
        public void Close() => DestroyImmediate(this);
    }
}
