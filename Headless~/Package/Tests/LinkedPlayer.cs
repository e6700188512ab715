using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Security;
using Host.Assets;
using Host.Pipelines;
using NUnit.Framework;
using UnityEngine.Scripting;

namespace Host.Tests
{
    /// <summary>
    /// The package's assemblies as a player of one sample has them after managed code stripping, in a project with a render pipeline and
    /// with all modules that the package knows.
    /// </summary>
    /// <remarks>
    /// Unity's linker is a closed version of .NET's. This one follows its manual ("The Unity linker", "Unity linker marking rules
    /// reference"): it processes the assemblies that hold types of the scene, those with [AlwaysLinkAssembly], and whatever these refer
    /// to; all others are left out. Roots are the components and assets that the scene and its files refer to, with all their members, and
    /// methods with [RuntimeInitializeOnLoadMethod] or [Preserve] of what is processed. That is stricter than Unity at High, which keeps
    /// every MonoBehaviour and ScriptableObject of an assembly that it processes. The engine and the pipelines are not linked.
    /// </remarks>
    sealed class LinkedPlayer : IDisposable
    {
        static readonly string[] OfPackage = { "Rill", "Rill.Physics", "Rill.Terrain", "Rill.TerrainPhysics", "Rill.Timeline", "Rill.Samples" };

        // Folder of these tests; the host that runs them may lie elsewhere.
        static readonly string Here = Path.GetDirectoryName(typeof(LinkedPlayer).Assembly.Location);

        readonly string folder = Directory.CreateTempSubdirectory("rill-linked-").FullName;
        /// <summary>Compiled for the player, by name.</summary>
        readonly Dictionary<string, Image> images = new();

        string Before => Path.Combine(folder, "compiled");
        string After => Path.Combine(folder, "linked");

        /// <summary>Names of the assemblies that the linker processes.</summary>
        public IReadOnlyCollection<string> Processed { get; }

        /// <summary>"Assembly: Type.Method" of each method that the engine calls by its attribute, before linking.</summary>
        public IReadOnlyList<string> Hooks => images.Values.SelectMany(image => image.Hooks.Select(hook => $"{image.Name}: {hook.Type}.{hook.Name}"))
            .OrderBy(hook => hook, StringComparer.Ordinal).ToList();

