using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>A graphics API beside Direct3D 11: whether programs translate to its language, and what it gives them at least.</summary>
    sealed class Target
    {
        public string Name;
        /// <summary>Whether the documentation says that the package runs there: then every program has to.</summary>
        public bool Supported;
        /// <summary>Null when nothing here translates to its language: then its limits alone are judged.</summary>
        public Translation Translation;
        public ApiLimits Limits = new ApiLimits();

        public static readonly IReadOnlyList<Target> All = new[]
        {
            new Target { Name = "Metal", Supported = true, Translation = Translation.Metal, Limits = ApiLimits.Metal },
            // Desktop devices give at least what Direct3D 11 does; Vulkan's own minimum is that of OpenGL ES 3.1.
            // The tests run these programs on Vulkan as they are, so that a text in GLSL would prove nothing more; to read one back took half of
            // this rule's time.
            new Target { Name = "Vulkan", Supported = true,
                Limits = new ApiLimits { Threads = 1024, GroupsharedBytes = 32768 } },
            new Target { Name = "Mobile", Limits = ApiLimits.Mobile },
            new Target { Name = "WebGPU", Limits = ApiLimits.WebGpu },
            new Target { Name = "GLES 3.1", Translation = Translation.OpenGlEs31, Limits = ApiLimits.OpenGlEs31 },
        };
    }
}
