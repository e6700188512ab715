using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>The backends, the one in use, and what it has been used for.</summary>
    static class ShaderBackend
    {
        public static readonly IShaderBackend Glslang = new GlslangBackend();
        public static readonly IShaderBackend Fxc = new FxcBackend(Untranslatable.All);
        public static readonly IReadOnlyList<IShaderBackend> All = new[] { Glslang, Fxc };

        // name to why glslang made it; null = it did not
        static readonly SortedDictionary<string, string> asBytecode = new SortedDictionary<string, string>();

        static readonly SortedDictionary<string, string> exempt = new SortedDictionary<string, string>();     // test to why

        /// <summary>Shader files imported from now on are compiled by it.</summary>
        public static IShaderBackend Current { get; set; } = Glslang;

        public static void Tally(IShaderBackend backend, CompiledProgram compiled)
        {
            if (backend != Fxc)
                return;
            lock (asBytecode)
                asBytecode[compiled.Program.Name] = compiled.WhyGlslang;
        }

        /// <summary>A test of what glslang makes runs with glslang, whatever is in use.</summary>
        public static void Exempt(string test, string why)
        {
            lock (exempt)
                exempt[test] = why;
        }

        /// <summary>Names of the programs that ran as FXC's bytecode.</summary>
        public static List<string> Bytecode()
        {
            lock (asBytecode)
                return asBytecode.Where(p => p.Value == null).Select(p => p.Key).ToList();
        }

        /// <summary>Uses of the backends, to be added to another process's.</summary>
        public static (Dictionary<string, string> Programs, Dictionary<string, string> Exempt) Tallies()
        {
            lock (asBytecode)
                lock (exempt)
                    return (new Dictionary<string, string>(asBytecode), new Dictionary<string, string>(exempt));
        }

        /// <param name="programs">Name to why glslang made it, or null; a program that glslang made anywhere counts as that.</param>
        /// <param name="exemptTests">Test to why.</param>
        public static void Add(Dictionary<string, string> programs, Dictionary<string, string> exemptTests)
        {
            lock (asBytecode)
                foreach (KeyValuePair<string, string> program in programs)
                    asBytecode[program.Key] = program.Value ?? (asBytecode.TryGetValue(program.Key, out string why) ? why : null);
            foreach (KeyValuePair<string, string> test in exemptTests)
                Exempt(test.Key, test.Value);
        }

        /// <summary>Reports what ran as FXC's bytecode, and what did not and why.</summary>
        public static IEnumerable<string> Report()
        {
            yield return $"{Bytecode().Count} programs ran as FXC's bytecode, through vkd3d";
            lock (asBytecode)
                foreach (KeyValuePair<string, string> program in asBytecode.Where(p => p.Value != null))
                    yield return $"compiled by glslang instead: {program.Key}: {program.Value}";
            lock (exempt)
                foreach (KeyValuePair<string, string> test in exempt)
                    yield return $"a test of glslang's programs: {test.Key}: {test.Value}";
        }
    }
}
