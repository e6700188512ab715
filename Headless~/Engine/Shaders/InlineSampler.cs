using System;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>
    /// Settings that Unity reads from a sampler's name (manual, "Using sampler states"): samplerX and sampler_X take texture X's own
    /// settings; a name with a filter and a wrap mode in it is an inline sampler.
    /// </summary>
    static class InlineSampler
    {
        public static ShaderResource Describe(string name, SourceDeclarations declarations)
        {
            var resource = new ShaderResource { Name = name, Kind = ShaderResourceKind.Sampler, InlineSampler = Parse(name) };
            if (resource.InlineSampler != null)
                return resource;
            if (name.StartsWith("sampler") && declarations.Mentions(name.Substring("sampler".Length)))
            {
                resource.SamplerOf = name.Substring("sampler".Length);
                return resource;
            }
            throw new ProgramException($"unrecognized sampler '{name}' - does not match any texture and is not a recognized inline " +
                $"name (should contain filter and wrap modes)");
        }

        /// <summary>Null when the name has no filter or no wrap mode in it.</summary>
        public static DeviceSampler? Parse(string name)
        {
            string lower = name.ToLowerInvariant();
            bool trilinear = lower.Contains("trilinear"), linear = lower.Contains("linear"), point = lower.Contains("point");
            if (!linear && !point)
                return null;

            DeviceWrap? all = null, u = null, v = null, w = null;
            foreach ((string word, DeviceWrap wrap) in new[]
            {
                ("mirroronce", DeviceWrap.MirrorOnce), ("mirror", DeviceWrap.Mirror), ("repeat", DeviceWrap.Repeat), ("clamp", DeviceWrap.Clamp),
            })
                for (int at = lower.IndexOf(word, StringComparison.Ordinal); at >= 0;
                    at = lower.IndexOf(word, at + word.Length, StringComparison.Ordinal))
                {
                    if (word == "mirror" && string.CompareOrdinal(lower, at, "mirroronce", 0, 10) == 0)
                        continue;
                    // ClampU, RepeatVW ... ; any other letter belongs to the next word.
                    int axis = at + word.Length;
                    bool perAxis = false;
                    while (axis < lower.Length && "uvw".IndexOf(lower[axis]) >= 0)
                    {
                        perAxis = true;
                        switch (lower[axis++])
                        {
                            case 'u': u = wrap; break;
                            case 'v': v = wrap; break;
                            default: w = wrap; break;
                        }
                    }
                    if (!perAxis)
                        all ??= wrap;
                }
            if (all == null && u == null && v == null && w == null)
                return null;

            int aniso = lower.IndexOf("aniso", StringComparison.Ordinal), level = 0;
            for (int i = aniso + 5; aniso >= 0 && i < lower.Length && char.IsDigit(lower[i]); i++)
                level = level * 10 + lower[i] - '0';
            DeviceWrap rest = all ?? DeviceWrap.Repeat;
            return new DeviceSampler
            {
                Linear = linear,
                LinearMip = trilinear,
                Comparison = lower.Contains("compare"),
                U = u ?? rest,
                V = v ?? rest,
                W = w ?? rest,
                Anisotropy = level,
            };
        }
    }
}
