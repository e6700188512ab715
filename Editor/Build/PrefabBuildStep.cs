using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>
    /// Before a build: a prefab whose components use stages that its file does not refer to is brought up to date and saved.
    /// Scripts may instantiate it, and what they then need comes with the prefab alone.
    /// </summary>
    sealed class PrefabBuildStep : IPreprocessBuildWithReport
    {
        public int callbackOrder => 0;

        public void OnPreprocessBuild(BuildReport report)
        {
            foreach (string guid in AssetDatabase.FindAssets("t:Prefab"))
                BringUpToDate(AssetDatabase.GUIDToAssetPath(guid));
        }

        // What the file refers to and not what is loaded: OnValidate has brought that up to date already.
        static void BringUpToDate(string path)
        {
            string[] stored = AssetDatabase.GetDependencies(path, true);
            if (!UsesTheRuntime(stored))
                return;
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path);
            var missing = new List<string>();
            foreach (IUsesStages user in prefab.GetComponentsInChildren<IUsesStages>(true))
                Update(user, stored, missing);
            if (missing.Count == 0)
                return;
            string stages = string.Join(", ", missing);
            if (PrefabUtility.IsPartOfImmutablePrefab(prefab))
            {
                Debug.LogError($"Rill: the prefab {path} uses stages that it does not refer to ({stages}), and its package cannot be " +
                    $"written. Put the asset FluidShaders into the Preloaded Assets of the player settings, or copy the prefab into " +
                    $"the project.", prefab);
                return;
            }
            PrefabUtility.SavePrefabAsset(prefab);
            Debug.Log($"Rill: the prefab {path} now refers to the stages that it uses: {stages}.", prefab);
        }

        static void Update(IUsesStages user, string[] stored, List<string> missing)
        {
            user.StageReferences.Update(user.UsedStages);
            bool isStale = false;
            foreach (StageShader stage in user.StageReferences.Stages)
            {
                if (Array.IndexOf(stored, AssetDatabase.GetAssetPath(stage)) >= 0)
                    continue;
                isStale = true;
                if (!missing.Contains(stage.name))
                    missing.Add(stage.name);
            }
            if (!isStale)
                return;
            var component = (Component)user;
            EditorUtility.SetDirty(component);
            if (PrefabUtility.IsPartOfPrefabInstance(component))
                PrefabUtility.RecordPrefabInstancePropertyModifications(component);
        }

        static bool UsesTheRuntime(string[] files)
        {
            string runtime = StageAssets.RuntimeFolder + "/";
            foreach (string file in files)
                if (file.EndsWith(".cs", StringComparison.Ordinal) && file.StartsWith(runtime, StringComparison.Ordinal))
                    return true;
            return false;
        }
    }
}
