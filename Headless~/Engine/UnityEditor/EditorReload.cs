using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>
    /// A reload of scripts, as after a recompile, in edit mode or during play (Recompile And Continue Playing). The C# objects of
    /// scripts stand in for those of the new domain: each is constructed again, and has what Unity's serialization carried over.
    /// </summary>
    /// <remarks>
    /// The order is that of Unity's manual, "Details of disabling domain and scene reload" (ConfigurableEnterPlayModeDetails, 2019.3 to
    /// 6000.0), steps 1 to 10. It has OnEnable before [InitializeOnLoad]; the Editor's own log has it after: "Domain Reload Profiling"
    /// lists DisableScriptedObjects, BackupInstance, CreateAndSetChildDomain, LoadAssemblies, ProcessInitializeOnLoadAttributes,
    /// ProcessInitializeOnLoadMethodAttributes and AwakeInstancesAfterBackupRestoration, with scripts sorted by execution order before the
    /// first and the last (a log of 2021.2 in Unity-Technologies/com.unity.webrtc, issue 528).
    /// State that is carried over: manual, "Script serialization", Hot reloading. Awake, Start and [RuntimeInitializeOnLoadMethod] belong to the
    /// beginning of an object and of play, and do not come again. Coroutines, timed calls, listeners and statics are of the domain that goes.
    /// </remarks>
    internal static class EditorReload
    {
        public static void Run()
        {
            Guarded(AssemblyReloadEvents.RaiseBefore);
            List<Object> active = Scripts().Where(IsActive).ToList();
            foreach (Object script in active)
                Deactivate(script);

            List<Object> scripts = Scripts();
            foreach (Object script in scripts)
                Guarded(() => (script as ISerializationCallbackReceiver)?.OnBeforeSerialize());
            List<ScriptBackup> backups = scripts.Select(script => new ScriptBackup(script)).ToList();

            ScriptCallbacks.Drop();
            ScriptStatics statics = ScriptStatics.Reset(EditorInitializers.RunsOnLoad);

            foreach (ScriptBackup backup in backups)
                backup.Construct();
            foreach (Editor editor in scripts.OfType<Editor>())
                editor.LoseSerializedObject();
            foreach (ScriptBackup backup in backups)
                backup.Restore();
            foreach (Object script in scripts)
                Guarded(() => (script as ISerializationCallbackReceiver)?.OnAfterDeserialize());
            foreach (Object script in scripts)
                Messages.Send(script, Message.OnValidate);

            EditorInitializers.RunAgain(statics);
            foreach (Object script in active)
                Activate(script);
            Guarded(AssemblyReloadEvents.RaiseAfter);
        }

        // Lists components and assets, by execution order; the engine's own objects have no state of scripts.
        static List<Object> Scripts() => ObjectRegistry.All(typeof(Object))
            .Where(o => (o is MonoBehaviour || o is ScriptableObject) && !ScriptAssemblies.IsEngines(o.GetType().Assembly))
            .OrderBy(o => ExecutionOrder.Of(o.GetType())).ToList();

        static bool IsActive(Object script) => script is ScriptableObject asset ? asset.Enabled : ((MonoBehaviour)script).Activated;

        static void Deactivate(Object script)
        {
            if (!Object.IsAlive(script))
                return;
            if (script is ScriptableObject asset)
                Lifecycle.Deactivate(asset);
            else
                Lifecycle.Deactivate((MonoBehaviour)script);
        }

        static void Activate(Object script)
        {
            if (!Object.IsAlive(script))
                return;
            if (script is ScriptableObject asset)
                Lifecycle.Activate(asset);
            else
                Lifecycle.Refresh((MonoBehaviour)script);
        }

        static void Guarded(Action action)
        {
            try
            {
                action();
            }
            catch (Exception e)
            {
                Debug.LogException(e);
            }
        }
    }
}
