using System;
using System.Linq;
using Host.Pipelines;

namespace Host.Commands
{
    /// <summary>A render pipeline as <c>--pipeline</c> names it.</summary>
    sealed class PipelineChoice
    {
        const string Compatibility = "-compatibility";

        public static readonly string[] Names = { "universal-14", "universal-17", "universal-17" + Compatibility, "high-definition-14",
            "high-definition-17" };

        public PipelineKind Kind { get; private init; }
        public PipelineVersion Version { get; private init; }
        /// <summary>Runs version 17 without the render graph.</summary>
        public bool ByExecute { get; private init; }

        /// <summary>Null for null.</summary>
        /// <param name="project">Of <c>--project</c>; null for a scene of the package.</param>
        /// <exception cref="HostException">There is none of that name, or it is for another project.</exception>
        public static PipelineChoice Of(string name, string project = null)
        {
            if (name == null)
                return null;
            if (project != null)
                throw new HostException("--pipeline plays scenes of this package; a project under --project is drawn by the Built-in pipeline.");
            if (!Names.Contains(name))
                throw new HostException($"--pipeline {name}: there are {string.Join(", ", Names)}.");
            bool byExecute = name.EndsWith(Compatibility, StringComparison.Ordinal);
            PipelineKind kind = PipelineKind.All.First(known => name.StartsWith(known.Name + "-", StringComparison.Ordinal));
            int start = kind.Name.Length + 1;
            string number = name.Substring(start, name.Length - start - (byExecute ? Compatibility.Length : 0));
            return new PipelineChoice { Kind = kind, Version = PipelineVersion.Find(number), ByExecute = byExecute };
        }
    }
}
