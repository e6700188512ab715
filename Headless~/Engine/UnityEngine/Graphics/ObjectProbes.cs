using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>
    /// The two reflection probes of a draw: of those whose box its bounds meet, the most important, then the smallest ones. Names and contents
    /// are those of UnityShaderVariables.cginc and of URP's UnityInput.hlsl, which differ in what the w of a box is.
    /// </summary>
    internal static class ObjectProbes
    {
        sealed class Slot
        {
            public readonly int Cube, Decode, Low, High, Position;

            public Slot(int index)
            {
                string name = "unity_SpecCube" + index;
                (Cube, Decode, Low) = (Shader.PropertyToID(name), Shader.PropertyToID(name + "_HDR"), Shader.PropertyToID(name + "_BoxMin"));
                (High, Position) = (Shader.PropertyToID(name + "_BoxMax"), Shader.PropertyToID(name + "_ProbePosition"));
            }
        }

        static readonly Slot first = new Slot(0), second = new Slot(1);
        static bool bound;

        /// <summary>After EnvironmentLighting.Bind, which gives the sky's.</summary>
        public static void Bind(in QueuedDraw draw, bool universal)
        {
            ReflectionProbe one = null, other = null;
            if (draw.Reflections != ReflectionProbeUsage.Off && draw.HasBounds)
                foreach (ReflectionProbe probe in ReflectionProbe.Active)
                {
                    if (probe.texture == null || !probe.bounds.Intersects(draw.Bounds))
                        continue;
                    if (one == null || Leads(probe, one))
                        (one, other) = (probe, one);
                    else if (other == null || Leads(probe, other))
                        other = probe;
                }
            if (one == null && !bound)
            {
                Shader.Globals.SetVector(first.Low, new Vector4(0, 0, 0, 1));
                return;
            }
            EnvironmentLighting.Bind();
            bound = one != null;
            // In the Built-in pipeline the second is the sky, and what counts of the first how far the draw's center is inside.
            float weight = one == null ? 1 : Weight(one, draw.Bounds.center);
            Set(first, one, universal && other != null ? one.importance - other.importance : 0);
            Set(second, other, universal && other != null ? one.importance - other.importance : 0);
            if (!universal)
                SetBlend(one, weight);
            if (other == null)
            {
                Shader.Globals.SetTexture(second.Cube, EnvironmentLighting.DefaultCube);
                Shader.Globals.SetVector(second.Decode, EnvironmentLighting.DefaultDecode);
            }
        }

        public static void Unbind() => Shader.Globals.SetTexture(second.Cube, null);

        static void SetBlend(ReflectionProbe one, float weight)
        {
            Vector3 low = one == null ? Vector3.zero : one.bounds.min;
            Shader.Globals.SetVector(first.Low, new Vector4(low.x, low.y, low.z, weight));
        }

        static void Set(Slot slot, ReflectionProbe probe, float w)
        {
            Bounds box = probe == null ? default : probe.bounds;
            Vector3 at = probe == null ? Vector3.zero : probe.transform.position;
            if (probe != null)
            {
                Shader.Globals.SetTexture(slot.Cube, probe.texture);
                Shader.Globals.SetVector(slot.Decode, probe.textureHDRDecodeValues);
            }
            Shader.Globals.SetVector(slot.Low, new Vector4(box.min.x, box.min.y, box.min.z, w));
            Shader.Globals.SetVector(slot.High, new Vector4(box.max.x, box.max.y, box.max.z, probe == null ? 0 : probe.blendDistance));
            Shader.Globals.SetVector(slot.Position, new Vector4(at.x, at.y, at.z, probe != null && probe.boxProjection ? 1 : -1));
        }

        static bool Leads(ReflectionProbe a, ReflectionProbe b) => a.importance != b.importance ? a.importance > b.importance
            : a.size.sqrMagnitude < b.size.sqrMagnitude;

        static float Weight(ReflectionProbe probe, Vector3 at)
        {
            Vector3 inside = Vector3.Min(at - probe.bounds.min, probe.bounds.max - at) / Mathf.Max(probe.blendDistance, 1e-4f);
            return Mathf.Clamp01(Mathf.Min(inside.x, Mathf.Min(inside.y, inside.z)));
        }
    }
}
