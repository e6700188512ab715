using System;
using System.Collections.Generic;
using UnityEngine.Events;
using UnityEngine.Headless;

namespace UnityEngine.SceneManagement
{
    public class SceneManager
    {
        /// <summary>
        /// Set by the part that reads scene files: takes a name or path, builds the objects asleep in a scene that it
        /// gets from <see cref="CreateForLoading"/> and returns it, or an invalid one if the scene does not exist.
        /// </summary>
        internal static Func<string, Scene> SceneLoader;
        /// <summary>Paths in the order of the build settings.</summary>
        internal static readonly List<string> BuildScenes = new List<string>();

        static readonly List<SceneData> loaded = new List<SceneData>();
        static readonly Queue<Action> requests = new Queue<Action>();
        static SceneData active, keep;

        public static event UnityAction<Scene, LoadSceneMode> sceneLoaded;
        public static event UnityAction<Scene> sceneUnloaded;
        public static event UnityAction<Scene, Scene> activeSceneChanged;

        /// <summary>Scenes and, at the end, what DontDestroyOnLoad keeps.</summary>
        internal static IEnumerable<SceneData> Loaded
        {
            get
            {
                var all = new List<SceneData>(loaded);
                if (keep != null)
                    all.Add(keep);
                return all;
            }
        }

        /// <summary>There always is one.</summary>
        internal static SceneData Active
        {
            get
            {
                if (active == null)
                {
                    active = new SceneData { IsLoaded = true };
                    loaded.Add(active);
                }
                return active;
            }
        }

        public static int sceneCount => loaded.Count;
        public static int loadedSceneCount => loaded.Count;
        public static int sceneCountInBuildSettings => BuildScenes.Count;
        public static Scene GetActiveScene() => new Scene(Active);

        public static bool SetActiveScene(Scene scene)
        {
            if (!scene.IsValid() || !scene.isLoaded)
                throw new ArgumentException(
                    $"SceneManager.SetActiveScene failed; the scene '{scene.name}' is not loaded and therefore cannot be set active");
            Activate(scene.Data);
            return true;
        }

        static void Activate(SceneData scene)
        {
            SceneData before = active;
            active = scene;
            if (before != scene)
                activeSceneChanged?.Invoke(new Scene(before), new Scene(scene));
        }

        public static Scene GetSceneAt(int index)
            => index >= 0 && index < loaded.Count ? new Scene(loaded[index])
                : throw new ArgumentException($"Scene index \"{index}\" is out of range.");
        public static Scene GetSceneByName(string name) => new Scene(loaded.Find(s => s.Name == name));
        public static Scene GetSceneByPath(string scenePath) => new Scene(loaded.Find(s => s.Path == scenePath));
        public static Scene GetSceneByBuildIndex(int buildIndex) => new Scene(loaded.Find(s => s.BuildIndex == buildIndex));

        public static Scene CreateScene(string sceneName) => CreateScene(sceneName, default);

        public static Scene CreateScene(string sceneName, CreateSceneParameters parameters)
        {
            if (string.IsNullOrEmpty(sceneName))
                throw new ArgumentException("Scene name cannot be null or empty", nameof(sceneName));
            if (loaded.Exists(s => s.Name == sceneName))
                throw new ArgumentException($"Scene with name \"{sceneName}\" already exists.");
            var scene = new SceneData { Name = sceneName, IsLoaded = true, HasLocalPhysics = HasLocalPhysics(parameters.localPhysicsMode) };
            _ = Active;
            loaded.Add(scene);
            return new Scene(scene);
        }

        /// <summary>For the scene loader: not listed until it has been filled and woken.</summary>
        internal static Scene CreateForLoading(string name, string path)
            => new Scene(new SceneData { Name = name, Path = path, BuildIndex = BuildScenes.IndexOf(path) });

        // ---- loading: at the start of the next frame, as Unity does
        public static void LoadScene(string sceneName) => LoadScene(sceneName, LoadSceneMode.Single);
        public static void LoadScene(string sceneName, LoadSceneMode mode) => requests.Enqueue(() => LoadNow(sceneName, mode));
        public static void LoadScene(int sceneBuildIndex) => LoadScene(sceneBuildIndex, LoadSceneMode.Single);
        public static void LoadScene(int sceneBuildIndex, LoadSceneMode mode) => LoadScene(PathOf(sceneBuildIndex), mode);

        public static AsyncOperation LoadSceneAsync(string sceneName) => LoadSceneAsync(sceneName, LoadSceneMode.Single);
        public static AsyncOperation LoadSceneAsync(int sceneBuildIndex) => LoadSceneAsync(PathOf(sceneBuildIndex), LoadSceneMode.Single);
        public static AsyncOperation LoadSceneAsync(int sceneBuildIndex, LoadSceneMode mode) => LoadSceneAsync(PathOf(sceneBuildIndex), mode);
        public static AsyncOperation LoadSceneAsync(int sceneBuildIndex, LoadSceneParameters parameters)
            => LoadSceneAsync(PathOf(sceneBuildIndex), parameters);
        public static AsyncOperation LoadSceneAsync(string sceneName, LoadSceneMode mode)
            => LoadSceneAsync(sceneName, new LoadSceneParameters(mode));

        public static AsyncOperation LoadSceneAsync(string sceneName, LoadSceneParameters parameters)
        {
            var operation = new AsyncOperation();
            requests.Enqueue(() =>
            {
                LoadNow(sceneName, parameters.loadSceneMode, parameters.localPhysicsMode);
                operation.Complete();
            });
            return operation;
        }

