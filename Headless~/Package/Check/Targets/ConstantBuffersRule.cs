using System;
using System.Collections.Generic;
using System.Linq;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>
    /// A constant buffer that is uploaded as raw bytes means the same to every graphics API. Unity's translator for Metal
    /// declares a float3 as one, which has 16 bytes there, and Vulkan's std140 aligns it: what follows lies elsewhere than under
    /// Direct3D. SPIRV-Cross, which keeps Direct3D's offsets, shows nothing of it.
    /// </summary>
    /// <remarks>Structured buffers are safe: Unity's translator reads them word by word.</remarks>
    sealed class ConstantBuffersRule : Rule
    {
        const string UnitysOwn = "Unity";       // UnityPerDraw and the like: Unity sets their members by name
        const string Multiview = "OVR_multiview";       // by this name Unity's translator knows the eye's index, and leaves the buffer out

        static readonly ConstantPacking[] Others = { ConstantPacking.Std140, ConstantPacking.Metal };

        readonly string cacheFolder;

        public ConstantBuffersRule() : this(null) { }

        public ConstantBuffersRule(string cacheFolder) => this.cacheFolder = cacheFolder;

        public override string Name => "other targets: raw constant buffers lie the same under Direct3D, std140 and Metal";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            var buffers = new Dictionary<string, (ConstantLayout layout, ShaderVariant variant)>();
            IReadOnlyList<ShaderVariant> variants = PackageShaders.Variants(package, cacheFolder, findings, out _);
            foreach (ShaderVariant variant in variants)
                foreach (ShaderResource buffer in RawBuffers(variant))
                    buffers.TryAdd(Key(buffer), (buffer.Constants, variant));

            foreach ((string key, (ConstantLayout layout, ShaderVariant variant)) in buffers)
                foreach (string fault in Faults(layout))
                    findings.Fault($"{variant}: {key.Substring(0, key.IndexOf(' '))}{fault}");
            findings.Looked = $"{buffers.Values.Sum(b => b.layout.Fields.Length)} members of {buffers.Count} constant buffers in " +
                $"{variants.Count} programs";
            return findings;
        }

        // One that another file declares differently is another.
        static string Key(ShaderResource buffer)
            => $"{buffer.Name} {string.Join(" ", buffer.Constants.Fields.Select(f => $"{f.Name} {Type(f)} {f.Offset}"))}";

        static IEnumerable<ShaderResource> RawBuffers(ShaderVariant variant)
        {
            try
            {
                return variant.Compile().Program.Resources.Where(r => r.Constants is { IsGlobals: false }
                    && !r.Name.StartsWith(UnitysOwn, StringComparison.Ordinal) && r.Name != Multiview);
            }
            catch (ShaderCompileException)
            {
                return Enumerable.Empty<ShaderResource>();      // a fault of the rules that ask whether it compiles
            }
        }

        static IEnumerable<string> Faults(ConstantLayout layout)
        {
            int[] direct3D = ConstantPacking.Direct3D.Offsets(layout.Fields);
            for (int i = 0; i < layout.Fields.Length; i++)
            {
                ConstantField field = layout.Fields[i];
                if (direct3D[i] != field.Offset)
                {
                    yield return $".{field.Name} is at byte {field.Offset}, where its type and those before it would have it at " +
                        $"{direct3D[i]}: a struct or a packoffset, which other APIs lay out otherwise. Use 4-vectors, 4x4 matrices, " +
                        $"arrays of them and scalars.";
                    yield break;
                }
                if (!IsSafe(field))
                    yield return $".{field.Name} is a {Type(field)}, which Metal and std140 pad otherwise than Direct3D. Make it part " +
                        $"of a 4-vector, name it by #define, or use scalars.";
            }
            foreach (ConstantPacking other in Others)
            {
                int[] offsets = other.Offsets(layout.Fields);
                for (int i = 0; i < layout.Fields.Length; i++)
                    if (offsets[i] != direct3D[i])
                    {
                        yield return $".{layout.Fields[i].Name} is at byte {direct3D[i]} under Direct3D and at {offsets[i]} under " +
                            $"{other.Name}, and what follows with it. Let scalars fill runs of four.";
                        break;
                    }
            }
            int end = direct3D[layout.Fields.Length];
            if (end % 16 != 0)
                yield return $" ends at byte {end}: fill its last 16 bytes with scalars, so that its size is the same everywhere.";
        }

        static bool IsSafe(in ConstantField field)
        {
            bool isScalar = field.Rows == 1 && field.Columns == 1 && field.ArrayLength == 0, isFour = field.Columns == 4
                && (field.Rows == 1 || field.Rows == 4);
            return isScalar || isFour;
        }

        static string Type(in ConstantField field)
        {
            string size = field.Rows > 1 ? $"{field.Rows}x{field.Columns}" : field.Columns > 1 ? field.Columns.ToString() : "";
            return field.Type.ToString().ToLowerInvariant() + size + (field.ArrayLength > 0 ? $" [{field.ArrayLength}]" : "");
        }
    }
}