        /// <param name="unmarked">Assemblies that are taken as ones without [AlwaysLinkAssembly].</param>
        public LinkedPlayer(string sample, PipelineKind pipeline, params string[] unmarked)
        {
            try
            {
                Compile(pipeline);
                ILookup<string, string> types = TypesOf(sample);
                Processed = Reached(types.Select(found => found.Key)
                    .Concat(images.Values.Where(image => image.IsAlwaysLinked && !unmarked.Contains(image.Name)).Select(image => image.Name)));
                string roots = Path.Combine(folder, "roots.xml");
                File.WriteAllText(roots, Roots(types));
                Link(roots);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public void Dispose() => Directory.Delete(folder, true);

        /// <summary>File of an assembly that is left; null where none is.</summary>
        public string Find(string assembly) => Path.Combine(After, assembly + ".dll") is var file && File.Exists(file) ? file : null;

        /// <summary>Those of <see cref="Hooks"/> that are left with all of their code.</summary>
        public IReadOnlyList<string> HooksLeft()
        {
            var left = new List<string>();
            foreach (Image image in images.Values.Where(image => Find(image.Name) != null))
            {
                var linked = new Image(Find(image.Name));
                left.AddRange(image.Hooks.Where(hook => linked.Methods.Contains(hook)).Select(hook => $"{image.Name}: {hook.Type}.{hook.Name}"));
            }
            left.Sort(StringComparer.Ordinal);
            return left;
        }

        void Compile(PipelineKind pipeline)
        {
            Directory.CreateDirectory(Before);
            foreach (string name in OfPackage.Append("Unity.Mathematics"))
                Add(name, File.ReadAllBytes(Path.Combine(Here, name + ".dll")));
            PipelineAssemblies stands = PipelineAssemblies.Of(PipelineVersion.Find("17"));
            foreach ((string name, byte[] image) in stands.Images)
                File.WriteAllBytes(Path.Combine(Before, name + ".dll"), image);
            AdapterDefinition adapter = AdapterDefinition.Find(PackageFolder.Path, pipeline);
            Add(adapter.Name, stands.CompileAdapter(adapter, false, out List<string> errors));
            Assert.That(errors, Is.Empty);
        }

        void Add(string name, byte[] image)
        {
            string file = Path.Combine(Before, name + ".dll");
            File.WriteAllBytes(file, image);
            images.Add(name, new Image(file));
        }

        // Types of components and assets, by assembly.
        static ILookup<string, string> TypesOf(string sample)
        {
            LocatedScene located = Session.Locate(sample);
            var project = new ProjectAssets(located.Mounts, OfPackage.Select(Assembly.Load), strict: true);
            var files = new List<string> { located.AssetPath };
            for (int i = 0; i < files.Count; i++)
                files.AddRange(project.ReferencesIn(files[i]).Except(files).ToList());
            return files.Where(file => file.EndsWith(".cs", StringComparison.Ordinal))
                .Select(file => project.Scripts.Find(project.Index.ByPath(file), out _)).Where(type => type != null)
                .ToLookup(type => type.Assembly.GetName().Name, type => type.FullName);
        }

        HashSet<string> Reached(IEnumerable<string> from)
        {
            var reached = new HashSet<string>();
            var next = new Queue<string>(from);
            while (next.Count > 0)
                if (images.TryGetValue(next.Dequeue(), out Image image) && reached.Add(image.Name))
                    foreach (string reference in image.References)
                        next.Enqueue(reference);
            return reached;
        }

        string Roots(ILookup<string, string> types)
        {
            var text = new StringWriter();
            text.WriteLine("<linker>");
            foreach (string name in Processed)
            {
                text.WriteLine($"<assembly fullname=\"{name}\">");
                foreach (string type in types[name])
                    text.WriteLine($"<type fullname=\"{type}\" preserve=\"all\"/>");
                foreach (Method hook in images[name].Hooks)
                    text.WriteLine($"<type fullname=\"{SecurityElement.Escape(hook.Type)}\"><method name=\"{hook.Name}\"/></type>");
                text.WriteLine("</assembly>");
            }
            text.WriteLine("</linker>");
            return text.ToString();
        }

        void Link(string roots)
        {
            var arguments = new List<string> { "exec", "--runtimeconfig", Path.Combine(Here, "Host.runtimeconfig.json"),
                Path.Combine(Here, "illink", "illink.dll"), "-x", roots, "-d", Before, "-d", Here,
                "-d", Path.GetDirectoryName(typeof(object).Assembly.Location), "-out", After,
                "--action", "skip", "--used-attrs-only", "true", "--enable-opt", "sealer", "--skip-unresolved", "false", "--singlewarn" };
            foreach (string name in images.Keys)
                arguments.AddRange(new[] { "--action", "link", name });
            var start = new ProcessStartInfo("dotnet", arguments) { RedirectStandardOutput = true, RedirectStandardError = true };
            using var process = Process.Start(start);
            var errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.Zero, output + errors.Result);
        }

        sealed record Method(string Type, string Name, int Bytes);

        /// <summary>Part of an assembly's metadata that the linker goes by.</summary>
        sealed class Image
        {
            static readonly string[] Rooted = { nameof(UnityEngine.RuntimeInitializeOnLoadMethodAttribute), nameof(PreserveAttribute) };

            public readonly string Name;
            public readonly bool IsAlwaysLinked;
            public readonly List<string> References;
            public readonly HashSet<Method> Methods = new();
            public readonly List<Method> Hooks = new();

            public Image(string path)
            {
                using var file = new PEReader(File.OpenRead(path));
                MetadataReader reader = file.GetMetadataReader();
                Name = reader.GetString(reader.GetAssemblyDefinition().Name);
                IsAlwaysLinked = Check.AttributeNames.Has(reader, reader.GetAssemblyDefinition().GetCustomAttributes(),
                    nameof(AlwaysLinkAssemblyAttribute));
                References = reader.AssemblyReferences.Select(handle => reader.GetString(reader.GetAssemblyReference(handle).Name)).ToList();
                foreach (MethodDefinition method in reader.MethodDefinitions.Select(reader.GetMethodDefinition))
                {
                    int bytes = method.RelativeVirtualAddress == 0 ? 0 : file.GetMethodBody(method.RelativeVirtualAddress).GetILBytes().Length;
                    var found = new Method(NameOf(reader, method.GetDeclaringType()), reader.GetString(method.Name), bytes);
                    Methods.Add(found);
                    if (Check.AttributeNames.Has(reader, method.GetCustomAttributes(), Rooted))
                        Hooks.Add(found);
                }
            }

            static string NameOf(MetadataReader reader, TypeDefinitionHandle handle)
            {
                TypeDefinition type = reader.GetTypeDefinition(handle);
                string name = reader.GetString(type.Name);
                return !type.GetDeclaringType().IsNil ? $"{NameOf(reader, type.GetDeclaringType())}/{name}"
                    : type.Namespace.IsNil ? name : $"{reader.GetString(type.Namespace)}.{name}";
            }
        }
    }
}
