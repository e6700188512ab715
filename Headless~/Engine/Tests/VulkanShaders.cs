using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Small GLSL programs for tests of the device alone, so that they do not hang on the shader importer.</summary>
    internal static class VulkanShaders
    {
        static readonly Dictionary<string, byte[]> Compiled = new Dictionary<string, byte[]>();

        /// <summary>Resources in the order of their bindings, from 0.</summary>
        public static ShaderProgram Compute(string name, int groupX, string glsl, params ShaderResource[] resources)
            => new ShaderProgram
            {
                Name = name, Stage = ShaderStage.Compute, EntryPoint = "main", GroupX = groupX, GroupY = 1, GroupZ = 1,
                Spirv = Compile("comp", $"layout(local_size_x = {groupX}) in;\n{glsl}"), Resources = Number(resources, 0),
            };

        public static ShaderProgram Vertex(string name, string glsl, int[] locations, params ShaderResource[] resources)
            => new ShaderProgram
            {
                Name = name, Stage = ShaderStage.Vertex, EntryPoint = "main", Spirv = Compile("vert", glsl), Resources = Number(resources, 0),
                Inputs = Array.ConvertAll(locations, l => new ShaderInput { Semantic = "ATTRIBUTE" + l, Location = l }),
            };

        /// <summary>Resources in the order of their bindings, from 32.</summary>
        public static ShaderProgram Fragment(string name, string glsl, params ShaderResource[] resources)
            => new ShaderProgram { Name = name, Stage = ShaderStage.Fragment, EntryPoint = "main", Spirv = Compile("frag", glsl),
                Resources = Number(resources, 32) };

        public static ShaderResource Resource(string name, ShaderResourceKind kind, DeviceTextureDimension dimension = DeviceTextureDimension.Tex2D)
            => new ShaderResource { Name = name, Kind = kind, Stride = kind == ShaderResourceKind.Texture ? 0 : 4, Dimension = dimension };

        static ShaderResource[] Number(ShaderResource[] resources, int first)
        {
            for (int i = 0; i < resources.Length; i++) resources[i].Binding = first + i;
            return resources;
        }

        static byte[] Compile(string stage, string glsl)
        {
            if (Compiled.TryGetValue(stage + glsl, out byte[] spirv)) return spirv;
            string source = Path.Combine(Path.GetTempPath(), $"{Guid.NewGuid():N}.{stage}"), target = source + ".spv";
            File.WriteAllText(source, "#version 460\n#extension GL_EXT_samplerless_texture_functions : require\n" + glsl);
            try
            {
                var start = new ProcessStartInfo("glslangValidator", $"-V --target-env vulkan1.1 -S {stage} -o {target} {source}") {
                    RedirectStandardOutput = true };
                using (var glslang = Process.Start(start))
                {
                    string said = glslang.StandardOutput.ReadToEnd();
                    glslang.WaitForExit();
                    if (glslang.ExitCode != 0) throw new InvalidOperationException($"glslangValidator: {said}\n{glsl}");
                }
                return Compiled[stage + glsl] = File.ReadAllBytes(target);
            }
            finally
            {
                File.Delete(source);
                File.Delete(target);
            }
        }
    }
}
