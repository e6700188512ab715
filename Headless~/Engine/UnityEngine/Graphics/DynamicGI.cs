using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>The host's only global illumination is that of the sky.</summary>
    public sealed class DynamicGI
    {
        /// <summary>The sky's reflection and ambient light follow what its material and the sun have become; without a call they stay as
        /// they were when the scene began.</summary>
        public static void UpdateEnvironment() => EnvironmentLighting.Invalidate();
    }
}
