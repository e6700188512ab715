using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement
{
    /// <summary>Loads scenes by their path in play mode, in the build settings or not. Nothing is opened for editing here.</summary>
    public sealed class EditorSceneManager : SceneManager
    {
        public static AsyncOperation LoadSceneAsyncInPlayMode(string path, LoadSceneParameters parameters)
            => SceneManager.LoadSceneAsync(path, parameters);
    }
}
