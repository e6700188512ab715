using System;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>A quad over the whole target, drawn with a material whose _MainTex is the source.</summary>
    internal static class Blitter
    {
        const string CopyShader = "Hidden/BlitCopy";
        static readonly int mainTex = Shader.PropertyToID("_MainTex");
        static Mesh quad;
        static Material copy;

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
            (Matrix4x4 view, Matrix4x4 projection) = (RenderState.View, RenderState.Projection);
            RenderState.SetTarget(target);
            BuiltinVariables.SetViewProjection(Matrix4x4.identity, Matrix4x4.Ortho(0, 1, 0, 1, -1, 100));
            Drawing.Draw(new DrawCall { Call = "Blit", Mesh = Quad(), Matrix = Matrix4x4.identity, Material = material, Pass = pass, Block = block, Instances = 1 });
            BuiltinVariables.SetViewProjection(view, projection);
        }

        /// <summary>Of the source the part that begins at the offset and is as large as the scale, in its own units.</summary>
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
        public static void Forget()
        {
            if (quad is object)
                Object.DestroyImmediate(quad);
            if (copy is object)
                Object.DestroyImmediate(copy);
            quad = null;
            copy = null;
        }

        static bool SameShape(Texture source, RenderTexture target)
        {
            target ??= ScreenTarget.Texture;
            target.Create();
            DeviceTexture from = source.GetDevice(RenderTextureSubElement.Color), to = target.GetDevice(RenderTextureSubElement.Color);
            return from != null && from != to && source.width == target.width && source.height == target.height && from.Description.Format == to.Description.Format
                && from.Description.Mips == to.Description.Mips && from.Description.Slices == to.Description.Slices && from.Description.Dimension == to.Description.Dimension;
        }

        static Material Copy()
        {
            if (copy == null)
                copy = new Material(Shader.Find(CopyShader) ?? throw new NotSupportedException($"Blit between textures of unequal size or format needs the shader '{CopyShader}', which the project does not have."));
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
