using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor.Tests
{
    /// <summary>Objects of a test that are gone after it.</summary>
    sealed class EditorScene : IDisposable
    {
        readonly List<Object> made = new List<Object>();

        public EditorScene()
        {
            Undo.ClearAll();
            Selection.activeObject = null;
        }

        /// <summary>An object that stays switched off, so that nothing of it runs or complains.</summary>
        public T Add<T>(string name = "Object") where T : Component => (T)Add(typeof(T), name);

        public Component Add(Type type, string name = "Object")
        {
            var gameObject = new GameObject(name);
            gameObject.SetActive(false);
            made.Add(gameObject);
            return gameObject.AddComponent(type);
        }

        public UnityEditor.Editor Inspect(params Object[] targets)
        {
            UnityEditor.Editor editor = UnityEditor.Editor.CreateEditor(targets);
            made.Add(editor);
            return editor;
        }

        public GameObject Keep(GameObject gameObject)
        {
            made.Add(gameObject.transform.root.gameObject);
            return gameObject;
        }

        public void Dispose()
        {
            foreach (Object one in made)
                if (one != null)
                    Object.DestroyImmediate(one);
            Undo.ClearAll();
        }
    }
}
