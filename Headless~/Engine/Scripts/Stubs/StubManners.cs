using System;
using System.Collections.Generic;

namespace Host.Scripts.Stubs
{
    internal enum Manner
    {
        /// <summary>Every member throws its own name: scripts compute with what it would answer.</summary>
        Throws,
        /// <summary>Properties hold what is put into them, methods do nothing and are counted: output for eyes and ears that no one has
        /// here.</summary>
        Quiet,
        /// <summary>Properties hold what is put into them, methods throw: data that others act on.</summary>
        Holds,
    }

    /// <summary>Which stubs throw and which keep still. Whatever is not named here throws.</summary>
    internal static class StubManners
    {
        static readonly HashSet<string> Quiet = new HashSet<string>
        {
            // Sound
            "AudioSource", "AudioClip", "AudioReverbZone", "AudioReverbFilter", "AudioLowPassFilter", "AudioHighPassFilter", "AudioEchoFilter",
            "AudioDistortionFilter", "AudioChorusFilter", "Audio.AudioMixer", "Audio.AudioMixerGroup", "Audio.AudioMixerSnapshot",
            // Renderers of parts of Unity that the host does not have
            "ParticleSystem", "ParticleSystemRenderer", "ParticleSystemForceField", "TrailRenderer", "LineRenderer", "BillboardRenderer",
                "SpriteRenderer",
            "SpriteMask", "TextMesh", "Font", "LensFlare", "FlareLayer", "Flare", "Projector", "Halo", "Skybox", "ReflectionProbe", "LightProbeGroup",
            "LightProbeProxyVolume", "LODGroup", "OcclusionArea", "OcclusionPortal", "WindZone", "Video.VideoPlayer", "Video.VideoClip",
                "Rendering.SortingGroup",
            // The screen's surface, and the keyboard and mouse that no one touches
            "Input", "Canvas", "CanvasGroup", "CanvasRenderer", "RectTransform", "RectOffset", "Cursor", "Handheld", "DrivenRectTransformTracker",
        };

        static readonly HashSet<string> Holds = new HashSet<string>
        {
            "TerrainCollider", "Collider2D", "BoxCollider2D", "CircleCollider2D",
        };

        /// <param name="type">The outermost type's full name, without type parameters.</param>
        public static Manner Of(string type)
        {
            if (!type.StartsWith("UnityEngine.", StringComparison.Ordinal)) return Manner.Throws;
            var name = type.Substring("UnityEngine.".Length);
            return Quiet.Contains(name) ? Manner.Quiet : Holds.Contains(name) ? Manner.Holds : Manner.Throws;
        }
    }
}
