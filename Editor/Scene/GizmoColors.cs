using UnityEngine;

namespace Rill.Editor
{
    /// <summary>One color a kind, for gizmos and handles alike.</summary>
    static class GizmoColors
    {
        public static Color Domain => new Color(0.3f, 0.6f, 1f);
        public static Color Volume => new Color(0.2f, 0.4f, 1f, 0.7f);
        public static Color Emitter => new Color(0.2f, 0.8f, 1f);
        public static Color Drain => new Color(1f, 0.45f, 0.2f);
        public static Color ForceField => new Color(0.9f, 0.85f, 0.2f);
        /// <summary>Color of probes and detectors.</summary>
        public static Color Query => new Color(0.85f, 0.5f, 1f);
        public static Color Collider => new Color(0.3f, 0.9f, 0.4f);
    }
}
