using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Shaders;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Kernels of Shaders/Backends, as each backend of the shader importer makes them.</summary>
    public abstract class BackendFixture : GraphicsFixture
    {
        public static readonly string[] Backends = ShaderBackend.All.Select(backend => backend.Name).ToArray();

        static readonly Dictionary<string, ComputeShaderSource> sources = new Dictionary<string, ComputeShaderSource>();

        internal static ComputeShaderSource Import(string backend, string path, string name)
        {
            IShaderBackend before = ShaderBackend.Current;
            ShaderBackend.Current = ShaderBackend.All.Single(b => b.Name == backend);
            try
            {
                return ShaderImporter.ImportCompute(path, name, _ => null, new ShaderCache());
            }
            finally
            {
                ShaderBackend.Current = before;
            }
        }

        protected static ComputeShader Compute(string backend, string name)
        {
            string key = backend + " " + name;
            if (!sources.TryGetValue(key, out ComputeShaderSource source))
                sources.Add(key, source = Import(backend, Path.Combine(TestFolder.Path, "Shaders", "Backends", name + ".compute"),
                    $"Backends/{name}.compute"));
            return ComputeShader.Create(source);
        }

        protected static GraphicsBuffer Buffer(Array data, GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured, int stride = 4)
        {
            int bytes = data.Length * System.Runtime.InteropServices.Marshal.SizeOf(data.GetType().GetElementType());
            var buffer = new GraphicsBuffer(target, bytes / stride, stride);
            buffer.SetData(data);
            return buffer;
        }

        protected static uint[] Words(GraphicsBuffer buffer)
        {
            var words = new uint[buffer.count * buffer.stride / 4];
            buffer.GetData(words);
            return words;
        }

        protected static float[] Floats(GraphicsBuffer buffer)
            => Words(buffer).Select(word => BitConverter.ToSingle(BitConverter.GetBytes(word), 0)).ToArray();

        /// <summary>The float i in word i.</summary>
        protected static float[] Counting(int count) => Enumerable.Range(0, count).Select(i => (float)i).ToArray();
    }
}