        static bool HasLocalPhysics(LocalPhysicsMode mode) => (mode & LocalPhysicsMode.Physics3D) != 0;

        static string PathOf(int buildIndex)
            => buildIndex >= 0 && buildIndex < BuildScenes.Count ? BuildScenes[buildIndex]
            : throw new ArgumentException($"Scene with build index: {buildIndex} couldn't be loaded because it has not been added to " +
                $"the build settings ({BuildScenes.Count} scenes).");

        internal static void RunRequests()
        {
            while (requests.Count > 0)
                requests.Dequeue()();
        }

        /// <summary>At once; the invalid scene, with an error in the log, when there is none of that name.</summary>
        internal static Scene LoadNow(string sceneName, LoadSceneMode mode, LocalPhysicsMode physics = LocalPhysicsMode.None)
        {
            Scene scene = SceneLoader != null ? SceneLoader(sceneName) : default;
            if (scene.Data == null)
            {
                Debug.LogError($"Scene '{sceneName}' couldn't be loaded because it has not been added to the build settings or the " +
                    $"AssetBundle has not been loaded.");
                return default;
            }
            if (mode == LoadSceneMode.Single)
                foreach (SceneData old in loaded.ToArray())
                    Unload(old);
            scene.Data.IsLoaded = true;
            scene.Data.HasLocalPhysics = HasLocalPhysics(physics);
            loaded.Add(scene.Data);
            if (mode == LoadSceneMode.Single || active == null)
                Activate(scene.Data);
            Time.Clock.LevelLoad = Time.timeAsDouble;
            ObjectFactory.Wake(scene.Data.Roots.ToArray());
            sceneLoaded?.Invoke(scene, mode);
            return scene;
        }

        public static AsyncOperation UnloadSceneAsync(string sceneName) => UnloadSceneAsync(GetSceneByName(sceneName));
        public static AsyncOperation UnloadSceneAsync(Scene scene) => UnloadSceneAsync(scene, UnloadSceneOptions.None);

        public static AsyncOperation UnloadSceneAsync(Scene scene, UnloadSceneOptions options)
        {
            if (!scene.IsValid())
                throw new ArgumentException("Scene to unload is invalid");
            if (loaded.Count <= 1)
            {
                Debug.LogWarning($"Unloading the last loaded scene {scene.path}(build index: {scene.buildIndex}), is not supported. " +
                    $"Please use SceneManager.LoadScene()/EditorSceneManager.OpenScene() to switch to another scene.");
                return null;
            }
            var operation = new AsyncOperation();
            requests.Enqueue(() =>
            {
                Unload(scene.Data);
                operation.Complete();
            });
            return operation;
        }

        static void Unload(SceneData scene)
        {
            if (!loaded.Contains(scene))
                return;
            foreach (GameObject root in scene.Roots.ToArray())
                if (Object.IsAlive(root))
                    Destruction.Now(root, true);
            loaded.Remove(scene);
            scene.IsLoaded = false;
            scene.IsGone = true;
            if (active == scene)
                active = loaded.Count > 0 ? loaded[0] : null;
            sceneUnloaded?.Invoke(new Scene(scene));
        }

        internal static void UnloadEverything()
        {
            requests.Clear();
            foreach (SceneData scene in Loaded)
            {
                foreach (GameObject root in scene.Roots.ToArray())
                    if (Object.IsAlive(root))
                        Destruction.Now(root, true);
                scene.IsGone = true;
            }
            loaded.Clear();
            active = keep = null;
            sceneLoaded = null;
            sceneUnloaded = null;
            activeSceneChanged = null;
        }

        public static void MergeScenes(Scene sourceScene, Scene destinationScene)
        {
            foreach (GameObject root in sourceScene.GetRootGameObjects())
                root.transform.MoveToScene(destinationScene.Data);
            Unload(sourceScene.Data);
        }

        public static void MoveGameObjectToScene(GameObject go, Scene scene)
        {
            if (go.transform.ParentOf is object)
                throw new ArgumentException("Gameobject is not a root in a scene");
            if (!scene.IsValid())
                throw new ArgumentException("The destination scene is invalid.");
            go.transform.MoveToScene(scene.Data);
        }

        internal static void MoveToDontDestroyOnLoad(Object target)
        {
            GameObject go = target as GameObject ?? (target as Component)?.gameObject;
            if (go is null)
                return;
            if (go.transform.ParentOf is object)
            {
                Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.", go);
                return;
            }
            keep ??= new SceneData { Name = "DontDestroyOnLoad", Path = "DontDestroyOnLoad", IsLoaded = true };
            if (go.SceneOf != keep)
                go.transform.MoveToScene(keep);
        }
    }

    public enum LoadSceneMode { Single = 0, Additive = 1 }
    [Flags] public enum LocalPhysicsMode { None = 0, Physics2D = 1, Physics3D = 2 }
    [Flags] public enum UnloadSceneOptions { None = 0, UnloadAllEmbeddedSceneObjects = 1 }

    public struct LoadSceneParameters
    {
        public LoadSceneParameters(LoadSceneMode mode) : this(mode, LocalPhysicsMode.None) { }
        public LoadSceneParameters(LoadSceneMode mode, LocalPhysicsMode physicsMode) { loadSceneMode = mode; localPhysicsMode = physicsMode; }
        public LoadSceneMode loadSceneMode { get; set; }
        public LocalPhysicsMode localPhysicsMode { get; set; }
    }

    public struct CreateSceneParameters
    {
        public CreateSceneParameters(LocalPhysicsMode physicsMode) { localPhysicsMode = physicsMode; }
        public LocalPhysicsMode localPhysicsMode { get; set; }
    }
}
