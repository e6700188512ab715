using System.CommandLine;
using UnityEngine.Headless;

namespace Host.Bench
{
    /// <summary><c>--kernels</c>: whether each kernel is timed by itself.</summary>
    static class KernelsOption
    {
        public static Option<bool> Create() => new Option<bool>("--kernels")
        {
            Description = "Also time each kernel by itself, which slows the step.",
        };

        /// <summary>To be called before anything is timed.</summary>
        public static void Use(bool value) => Player.TimesKernels = value;
    }
}
