using System;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>Compute shaders of the tests alone, under Tests/Editor/Probes, which no build contains.</summary>
    static class LayoutProbes
    {
        const string FolderGuid = "7ff61df60e45f6633e43700afd876031";

        public static ComputeShader Load(string name)
        {
            var shader = AssetDatabase.LoadAssetAtPath<ComputeShader>($"{AssetDatabase.GUIDToAssetPath(FolderGuid)}/{name}.compute");
            return shader != null ? shader : throw new InvalidOperationException($"Tests/Editor/Probes/{name}.compute was not imported.");
        }
    }
}
