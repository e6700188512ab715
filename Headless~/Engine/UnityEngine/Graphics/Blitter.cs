using System;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>A quad over the whole target, drawn with a material whose _MainTex is the source.</summary>
    internal static class Blitter
    {
        const string CopyShader = "Hidden/BlitCopy", ArrayCopyShader = "Hidden/Headless/BlitCopyArray";
        static readonly int mainTex = Shader.PropertyToID("_MainTex"), slice = Shader.PropertyToID("_Slice"), partId = Shader.PropertyToID("_Part");
        static Mesh quad;
        static Material copy, arrayCopy;

        public static void Blit(Texture source, RenderTexture target, Material material, int pass)
        {
            if (material == null)
            {
                if (source != null && SameShape(source, target))
                {
                    GraphicsCopies.Texture(source, target ?? ScreenTarget.Texture);
                    RenderState.SetTarget(target);
                    return;
                }
                material = Copy();
                pass = 0;
            }

            var block = new PropertyTable();
            if (source != null)
                block.SetTexture(mainTex, source);
            Draw(target, 0, material, pass, block);
        }

        /// <summary>One slice of an array, or a texture, into one slice of an array, or into a texture.</summary>
        /// <param name="part">Of an array: how much of its width and height is taken, from its first texel; null: all.</param>
        /// <param name="viewport">Of the target; null: all.</param>
        public static void BlitSlice(Texture source, RenderTexture target, int sourceSlice, int targetSlice, Vector2? part = null,
            Rect? viewport = null)
        {
            if (source == null)
                throw new ArgumentNullException(nameof(source), "Blit: the source is null.");
            bool isArray = source.dimension == TextureDimension.Tex2DArray;
            int slices = source is RenderTexture texture && isArray ? texture.volumeDepth : source is Texture2DArray array ? array.depth
                : 1, targets = target is object && target.dimension == TextureDimension.Tex2DArray ? target.volumeDepth : 1;
            if (sourceSlice < 0 || sourceSlice >= slices || targetSlice < 0 || targetSlice >= targets)
                throw new GpuUsageException($"Blit: slice {sourceSlice} of '{source.name}', which has {slices}, into slice " +
                    $"{targetSlice} of '{(target is object ? target.name : "the screen")}', which has {targets}.");
            Material material = isArray ? arrayCopy = arrayCopy != null ? arrayCopy
                : new Material(BuiltinResources.FindShader(ArrayCopyShader)) { hideFlags = HideFlags.HideAndDontSave } : Copy();
            var block = new PropertyTable();
            block.SetTexture(mainTex, source);
            block.SetFloat(slice, sourceSlice);
            block.SetVector(partId, part ?? Vector2.one);
            Draw(target, targetSlice, material, 0, block, viewport);
        }

        static void Draw(RenderTexture target, int targetSlice, Material material, int pass, PropertyTable block, Rect? viewport = null)
        {
            (Matrix4x4 view, Matrix4x4 projection) = (RenderState.View, RenderState.Projection);
            RenderState.SetTarget(target, 0, targetSlice);
            if (viewport.HasValue)
                RenderState.SetViewport(viewport.Value);
            BuiltinVariables.SetViewProjection(Matrix4x4.identity, Matrix4x4.Ortho(0, 1, 0, 1, -1, 100));
            Drawing.Draw(new DrawCall { Call = "Blit", Mesh = Quad(), Matrix = Matrix4x4.identity, Material = material, Pass = pass,
                Block = block, Instances = 1 });
            BuiltinVariables.SetViewProjection(view, projection);
        }

        /// <summary>Copies the part of the source that begins at the offset and is as large as the scale, in its own units.</summary>
        public static void Blit(Texture source, RenderTexture target, Vector2 scale, Vector2 offset)
        {
            Material material = Copy();
            material.SetTextureScale(mainTex, scale);
            material.SetTextureOffset(mainTex, offset);
            Blit(source, target, material, 0);
            material.SetTextureScale(mainTex, Vector2.one);
            material.SetTextureOffset(mainTex, Vector2.zero);
        }

        /// <summary>The device goes: what was made on it goes first.</summary>
        public static void Reset()
        {
            if (quad is object)
                Object.DestroyImmediate(quad);
            if (copy is object)
                Object.DestroyImmediate(copy);
            if (arrayCopy is object)
                Object.DestroyImmediate(arrayCopy);
            quad = null;
            copy = arrayCopy = null;
        }

        static bool SameShape(Texture source, RenderTexture target)
        {
            target ??= ScreenTarget.Texture;
            target.Create();
            DeviceTexture from = source.GetDevice(RenderTextureSubElement.Color), to = target.GetDevice(RenderTextureSubElement.Color);
            return from != null && from != to && !target.IsUpright && source.width == target.width && source.height == target.height
                && from.Description.Format == to.Description.Format
                && from.Description.Mips == to.Description.Mips && from.Description.Slices == to.Description.Slices
                && from.Description.Dimension == to.Description.Dimension;
        }

        static Material Copy()
        {
            if (copy == null)
                copy = new Material(Shader.Find(CopyShader)
                    ?? throw new NotSupportedException(
                    $"Blit between textures of unequal size or format needs the shader '{CopyShader}', which the project does not have."));
            return copy;
        }

        static Mesh Quad()
        {
            if (quad == null)
                quad = new Mesh
                {
                    name = "Blit quad", IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave,
                    vertices = new[] { new Vector3(0, 0, 0), new Vector3(0, 1, 0), new Vector3(1, 1, 0), new Vector3(1, 0, 0) },
                    uv = new[] { new Vector2(0, 0), new Vector2(0, 1), new Vector2(1, 1), new Vector2(1, 0) },
                    triangles = new[] { 0, 1, 2, 0, 2, 3 },
                };
            return quad;
        }
    }
}
