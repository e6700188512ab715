using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using Host.Pipelines;

namespace Host.Check
{
    /// <summary>The runtime assemblies call nothing that would stall a frame, fill the garbage collector, or take a texture's format for
    /// granted.</summary>
    /// <remarks>Stricter than "not in per-frame paths", and so decidable: what may do so, and when, is written down.</remarks>
    sealed class FrameCallsRule : Rule
    {
        const string AnyType = "*", NotAsked = "does not ask whether the device has the format; use GpuTexture.Create";

        static readonly (string type, string member, string reason)[] Forbidden =
        {
            ("ComputeBuffer", "GetData", "waits for the GPU; use AsyncGPUReadback"),
            ("GraphicsBuffer", "GetData", "waits for the GPU; use AsyncGPUReadback"),
            ("AsyncGPUReadbackRequest", "WaitForCompletion", "waits for the GPU"),
            ("AsyncGPUReadback", "WaitAllRequests", "waits for the GPU, and for every readback of the game"),
            ("Readback", "Complete", "waits for the GPU"),
            ("IPendingReadback", "Complete", "waits for the GPU"),
            ("ReadbackRing", "Complete", "waits for the GPU"),
            ("CommandBuffer", "WaitAllAsyncReadbackRequests", "waits for the GPU"),
            ("Texture2D", "ReadPixels", "waits for the GPU; use AsyncGPUReadback"),
            ("GL", "Flush", "waits for the driver"),
            ("Thread", "Sleep", "stalls the frame"),
            ("Task", "Wait", "stalls the frame"),
            ("GC", "Collect", "stalls the frame"),
            ("Object", "FindObjectOfType", "walks the whole scene; take a serialized reference"),
            ("Object", "FindObjectsOfType", "walks the whole scene; take a serialized reference"),
            ("Object", "FindFirstObjectByType", "walks the whole scene; take a serialized reference"),
            ("Object", "FindObjectsByType", "walks the whole scene; take a serialized reference"),
            ("GameObject", "Find", "walks the whole scene; take a serialized reference"),
            ("GameObject", "FindWithTag", "walks the whole scene; take a serialized reference"),
            ("GameObject", "FindGameObjectsWithTag", "walks the whole scene; take a serialized reference"),
            ("Resources", "FindObjectsOfTypeAll", "walks everything that is loaded"),
            ("Component", "SendMessage", "finds methods by name"),
            ("Enumerable", AnyType, "LINQ allocates"),
            ("RenderTexture", ".ctor", NotAsked),
            ("RenderTexture", "GetTemporary", NotAsked),
            ("CommandBuffer", "GetTemporaryRT", NotAsked),
        };

        // A method that is called once in a while, and why it may.
        static readonly (string method, string member, string reason)[] Allowed =
        {
            ("MeshSdfBaker.Complete", "WaitForCompletion", "a bake that is waited for is a tool; Step does not wait"),
            ("MeshSdfBaker.Dispose", "WaitForCompletion", "the memory that a read-back fills must outlive it; happens when a bake is canceled"),
            ("Measurements.FindParticles", "GetData", "for the assertions of Rill.Testing, which nothing of a game calls"),
            ("StatisticsPass.Complete", "Complete", "the same: Measurements.MeasureNow"),
            ("EmitterStates.Complete", "Complete", "the same: SceneParts.FindBlockedEmitters"),
            ("Drains.Complete", "Complete", "the same"),
            ("Queries.Complete", "Complete", "for tests and tools of a user, as FlushQueries and Flush say; nothing else of the package calls it"),
            ("QueryBatch.Complete", "Complete", "the same"),
            ("ReadbackRing.Complete", "Complete", "the same"),
            ("PendingReadbacks.Add", "Complete", "as play ends or scripts are loaded again, after which nothing comes back"),
            ("PendingReadbacks.End", "Complete", "the same"),
            ("Readback.Complete", "WaitForCompletion", "its callers are in this list"),
            ("FluidRecorder.OnDisable", "WaitForCompletion",
                "ends the file of a recorder that is disabled or destroyed while it records, as its documentation says; Stop does not wait"),
            ("GpuTexture.Create", ".ctor", "it asks"),
            ("SnapshotCapture.Complete", "WaitForCompletion", "as play ends or scripts are loaded again, after which nothing comes back"),
        };

