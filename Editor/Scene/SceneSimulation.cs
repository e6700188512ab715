using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Rill.Editor
{
    /// <summary>
    /// Runs one fluid of the open scene without Play, with what acts on it and draws it: <see cref="MonoBehaviour.runInEditMode"/> has
    /// these components hear their messages. What the scene stores of them stays as it is, and they give back all they took at the end.
    /// </summary>
    sealed class SceneSimulation
    {
        const double MaxFrameTime = 1.0 / 3.0;      // s, as Unity's own default; what a hitch of the Editor took longer is left out

        /// <summary>Bounds of <see cref="Speed"/>.</summary>
        public const float MinSpeed = 0.1f, MaxSpeed = 2f;

        const string SpeedKey = "Rill.SceneSimulation.Speed";

        readonly List<MonoBehaviour> running = new List<MonoBehaviour>();
        double lastTime;
        int stepsDue;
        FluidSnapshotRequest saving;

        SceneSimulation(FluidSimulation fluid) => Fluid = fluid;

        /// <summary>Simulation that runs now; null if none does.</summary>
        public static SceneSimulation Current { get; private set; }

        /// <summary>Why the last one could not begin or ended by itself; null where nothing was wrong.</summary>
        public static string Problem { get; private set; }

        public FluidSimulation Fluid { get; }

        /// <summary>Fluid time that passes in a second, s: of this simulation and the next ones, until the Editor closes.</summary>
        public static float Speed
        {
            get => SessionState.GetFloat(SpeedKey, 1f);
            set => SessionState.SetFloat(SpeedKey, Mathf.Clamp(value, MinSpeed, MaxSpeed));
        }

        /// <summary>Whether its time stands still.</summary>
        public bool IsPaused { get; set; }

        /// <summary>Whether its state is being saved into an asset.</summary>
        public bool IsSaving => saving != null;

        public static bool Runs(FluidSimulation fluid) => Current != null && ReferenceEquals(Current.Fluid, fluid);

        /// <summary>Begins at time 0; what ran before ends. One that cannot run leaves none, and <see cref="Problem"/> says why.</summary>
        public static void Start(FluidSimulation fluid)
        {
            Stop();
            Problem = WhyNot(fluid);
            if (Problem != null)
                return;
            Current = new SceneSimulation(fluid);
            Current.Begin();
            if (!fluid.IsRunning)
                Stop(ProblemOf(fluid));
        }

        /// <summary>Ends it: what it showed is gone, and so is what it took on the GPU. Twice is harmless.</summary>
        public static void Stop() => Stop(null);

        static void Stop(string problem)
        {
            Problem = problem;
            SceneSimulation ending = Current;
            Current = null;
            ending?.End();
        }

        /// <summary>Begins again at time 0 with the volumes or the start state.</summary>
        public void Restart()
        {
            stepsDue = 0;
            Fluid.Restart();
        }

        /// <summary>Pauses, and takes one fixed step at the next update.</summary>
        public void Step()
        {
            IsPaused = true;
            stepsDue++;
        }

        /// <summary>Saves the present state as the one that the fluid starts with, when it has come from the GPU.</summary>
        public void SaveAsStart() => saving ??= Fluid.RequestSnapshot();

        /// <summary>Lets time pass until a moment, s.</summary>
        internal void Advance(double now)
        {
            if (Fluid == null || !Fluid.isActiveAndEnabled)
            {
                Stop("The fluid was disabled or deleted.");
                return;
            }
            if (!Fluid.IsRunning)
            {
                Stop(ProblemOf(Fluid));
                return;
            }
            FinishSaving();
            double passed = Math.Min(now - lastTime, MaxFrameTime);
            lastTime = now;
            if (stepsDue > 0)
            {
                stepsDue--;
                Fluid.Clock.GiveTime(Fluid.FixedStep);
            }
            else if (IsPaused)
                Fluid.Clock.GiveTime(0f);
            else if (passed > 0.0)
                Fluid.Clock.GiveTime((float)(passed * Speed));
            // Also while it is paused: what a frame draws is gone with it.
            EditorApplication.QueuePlayerLoopUpdate();
            SceneView.RepaintAll();
        }

        [InitializeOnLoadMethod]
        static void Watch()
        {
            EditorApplication.playModeStateChanged += OnPlayMode;
            AssemblyReloadEvents.beforeAssemblyReload += Stop;
            EditorApplication.quitting += Stop;
        }

        // Before the scene is stored for play mode.
        static void OnPlayMode(PlayModeStateChange change)
        {
            if (change == PlayModeStateChange.ExitingEditMode)
                Stop();
        }

        static string WhyNot(FluidSimulation fluid)
        {
            if (Application.isPlaying)
                return "In play mode the fluid plays by itself. Stop Play first.";
            if (EditorUtility.IsPersistent(fluid))
                return $"'{fluid.name}' is an asset. Open the prefab, or put it into a scene.";
            return fluid.isActiveAndEnabled ? null : $"'{fluid.name}' is disabled. Enable the component and its object.";
        }

        static string ProblemOf(FluidSimulation fluid)
            => ProblemList.Of(new Object[] { fluid }).FirstOrDefault() ?? $"'{fluid.name}' could not begin. The Console says why.";

        void Begin()
        {
            Fluid.IsInEditMode = true;
            lastTime = EditorApplication.timeSinceStartup;
            RunAll();
            EditorApplication.update += Update;
            EditorApplication.hierarchyChanged += RunAll;
        }

        void End()
        {
            EditorApplication.update -= Update;
            EditorApplication.hierarchyChanged -= RunAll;
            for (int i = running.Count - 1; i >= 0; i--)
                if (running[i] != null)
                    StopRunning(running[i]);
            running.Clear();
            if (saving != null)
                Debug.LogWarning("Rill: the state was not saved: the simulation ended before it had come from the GPU. Simulate and save " +
                    "it again.", Fluid);
            saving = null;
            // A destroyed one has given back what it took, and needs no flag.
            if (Fluid != null)
                Fluid.IsInEditMode = false;
            SceneView.RepaintAll();
        }

        void Update() => Advance(EditorApplication.timeSinceStartup);

        // Again as objects come: in the order in which a scene that is loaded enables them.
        void RunAll()
        {
            if (Fluid == null)
                return;
            foreach (MonoBehaviour script in InOrder(Fluid))
            {
                if (script.runInEditMode)
                    continue;
                running.Add(script);
                script.runInEditMode = true;
            }
        }

        static IEnumerable<MonoBehaviour> InOrder(FluidSimulation fluid)
        {
            return Scenes(fluid.gameObject.scene).SelectMany(scene => scene.GetRootGameObjects())
                .SelectMany(root => root.GetComponentsInChildren<MonoBehaviour>(true))
                .Where(script => script is IRunsInEditMode part && part.BelongsTo(fluid)).OrderBy(OrderOf);
        }

        // All open scenes, or that of an open prefab alone.
        static IEnumerable<Scene> Scenes(Scene own)
        {
            var open = Enumerable.Range(0, SceneManager.sceneCount).Select(SceneManager.GetSceneAt).Where(scene => scene.isLoaded).ToList();
            return open.Contains(own) ? open : new List<Scene> { own };
        }

        static int OrderOf(MonoBehaviour script) => script.GetType().GetCustomAttribute<DefaultExecutionOrder>(true)?.order ?? 0;

        // Unity tells a script that it ends where it is disabled, and not where the flag is taken back: so its XR Core Utilities do
        // (MonoBehaviourExtensions.StopRunInEditMode).
        static void StopRunning(MonoBehaviour script)
        {
            bool wasEnabled = script.enabled;
            script.enabled = false;
            script.runInEditMode = false;
            script.enabled = wasEnabled;
        }

        void FinishSaving()
        {
            if (saving == null || !saving.IsDone)
                return;
            FluidSnapshotRequest done = saving;
            saving = null;
            SnapshotAssets.SaveAsStart(Fluid, done);
        }
    }
}
