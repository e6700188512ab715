using System;
using System.Linq;
using Host.Pipelines;

namespace Host.Commands
{
    /// <summary>A render pipeline as <c>--pipeline</c> names it.</summary>
    sealed class PipelineChoice
    {
        const string Universal = "universal-", Compatibility = "-compatibility";

        public static readonly string[] Names = { "universal-14", "universal-17", "universal-17" + Compatibility };

        public PipelineVersion Version { get; private init; }
        /// <summary>Of 17: without the render graph.</summary>
        public bool ByExecute { get; private init; }

        /// <summary>Null for null.</summary>
        /// <exception cref="HostException">There is none of that name.</exception>
        public static PipelineChoice Of(string name)
        {
            if (name == null)
                return null;
            if (!Names.Contains(name))
                throw new HostException($"--pipeline {name}: there are {string.Join(", ", Names)}.");
            bool byExecute = name.EndsWith(Compatibility, StringComparison.Ordinal);
            string number = name.Substring(Universal.Length, name.Length - Universal.Length - (byExecute ? Compatibility.Length : 0));
            return new PipelineChoice { Version = PipelineVersion.Find(number), ByExecute = byExecute };
        }
    }
}
