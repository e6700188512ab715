using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine.Headless
{
    /// <summary>One frame of the player, in Unity's order.</summary>
    internal static class PlayerLoop
    {
        /// <summary>Cameras draw here.</summary>
        public static Action Render;
        /// <summary>The Editor's update, which in play mode comes before each frame.</summary>
        public static Action UpdateEditor;
        /// <summary>Between Update and LateUpdate, as Unity's DirectorUpdateAnimationBegin.</summary>
        public static Action PlayDirectors;
        /// <summary>Asynchronous read-backs arrive here.</summary>
        public static Action BeginFrame;
        /// <summary>Put back to their first state by <see cref="Reset"/>: for parts that hold statics of their own.</summary>
        public static Action ResetOthers;

        static readonly ScriptList fixedUpdates = new ScriptList(Message.FixedUpdate);
        static readonly ScriptList updates = new ScriptList(Message.Update);
        static readonly ScriptList lateUpdates = new ScriptList(Message.LateUpdate);
        /// <summary>Run by the renderer, once a camera.</summary>
        internal static readonly ScriptList RenderObjects = new ScriptList(Message.OnRenderObject);
        static readonly List<MonoBehaviour> unstarted = new List<MonoBehaviour>();

        public static void Frame(float deltaTime)
        {
            if (!EditMode.IsOn)
                Guarded(UpdateEditor);
            Time.Clock.BeginFrame(deltaTime);
            SceneManager.RunRequests();
            Guarded(BeginFrame);
            StartNewScripts();

            // Nothing falls in edit mode, and FixedUpdate is not called.
            while (!EditMode.IsOn && Time.Clock.StepFixed())
            {
                PhysicsLoop.Current?.BeginFixedStep();
                fixedUpdates.Run();
                PhysicsLoop.Current?.FixedStep();
                CoroutineScheduler.Resume(CoroutinePoint.FixedUpdate);
            }
            if (!EditMode.IsOn)
                PhysicsLoop.Current?.BeginUpdate();

            updates.Run();
            Invocations.Run();
            CoroutineScheduler.Resume(CoroutinePoint.Update);
            if (!EditMode.IsOn)
                Guarded(PlayDirectors);
            lateUpdates.Run();
            Destruction.RunPending();
            Guarded(Application.RaiseBeforeRender);
            Guarded(Render);
            CoroutineScheduler.Resume(CoroutinePoint.EndOfFrame);
            NativeMemory.FreeTemporary();
        }

        static void Guarded(Action action)
        {
            try
            {
                action?.Invoke();
            }
            catch (Exception e)
            {
                Debug.LogException(e);
            }
        }

        /// <summary>A script became active and enabled.</summary>
        public static void Enlist(MonoBehaviour script)
        {
            if (!script.Started)
                unstarted.Add(script);
            fixedUpdates.Add(script);
            updates.Add(script);
            lateUpdates.Add(script);
            RenderObjects.Add(script);
        }

        public static void Dismiss(MonoBehaviour script)
        {
            unstarted.Remove(script);
            fixedUpdates.Remove(script);
            updates.Remove(script);
            lateUpdates.Remove(script);
            RenderObjects.Remove(script);
        }

        static void StartNewScripts()
        {
            // Start may enable more scripts, whose Start comes at once too.
            while (unstarted.Count > 0)
            {
                var batch = new List<MonoBehaviour>(unstarted);
                ScriptList.Sort(batch);
                foreach (MonoBehaviour script in batch)
                    Start(script);
            }
        }

        internal static void Start(MonoBehaviour script)
        {
            unstarted.Remove(script);
            if (script.Started || script.Destroyed || !script.Activated || !EditMode.Runs(script))
                return;
            script.Started = true;
            Messages.Send(script, Message.Start);
        }

        /// <summary>Leaves play mode and enters it again: all scenes go, time starts over, SubsystemRegistration methods run.</summary>
        public static void Reset()
        {
            SceneManager.UnloadEverything();
            EditMode.IsOn = EditMode.IsLoopQueued = false;
            Destruction.ForgetPending();
            CoroutineScheduler.Clear();
            Invocations.Clear();
            unstarted.Clear();
            fixedUpdates.Clear();
            updates.Clear();
            lateUpdates.Clear();
            RenderObjects.Clear();
            Time.Clock.Reset();
            PhysicsLoop.Current?.Reset();
            RenderSettings.Reset();
            EnvironmentLighting.Invalidate();
            Random.InitState(Environment.TickCount);
            Application.ResetState();
            ResetOthers?.Invoke();
            Initializers.Run(RuntimeInitializeLoadType.SubsystemRegistration);
        }
    }
}
