using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.UnityApi;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Host.Check.Api
{
    /// <summary>
    /// The samples' scripts and their tests compile wherever Unity compiles them, and what they name of Unity's is there in every supported
    /// version and not obsolete. They are compiled here by their assembly definitions, with and without what they ask for by #if, so that
    /// every branch is examined.
    /// </summary>
    sealed class SampleScriptsRule : Rule
    {
        const string Folder = "Samples~/", Loose = "Assembly-CSharp", TestFramework = "com.unity.test-framework";

        static readonly string[] Always = { "UNITY_5_3_OR_NEWER", "UNITY_2022_3", "UNITY_2022_3_OR_NEWER", "UNITY_STANDALONE",
            "UNITY_INCLUDE_TESTS" };
        static readonly string[] Switches = { "UNITY_EDITOR", "ENABLE_LEGACY_INPUT_MANAGER" };
        // Declarations that the host lacks. That Unity has these, with these signatures, is compared as all else.
        const string Input = "namespace UnityEngine { public class Input { public static bool anyKeyDown => false; " +
            "public static float GetAxisRaw(string axisName) => 0f; public static bool GetKey(KeyCode key) => false; " +
            "public static bool GetKeyDown(KeyCode key) => false; } }";
        // Package that no list has: declared after its public sources, Devices/Keyboard.cs and Controls/ButtonControl.cs.
        const string InputSystemAssembly = "Unity.InputSystem", InputSystemPackage = "com.unity.inputsystem";
        const string InputSystem = "namespace UnityEngine.InputSystem { public abstract class InputControl { } " +
            "public abstract class InputControl<TValue> : InputControl where TValue : struct { public TValue ReadValue() => default; } " +
            "public class InputDevice : InputControl { } public class Keyboard : InputDevice { public static Keyboard current => null; " +
            "public Controls.AnyKeyControl anyKey => null; public Controls.KeyControl aKey => null; public Controls.KeyControl dKey => null; " +
            "public Controls.KeyControl rKey => null; public Controls.KeyControl spaceKey => null; " +
            "public Controls.KeyControl leftArrowKey => null; public Controls.KeyControl rightArrowKey => null; } } " +
            "namespace UnityEngine.InputSystem.Controls { public class AxisControl : InputControl<float> { } " +
            "public class ButtonControl : AxisControl { public bool isPressed => false; public bool wasPressedThisFrame => false; } " +
            "public class AnyKeyControl : ButtonControl { } public class KeyControl : ButtonControl { } }";

        /// <summary>An assembly of the samples; loose scripts are the project's own, whose Assembly-CSharp refers to all that exists.</summary>
        sealed class SampleAssembly
        {
            public string Name = Loose;
            public AssemblyDefinition Definition;       // null for loose scripts
            public List<string> Files = new();

            public string Where => Definition?.File ?? $"{Files[0]}, which lies in no folder with an .asmdef";

            /// <summary>Symbols with which it is always compiled.</summary>
            public IEnumerable<string> Symbols => Always.Concat(Definition?.DefineConstraints ?? Array.Empty<string>());

            /// <summary>Those that it may ask for by #if.</summary>
            public IEnumerable<string> Asked => Switches.Concat(Definition == null ? Array.Empty<string>()
                : Definition.VersionDefines.Select(define => define.Symbol).Except(Definition.DefineConstraints));

            public bool NeedsPresent(string module) => Definition != null && Definition.NeedsPresent(module);
        }

        PackageTree package;
        List<AssemblyDefinition> known;
        HashSet<string> dependencies, names;
        UnityModules modules;
        List<MetadataReference> unity;      // and .NET, which all assemblies are compiled against

        public override string Name => "API: the samples' scripts and tests use what every version has, and ask for what not every project has";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<string> files = package.WithExtension(".cs").Where(file => file.StartsWith(Folder, StringComparison.Ordinal)).ToList();
            if (files.Count == 0)
                findings.Fault($"no C# source below {Folder} of {package.Root}");
            this.package = package;
            known = AssemblyDefinition.All(package, findings);
            dependencies = !package.Has("package.json") ? new HashSet<string>()
                : PackageManifest.Read(package, findings)?.Dependencies.Select(dependency => dependency.Key).ToHashSet() ?? new HashSet<string>();
            modules = UnityModules.Load();
            names = SourceNamesRule.ConstantNames(PackageAssemblies.StandIns
                .Select(name => PackageAssemblies.Find(package.Assemblies, name)).Where(path => path != null)
                .Select(path => new CompiledAssembly(path)));

            unity = SourceNamesRule.References(package).ToList();
            unity.Add(Create("UnityEngine.InputLegacyModule", new[] { CSharpSyntaxTree.ParseText(Input) }, unity).ToMetadataReference());

            List<SampleAssembly> all = Group(files, findings);
            var types = new HashSet<string>();
            var members = new HashSet<string>();
            var said = new HashSet<string>();
            var done = new Dictionary<string, MetadataReference>();
            foreach (SampleAssembly assembly in all)
            {
                var found = new Findings();
                if (assembly.Definition != null)
                    References(assembly, all, found);
                Compile(assembly, all, done, types, members, found);
                foreach (string fault in found.Faults.Where(said.Add))
                    findings.Fault(fault);
            }
            findings.Looked = $"{files.Count} sources in {all.Count} assemblies, with and without what they ask for: {types.Count} types and " +
                $"{members.Count} members of Unity against {string.Join(", ", UnityCatalogs.Supported.Select(unity => unity.Version))}";
            return findings;
        }

        // Each after those that it refers to.
        List<SampleAssembly> Group(List<string> files, Findings findings)
        {
            List<AssemblyDefinition> definitions = AssemblyDefinition.Read(package, package.Files.Where(file =>
                file.StartsWith(Folder, StringComparison.Ordinal)), findings);
            var groups = definitions.ToDictionary(definition => definition.Name,
                definition => new SampleAssembly { Name = definition.Name, Definition = definition });
            var loose = new SampleAssembly();
            foreach (string file in files)
                (AssemblyDefinition.Owner(file, definitions) is { } owner ? groups[owner.Name] : loose).Files.Add(file);
            var ordered = new List<SampleAssembly>();
            void Add(SampleAssembly assembly)
            {
                foreach (string reference in assembly.Definition?.References ?? Array.Empty<string>())
                    if (groups.TryGetValue(reference, out SampleAssembly earlier) && !ordered.Contains(earlier) && earlier != assembly)
                        Add(earlier);
                if (!ordered.Contains(assembly) && assembly.Files.Count > 0)
                    ordered.Add(assembly);
            }
            foreach (SampleAssembly assembly in groups.Values.Append(loose))
                Add(assembly);
            return ordered;
        }

        // Whatever an assembly refers to is there in every project, or it is compiled only where that is.
        void References(SampleAssembly assembly, List<SampleAssembly> all, Findings findings)
        {
            AssemblyDefinition definition = assembly.Definition;
            foreach (string reference in definition.References.Concat(definition.PrecompiledReferences))
            {
                AssemblyDefinition target = known.Find(d => d.Name == reference) ?? all.Find(a => a.Name == reference)?.Definition;
                IEnumerable<string> needed = reference is "UnityEngine.TestRunner" or "UnityEditor.TestRunner" or "nunit.framework.dll"
                    ? new[] { TestFramework }
                    : target != null ? target.VersionDefines.Where(define => target.NeedsPresent(define.Package)).Select(define => define.Package)
                    : Array.Empty<string>();
                foreach (string module in needed.Distinct().Where(module => !dependencies.Contains(module) && !definition.NeedsPresent(module)))
                    findings.Fault($"{definition.File} refers to {reference}, which is there only with {module}, no dependency of " +
                        "package.json: a project without it does not compile. Add a version define, and its symbol to the define constraints");
                if (target is { IsForTests: true } && !definition.IsTest)
                    findings.Fault($"{definition.File} refers to {reference}, which players lack: add UNITY_INCLUDE_TESTS to the define constraints");
                if (reference == InputSystemAssembly && definition.VersionDefines.All(define => define.Package != InputSystemPackage))
                    findings.Fault($"{definition.File} refers to {reference}, and has no version define by which scripts tell whether it is there");
                if (target == null && !needed.Any() && reference is not (InputSystemAssembly or "Unity.Mathematics"))
                    findings.Fault($"{definition.File} refers to {reference}, of which nothing is known here: add it to {nameof(SampleScriptsRule)}");
            }
        }

        void Compile(SampleAssembly assembly, List<SampleAssembly> all, Dictionary<string, MetadataReference> done, ISet<string> types,
            ISet<string> members, Findings findings)
        {
            string[] own = (assembly.Definition?.References ?? known.Where(d => d.DefineConstraints.Length == 0).Select(d => d.Name)).ToArray();
            List<MetadataReference> references = unity.Concat(own
                .Select(name => PackageAssemblies.Find(package.Assemblies, name)).Where(path => path != null && !IsStandIn(path))
                .Select(path => MetadataReference.CreateFromFile(path))).Concat(own.Where(done.ContainsKey).Select(name => done[name])).ToList();
            if (own.Contains(InputSystemAssembly))
                references.Add(Create(InputSystemAssembly, new[] { CSharpSyntaxTree.ParseText(InputSystem) }, references).ToMetadataReference());

            // None, all, and all but each: whichever branch of an #if, #elif or #else is compiled by one of these.
            string[] asked = assembly.Asked.ToArray();
            IEnumerable<string[]> sets = asked.Select(left => asked.Where(symbol => symbol != left).ToArray())
                .Append(asked).Append(Array.Empty<string>());
            foreach (string[] symbols in sets)
                done[assembly.Name] = Compile(assembly, references, assembly.Symbols.Concat(symbols), types, members, findings);
        }

        MetadataReference Compile(SampleAssembly assembly, List<MetadataReference> references, IEnumerable<string> symbols, ISet<string> types,
            ISet<string> members, Findings findings)
        {
            var options = new CSharpParseOptions(LanguageVersion.CSharp9, preprocessorSymbols: symbols);
            List<SyntaxTree> trees = assembly.Files.Select(file =>
                CSharpSyntaxTree.ParseText(SourceText.From(package.Read(file), System.Text.Encoding.UTF8), options, file)).ToList();
            foreach (SyntaxTree tree in trees)
                CheckConditions(tree, assembly.Asked.ToArray(), findings);
            CSharpCompilation compilation = Create(assembly.Name, trees, references);
            using var image = new MemoryStream();
            bool compiles = true;
            foreach (Diagnostic error in compilation.Emit(image).Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error))
            {
                findings.Fault($"{SourceNamesRule.Where(error.Location)}: {error.GetMessage()}");
                compiles = false;
            }
            if (compiles)
            {
                image.Position = 0;
                using var compiled = new CompiledAssembly(new MemoryStream(image.ToArray()));
                UnityMembersRule.Examine(compiled, UnityCatalogs.Supported, types, members, findings,
                    (what, _) => what.StartsWith("UnityEngine.InputSystem.", StringComparison.Ordinal));
                SourceNamesRule.Examine(compilation, names, UnityCatalogs.Supported, new HashSet<string>(), findings);
                foreach ((string module, ApiTypeName type) in ModulesRule.Uses(compiled, modules, findings, InputSystemAssembly)
                    .Where(use => !dependencies.Contains(use.Module) && !assembly.NeedsPresent(use.Module)))
                    findings.Fault($"{assembly.Where}: it uses {type} of {module}, which is not a dependency of package.json: a project without " +
                        "that module does not compile. Give the scripts an .asmdef with a version define and a define constraint");
            }
            return compilation.ToMetadataReference();
        }

        static bool IsStandIn(string path) => PackageAssemblies.StandIns.Contains(Path.GetFileNameWithoutExtension(path));

        static CSharpCompilation Create(string name, IEnumerable<SyntaxTree> trees, IEnumerable<MetadataReference> references)
            => CSharpCompilation.Create(name, trees, references, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));

        static void CheckConditions(SyntaxTree tree, string[] asked, Findings findings)
        {
            foreach (ConditionalDirectiveTriviaSyntax condition in tree.GetRoot().DescendantTrivia().Select(trivia => trivia.GetStructure())
                .OfType<ConditionalDirectiveTriviaSyntax>())
                foreach (string symbol in condition.Condition.DescendantNodesAndSelf().OfType<IdentifierNameSyntax>()
                    .Select(name => name.Identifier.ValueText).Except(asked))
                    findings.Fault($"{SourceNamesRule.Where(condition.GetLocation())}: #if {symbol}: only {string.Join(" and ", asked)} are " +
                        $"compiled for both here, so that a branch would go unexamined. Do without it, or add it to {nameof(SampleScriptsRule)}.");
        }
    }
}