        public override string Name => "code: the runtime calls nothing that waits for the GPU, walks the scene, allocates by LINQ or takes a " +
            "format for granted";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int methods = 0, calls = 0;
            var used = new HashSet<(string, string)>();
            foreach (AssemblyDefinition definition in RuntimeAssemblies.Of(package, findings))
                using (var file = new PEReader(RuntimeAssemblies.Open(package, definition)))
                {
                    MetadataReader reader = file.GetMetadataReader();
                    foreach (MethodDefinition method in reader.MethodDefinitions.Select(reader.GetMethodDefinition)
                        .Where(m => m.RelativeVirtualAddress != 0))
                    {
                        methods++;
                        string caller =
                            $"{reader.GetString(reader.GetTypeDefinition(method.GetDeclaringType()).Name)}.{reader.GetString(method.Name)}";
                        foreach (EntityHandle called in Code.MethodsCalled(file.GetMethodBody(method.RelativeVirtualAddress).GetILBytes()))
                        {
                            calls++;
                            (string type, string member) = NameOf(reader, called);
                            foreach ((_, _, string reason) in Forbidden.Where(f => f.type == type && (f.member == member || f.member == AnyType)))
                                if (Allowed.Any(a => a.method == caller && a.member == member))
                                    used.Add((caller, member));
                                else
                                    findings.Fault($"{definition.Name}: {caller} calls {type}.{member}, which {reason}");
                        }
                    }
                }
            foreach ((string method, string member, _) in Allowed.Where(a => !used.Contains((a.method, a.member))))
                findings.Fault($"{method} no longer calls {member}: take it from the list of what is allowed");
            findings.Looked = $"{calls} calls in {methods} methods, {Forbidden.Length} forbidden members, {Allowed.Length} allowed with a reason";
            return findings;
        }

        // Methods of generic instances are in no list.
        static (string type, string member) NameOf(MetadataReader reader, EntityHandle called)
        {
            if (called.Kind == HandleKind.MethodSpecification)
                called = reader.GetMethodSpecification((MethodSpecificationHandle)called).Method;
            if (called.Kind == HandleKind.MethodDefinition)
            {
                MethodDefinition own = reader.GetMethodDefinition((MethodDefinitionHandle)called);
                return (reader.GetString(reader.GetTypeDefinition(own.GetDeclaringType()).Name), reader.GetString(own.Name));
            }
            if (called.Kind != HandleKind.MemberReference)
                return ("", "");
            MemberReference member = reader.GetMemberReference((MemberReferenceHandle)called);
            return member.Parent.Kind == HandleKind.TypeReference
                ? (reader.GetString(reader.GetTypeReference((TypeReferenceHandle)member.Parent).Name), reader.GetString(member.Name)) : ("", "");
        }
    }

    /// <summary>The assemblies that players contain.</summary>
    static class RuntimeAssemblies
    {
        /// <summary>One that was not built is a fault.</summary>
        public static IEnumerable<AssemblyDefinition> Of(PackageTree package, Findings findings)
        {
            foreach (AssemblyDefinition definition in AssemblyDefinition.All(package, findings)
                .Where(a => !a.IsTest && a.IncludePlatforms.Length == 0))
                if (definition.IsAdapter ? ImageOf(package, definition, findings) != null : File.Exists(PathOf(package, definition)))
                    yield return definition;
                else
                    findings.Fault($"{PathOf(package, definition)} is not there: build it first (Headless~/rill does)");
        }

        public static Stream Open(PackageTree package, AssemblyDefinition definition) =>
            definition.IsAdapter ? new MemoryStream(ImageOf(package, definition, new Findings())) : File.OpenRead(PathOf(package, definition));

        // Image in the version in which it has both paths.
        static byte[] ImageOf(PackageTree package, AssemblyDefinition definition, Findings findings)
        {
            byte[] image = PipelineAssemblies.Of(PipelineVersion.Find("17"))
                .CompileAdapter(AdapterDefinition.Read(package.FullPath(definition.File)), false, out List<string> errors);
            if (image == null)
                findings.Fault($"{definition.Name} is not compiled: {string.Join("; ", errors)}");
            return image;
        }

        static string PathOf(PackageTree package, AssemblyDefinition definition) => Path.Combine(package.Assemblies, definition.Name + ".dll");
    }
}
