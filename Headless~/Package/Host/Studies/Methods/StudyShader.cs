using System;
using System.Collections.Generic;
using System.IO;
using Host.Shaders;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Studies.Methods
{
    /// <summary>Kernels of the study: files beside the host, that include the package's own.</summary>
    static class StudyShader
    {
        static readonly string Folder = Path.Combine(Path.GetDirectoryName(typeof(StudyShader).Assembly.Location), "MethodKernels");
        static readonly Dictionary<string, ComputeShaderSource> Sources = new();

        /// <param name="name">Of the file, without its extension.</param>
        public static ComputeShader Load(string name)
        {
            string key = ShaderBackend.Current.Name + name;
            if (!Sources.TryGetValue(key, out ComputeShaderSource source))
            {
                string file = Path.Combine(Folder, name + ".compute");
                if (!File.Exists(file))
                    throw new HostException(
                        $"{file} is not there: the kernels of the method study lie beside the host's program; build or publish it again.");
                Sources.Add(key, source = ShaderImporter.ImportCompute(file, name + ".compute", Include, new ShaderCache()));
            }
            ComputeShader shader = ComputeShader.Create(source);
            shader.name = name;
            shader.IsAsset = true;
            return shader;
        }

        static string Include(string path) => Player.Assets.ResolvePath(path);
    }
}
