using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering
{
    /// <summary>A texture of a pipeline's, which may use less than the whole of it.</summary>
    /// <remarks>Read in SRP Core 17.1.0, not in 14, Runtime/Textures/RTHandle.cs: a handle converts to its texture and to an identifier of
    /// all its slices' first.</remarks>
    public class RTHandle
    {
        internal RenderTexture texture;
        internal RenderTargetIdentifier identifier;

        internal RTHandle(RenderTexture texture)
        {
            this.texture = texture;
            identifier = new RenderTargetIdentifier(texture);
        }

        public RenderTexture rt => texture;
        public RenderTargetIdentifier nameID => identifier;
        public string name => texture.name;
        public Vector2 scaleFactor => Vector2.one;
        public bool useScaling => false;

        public static implicit operator RenderTargetIdentifier(RTHandle handle) => handle != null ? handle.nameID : default;
        public static implicit operator Texture(RTHandle handle) => handle?.rt;
        public static implicit operator RenderTexture(RTHandle handle) => handle?.rt;

        public void Release()
        {
            if (texture != null)
                Object.DestroyImmediate(texture, true);
            texture = null;
        }

        /// <summary>Makes the texture where it is missing or of another shape.</summary>
        internal static RTHandle Need(ref RTHandle handle, string name, RenderTextureDescriptor shape, FilterMode filter)
        {
            RenderTexture now = handle?.texture;
            if (now != null && now.width == shape.width && now.height == shape.height && now.volumeDepth == shape.volumeDepth
                && now.graphicsFormat == shape.graphicsFormat)
                return handle;
            handle?.Release();
            var made = new RenderTexture(shape) { name = name, filterMode = filter, wrapMode = TextureWrapMode.Clamp,
                hideFlags = HideFlags.HideAndDontSave };
            made.Create();
            return handle = new RTHandle(made);
        }
    }
}
