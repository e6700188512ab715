using System.Collections.Generic;

namespace Host.Shaders
{
    /// <summary>A program whose bytecode vkd3d (1.2) refuses. One that it does translate, or refuses for another reason, is a fault.</summary>
    sealed class Untranslatable
    {
        /// <summary>File as messages name it: "Shaders/Gpu/PrefixSum.compute", or the include that names the entry point.</summary>
        public readonly string File;
        public readonly string EntryPoint;
        /// <summary>In vkd3d's words.</summary>
        public readonly string Reason;

        public Untranslatable(string file, string entryPoint, string reason)
        {
            File = file;
            EntryPoint = entryPoint;
            Reason = reason;
        }

        /// <summary>Those of the package and of the host's tests.</summary>
        public static readonly IReadOnlyList<Untranslatable> All = new Untranslatable[]
        {
        };
    }
}
