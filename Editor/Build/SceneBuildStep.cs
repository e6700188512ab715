using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Rill.Editor
{
    /// <summary>
    /// Before a scene goes into a build, its components refer to the stages that they use: also in a scene that has not been
    /// saved since the package was updated. The scene's file stays as it is.
    /// </summary>
    sealed class SceneBuildStep : IProcessSceneWithReport
    {
        public int callbackOrder => 0;

        /// <summary>Also called for a scene that play mode begins with; the report is then null.</summary>
        public void OnProcessScene(Scene scene, BuildReport report)
        {
            foreach (GameObject root in scene.GetRootGameObjects())
                foreach (IUsesFeatures user in root.GetComponentsInChildren<IUsesFeatures>(true))
                    user.StageReferences.Update(user.UsedFeatures);
        }
    }
}
