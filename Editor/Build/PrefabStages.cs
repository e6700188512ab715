using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>
    /// Finds prefabs whose files do not refer to all stages that their components use, as those of an older version of the package. Scripts
    /// may instantiate them, and what they then need comes with the prefab alone.
    /// </summary>
    /// <remarks>What counts is what files refer to, not what is loaded: that may have been brought up to date as it was loaded.</remarks>
    sealed class PrefabStages
    {
        const string Extension = ".prefab";

        readonly Dictionary<string, HashSet<string>> stored = new Dictionary<string, HashSet<string>>();

        /// <summary>Paths of all prefabs of the project.</summary>
        public static IEnumerable<string> Paths => AssetDatabase.FindAssets("t:Prefab").Select(AssetDatabase.GUIDToAssetPath);

        /// <summary>Names of the stages that a prefab uses and its file lacks.</summary>
        public List<string> MissingIn(string path)
        {
            var missing = new List<string>();
            HashSet<string> files = Stored(path);
            if (files.Any(IsOfRuntime) && AssetDatabase.LoadAssetAtPath<GameObject>(path) is GameObject prefab && prefab != null)
                foreach (IUsesFeatures user in prefab.GetComponentsInChildren<IUsesFeatures>(true))
                    missing.AddRange(MissingOf(user.UsedFeatures, files).Except(missing));
            return missing;
        }

        /// <summary>Lets a prefab's file refer to the stages that it uses, after those of the prefabs in it.</summary>
        /// <param name="done">Gets each prefab that was looked at.</param>
        /// <param name="report">Called with each prefab that lacked some, whether it was saved, and what to say of it.</param>
        public void Update(string path, ISet<string> done, Action<string, bool, string> report)
        {
            if (!done.Add(path))
                return;
            foreach (string nested in Stored(path).Where(IsPrefab).ToList())
                Update(nested, done, report);
            stored.Remove(path);            // of what has been saved just now
            List<string> missing = MissingIn(path);
            if (missing.Count == 0)
                return;
            string stages = string.Join(", ", missing);
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path);
            if (PrefabUtility.IsPartOfImmutablePrefab(prefab) || !AssetDatabase.MakeEditable(path))
            {
                report(path, false, $"lacks the stages {stages}, and its file cannot be written. Put the asset FluidShaders into the " +
                    "Preloaded Assets of the player settings, or copy the prefab into the project.");
                return;
            }
            foreach (IUsesFeatures user in prefab.GetComponentsInChildren<IUsesFeatures>(true))
                if (MissingOf(user.UsedFeatures, Stored(path)).Any())
                    Update(user);
            PrefabUtility.SavePrefabAsset(prefab);
            stored.Remove(path);
            report(path, true, $"now refers to the stages {stages}.");
        }

        static void Update(IUsesFeatures user)
        {
            user.StageReferences.Update(user.UsedFeatures);
            var component = (Component)user;
            EditorUtility.SetDirty(component);
            if (PrefabUtility.IsPartOfPrefabInstance(component))
                PrefabUtility.RecordPrefabInstancePropertyModifications(component);
        }

        // Lists the references of the file itself and of the prefabs in it: no other file brings a component.
        HashSet<string> Stored(string path)
        {
            if (stored.TryGetValue(path, out HashSet<string> files))
                return files;
            stored[path] = files = new HashSet<string>(AssetDatabase.GetDependencies(path, false));
            foreach (string nested in files.Where(IsPrefab).ToList())
                files.UnionWith(Stored(nested));
            return files;
        }

        static IEnumerable<string> MissingOf(FeatureSet used, HashSet<string> files)
        {
            foreach (Feature feature in Features.All)
                foreach (string stage in feature.Stages)
                    if (used.Has(feature) && !files.Contains(StageAssets.PathOf(stage)))
                        yield return stage;
        }

        static bool IsPrefab(string file) => file.EndsWith(Extension, StringComparison.OrdinalIgnoreCase);

        static bool IsOfRuntime(string file) => file.EndsWith(".cs", StringComparison.Ordinal)
            && file.StartsWith(StageAssets.RuntimeFolder + "/", StringComparison.Ordinal);
    }
}
