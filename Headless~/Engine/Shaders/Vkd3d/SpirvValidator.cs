using System.IO;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>Runs spirv-val: a driver may do anything with a module that is wrong.</summary>
    static class SpirvValidator
    {
        static readonly ShaderTool Tool = new ShaderTool("spirv-val", "it checks what vkd3d makes of FXC's bytecode", "spirv-tools");

        public static string Identity => Tool.Identity;

        /// <exception cref="ProgramException">The module breaks a rule of SPIR-V for Vulkan 1.1.</exception>
        public static void Check(byte[] spirv)
        {
            string file = Path.GetTempFileName();
            try
            {
                File.WriteAllBytes(file, spirv);
                string log = Tool.Run(new[] { "--target-env", "vulkan1.1", "--scalar-block-layout", file }, out int exitCode);
                if (exitCode != 0)
                    throw new ProgramException($"vkd3d's module is not valid: " +
                        $"{string.Join(" ", log.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0))}");
            }
            finally
            {
                File.Delete(file);
            }
        }
    }
}
