using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Pipelines;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Code that compiles against the stand-ins of a render pipeline compiles against its packages: each public member is in the lists
    /// of that version.</summary>
    sealed class PipelineSurfaceRule : Rule
    {
        readonly Func<PipelineVersion, IEnumerable<byte[]>> images;

        /// <param name="images">Of the stand-ins of a version; null: those of the host.</param>
        public PipelineSurfaceRule(Func<PipelineVersion, IEnumerable<byte[]>> images = null)
            => this.images = images ?? (version => PipelineAssemblies.Of(version).Images.Values);

        public override string Name => "API: the pipelines' stand-ins offer nothing that the pipelines lack";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int types = 0, members = 0;
            foreach (PipelineVersion version in PipelineVersion.All)
            {
                ApiCatalog unity = UnityCatalogs.All.First(catalog => catalog.Version == version.ListedAs);
                foreach (byte[] image in images(version))
                    using (var assembly = new CompiledAssembly(new MemoryStream(image)))
                        HostSurfaceRule.Examine(assembly, unity, ref types, ref members, findings);
            }
            findings.Looked = $"{types} types and {members} members in the stand-ins of " +
                $"{string.Join(", ", PipelineVersion.All.Select(version => version.Name))}";
            return findings;
        }
    }
}
