using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Shaders
{
    /// <summary>Runs vkd3d-compiler, which translates Direct3D's bytecode to SPIR-V.</summary>
    static class Vkd3dCompiler
    {
        static readonly ShaderTool Tool = new ShaderTool("vkd3d-compiler", "it translates what FXC emits", "vkd3d-compiler");

        /// <summary>Changes when the tool does; starts nothing.</summary>
        public static string Identity => Tool.Identity;

        /// <exception cref="ProgramException">It cannot translate the program; the message says why in its words.</exception>
        public static byte[] Translate(byte[] dxbc)
        {
            string folder = Directory.CreateTempSubdirectory("rill-shader-").FullName;
            try
            {
                string input = Path.Combine(folder, "in.dxbc"), output = Path.Combine(folder, "out.spv");
                File.WriteAllBytes(input, dxbc);
                string log = Tool.Run(new[] { "-x", "dxbc-tpf", "-b", "spirv-binary", "-o", output, input }, out int exitCode);
                bool made = exitCode == 0 && File.Exists(output);
                List<string> remarks = log.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0
                    && !Harmless.Any(known => known.IsMatch(line))).Distinct().ToList();
                // It leaves out what it does not know, reports it, and calls that a success.
                if (!made || remarks.Count > 0)
                    throw new ProgramException($"vkd3d-compiler cannot translate it: {string.Join("; ", remarks)}");
                return File.ReadAllBytes(output);
            }
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
        }

        // Remarks (in version 1.2) on code without a fault.
        static readonly Regex[] Harmless =
        {
            // The type that shader model 5 repeats in each load.
            new Regex("^fixme:shader_sm4_read_instruction_modifier: "),
            // Which barrier it should be is read from the bytecode (Vkd3dProgram.Rewrite).
            new Regex("^fixme:vkd3d_dxbc_compiler_emit_sync: Unhandled sync flags"),
            // 0x2 globallycoherent, read from the bytecode too; 0x100 a counter.
            new Regex("^fixme:vkd3d_dxbc_compiler_emit_dcl_resource_(structured|raw|typed): Unhandled UAV flags 0x(2|100|102)\\.$"),
            // Least precisions (min16float): more is allowed; 00 is none at all. With more bits set it would also drop a sign.
            new Regex("^fixme:shader_sm4_read_param: Skipping modifier 0x000(00|04|08|10|14)001\\.$"),
            // Bits for refactoring allowed, raw buffers, no optimization, least precisions.
            new Regex("^fixme:vkd3d_dxbc_compiler_emit_dcl_global_flags: Unhandled global flags 0x[0123]?[0189]\\.$"),
        };
    }
}
