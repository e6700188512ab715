using System.Collections.Generic;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Rill.Editor
{
    /// <summary>
    /// Applies the settings that OnValidate found changed, in the Editor's next update or before what they are part of is saved: after a
    /// change in the inspector or by a script, an undo, a paste, an override that was reverted, and a load.
    /// </summary>
    static class SettingsQueue
    {
        static readonly object gate = new object();
        static List<IAppliesSettings> waiting = new List<IAppliesSettings>(), applied = new List<IAppliesSettings>();

        [InitializeOnLoadMethod]
        static void Install()
        {
            ChangedSettings.EditorQueue = Add;
            EditorApplication.update += Apply;
            EditorSceneManager.sceneSaving += OnSaving;
            PrefabStage.prefabSaving += OnSaving;
        }

        // On whatever thread Unity calls OnValidate.
        static void Add(IAppliesSettings of)
        {
            lock (gate)
                waiting.Add(of);
        }

        static void OnSaving(Scene scene, string path) => Apply();

        static void OnSaving(GameObject prefab) => Apply();

        /// <summary>Whatever waits; what that changes in turn waits for the next update.</summary>
        internal static void Apply()
        {
            lock (gate)
                (waiting, applied) = (applied, waiting);
            try
            {
                foreach (IAppliesSettings of in applied)
                    if ((Object)of != null)     // it may have been destroyed since
                        Apply(of);
            }
            finally
            {
                applied.Clear();
            }
        }

        static void Apply(IAppliesSettings of)
        {
            if (of is IUsesFeatures user && user.StageReferences.Update(user.UsedFeatures))
                Store((Component)user);
            of.ApplySettings();
        }

        // Changes by the user are saved anyway, with all that follows from them; the latter alone is not a user's change. A prefab instance
        // forgets what it is not told to store.
        static void Store(Component user)
        {
            if (EditorUtility.IsDirty(user) && PrefabUtility.IsPartOfPrefabInstance(user))
                PrefabUtility.RecordPrefabInstancePropertyModifications(user);
        }
    }
}
