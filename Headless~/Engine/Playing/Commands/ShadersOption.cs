using System.CommandLine;
using System.IO;
using System.Linq;
using Host.Shaders;

namespace Host.Commands
{
    /// <summary><c>--shaders</c>: who compiles HLSL.</summary>
    static class ShadersOption
    {
        public static Option<string> Create() => new Option<string>("--shaders")
        {
            Description = "Who compiles HLSL: glslang, or fxc (Microsoft's compiler; its bytecode runs through vkd3d).",
                DefaultValueFactory = _ => ShaderBackend.Glslang.Name,
        };

        /// <summary>To be called before anything is imported.</summary>
        public static void Use(string name) => ShaderBackend.Current = ShaderBackend.All.FirstOrDefault(backend => backend.Name == name)
            ?? throw new HostException($"--shaders {name}: there are {string.Join(" and ", ShaderBackend.All.Select(backend => backend.Name))}.");

        /// <summary>Prints what the option led to; nothing for the default.</summary>
        public static void Report(TextWriter output)
        {
            if (ShaderBackend.Current == ShaderBackend.Glslang)
                return;
            foreach (string line in ShaderBackend.Report())
                output.WriteLine("shaders: " + line);
        }
    }
}
