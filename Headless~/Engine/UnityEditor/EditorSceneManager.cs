using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement
{
    /// <summary>Loads scenes by their path in play mode, in the build settings or not. Nothing is opened for editing here.</summary>
    public sealed class EditorSceneManager : SceneManager
    {
        public delegate void SceneSavingCallback(Scene scene, string path);

        public static event SceneSavingCallback sceneSaving;

        /// <summary>Raises the event that the Editor raises before it saves a scene, which the host does not.</summary>
        internal static void RaiseSaving(Scene scene, string path) => sceneSaving?.Invoke(scene, path);

        public static AsyncOperation LoadSceneAsyncInPlayMode(string path, LoadSceneParameters parameters)
            => SceneManager.LoadSceneAsync(path, parameters);
    }
}
