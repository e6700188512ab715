using System.Collections.Generic;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>
    /// Before a build: names the prefabs that lack stages which they use. They stay as they are, since a build writes no files of the
    /// project; the menu does.
    /// </summary>
    sealed class PrefabBuildStep : IPreprocessBuildWithReport
    {
        const string Menu = "Tools/Rill/Update Prefabs";

        public int callbackOrder => 0;

        public void OnPreprocessBuild(BuildReport report)
        {
            var stages = new PrefabStages();
            foreach (string path in PrefabStages.Paths)
                if (stages.MissingIn(path) is List<string> missing && missing.Count > 0)
                    Debug.LogWarning($"Rill: the prefab {path} uses stages that its file does not refer to, so that this build may lack " +
                        $"them: {string.Join(", ", missing)}. Run {Menu.Replace("/", " > ")} and build again.",
                        AssetDatabase.LoadAssetAtPath<GameObject>(path));
        }

        [MenuItem(Menu)]
        internal static void UpdatePrefabs()
        {
            var stages = new PrefabStages();
            var done = new HashSet<string>();
            int reported = 0;
            foreach (string path in PrefabStages.Paths)
                stages.Update(path, done, (prefab, isUpdated, what) =>
                {
                    reported++;
                    string message = $"Rill: the prefab {prefab} {what}";
                    Object asset = AssetDatabase.LoadAssetAtPath<GameObject>(prefab);
                    if (isUpdated)
                        Debug.Log(message, asset);
                    else
                        Debug.LogWarning(message, asset);
                });
            if (reported == 0)
                Debug.Log("Rill: each prefab refers to the stages that it uses.");
        }
    }
}
