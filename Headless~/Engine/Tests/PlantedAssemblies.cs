using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>A folder of assemblies that a test compiles from a few lines each: a UnityEngine that offers what Unity does not, and code
    /// that falls for it.</summary>
    sealed class PlantedAssemblies : IDisposable
    {
        // Those that run here: the ones beside System.Private.CoreLib.
        static readonly List<MetadataReference> platform = Directory.GetFiles(Path.GetDirectoryName(typeof(object).Assembly.Location), "*.dll")
            .Where(path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal)
                && !path.EndsWith(".Native.dll", StringComparison.Ordinal) || Path.GetFileName(path) == "netstandard.dll")
            .Select(path => (MetadataReference)MetadataReference.CreateFromFile(path)).ToList();

        readonly List<MetadataReference> compiled = new List<MetadataReference>();

        public readonly string Root = Path.Combine(Path.GetTempPath(), "rill-planted-" + Guid.NewGuid().ToString("N"));
        public string Assemblies => Path.Combine(Root, "assemblies");

        public PlantedAssemblies() => Directory.CreateDirectory(Assemblies);

        /// <summary>Compiles an assembly over .NET and those compiled before.</summary>
        public void Compile(string name, string source)
        {
            var options = new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary);
            CSharpCompilation compilation = CSharpCompilation.Create(name, new[] { CSharpSyntaxTree.ParseText(source) },
                platform.Concat(compiled), options);
            string path = Path.Combine(Assemblies, name + ".dll");
            using (FileStream file = File.Create(path))
            {
                var errors = compilation.Emit(file).Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error);
                Assert.That(errors, Is.Empty, source);
            }
            compiled.Add(MetadataReference.CreateFromFile(path));
        }

        /// <summary>An assembly of the host's own, beside the planted ones.</summary>
        public void Bring(string name)
        {
            string path = Path.Combine(Assemblies, name + ".dll");
            File.Copy(Assembly.Load(name).Location, path);
            compiled.Add(MetadataReference.CreateFromFile(path));
        }

        public void Write(string file, string text)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(Root, file)));
            File.WriteAllText(Path.Combine(Root, file), text);
        }

        public void Dispose() => Directory.Delete(Root, true);
    }
}
