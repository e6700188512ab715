using UnityEditor;

namespace Rill.Editor
{
    /// <summary>In the Editor a stage is found among the package's assets, whether or not something in the scene refers to it.</summary>
    static class StageAssets
    {
        /// <summary>Of the folder Runtime/Stages, wherever the package lies.</summary>
        const string FolderGuid = "30daecba402c7b162e48d7f2fd730ac6";

        [InitializeOnLoadMethod]
        static void Install() => StageShader.EditorFind = Find;

        static StageShader Find(string stage) => AssetDatabase.LoadAssetAtPath<StageShader>($"{AssetDatabase.GUIDToAssetPath(FolderGuid)}/{stage}.asset");
    }
}
