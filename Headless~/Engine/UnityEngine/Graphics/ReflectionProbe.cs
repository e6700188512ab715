using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Shows what it was given, baked or custom: nothing is drawn into it.</summary>
    public sealed class ReflectionProbe : Behaviour
    {
        static readonly List<ReflectionProbe> active = new List<ReflectionProbe>();

        internal override void OnActivated() => active.Add(this);
        internal override void OnDeactivated() => active.Remove(this);

        internal static IReadOnlyList<ReflectionProbe> Active => active;

        /// <summary>Cube map that is mirrored beside all probes: the sky's, or the scene's own.</summary>
        public static Texture defaultTexture => EnvironmentLighting.DefaultCube;
        public static Vector4 defaultTextureHDRDecodeValues => EnvironmentLighting.DefaultDecode;

        public ReflectionProbeMode mode { get; set; }
        public Texture bakedTexture { get; set; }
        public Texture customBakedTexture { get; set; }
        public Texture texture => mode == ReflectionProbeMode.Custom ? customBakedTexture : bakedTexture;
        public Vector3 size { get; set; } = new Vector3(10, 10, 10);
        public Vector3 center { get; set; }
        public bool boxProjection { get; set; }
        public int importance { get; set; } = 1;
        public float intensity { get; set; } = 1;
        public float blendDistance { get; set; } = 1;
        public Bounds bounds => new Bounds(transform.position + center, size);
        public Vector4 textureHDRDecodeValues => new Vector4(intensity, 1, 0, 0);
    }
}
