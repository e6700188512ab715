using UnityEditor;

namespace Rill.Editor
{
    /// <summary>In the Editor a stage is found among the package's assets, whether or not something in the scene refers to it.</summary>
    static class StageAssets
    {
        /// <summary>GUID of the folder Runtime/Stages, wherever the package lies.</summary>
        const string FolderGuid = "30daecba402c7b162e48d7f2fd730ac6";

        static string Folder => AssetDatabase.GUIDToAssetPath(FolderGuid);

        /// <summary>The package's folder Runtime, as a path of the project.</summary>
        public static string RuntimeFolder => Folder.Substring(0, Folder.LastIndexOf('/'));

        [InitializeOnLoadMethod]
        static void Install() => StageShader.EditorFind = Find;

        /// <summary>Path of a stage's asset, as one of the project.</summary>
        public static string PathOf(string stage) => $"{Folder}/{stage}.asset";

        static StageShader Find(string stage) => AssetDatabase.LoadAssetAtPath<StageShader>(PathOf(stage));
    }
}
