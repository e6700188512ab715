using System;
using UnityEngine.Headless;

namespace UnityEngine.Rendering
{
    public struct RenderTargetIdentifier : IEquatable<RenderTargetIdentifier>
    {
        public const int AllDepthSlices = -1;

        internal BuiltinRenderTextureType Type;
        internal int NameId, Mip, DepthSlice;
        internal CubemapFace Face;
        internal Texture Texture;
        internal RenderTextureSubElement Element;

        public RenderTargetIdentifier(BuiltinRenderTextureType type) : this(type, 0) { }
        public RenderTargetIdentifier(BuiltinRenderTextureType type, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        {
            this = default;
            Type = type;
            (Mip, Face, DepthSlice) = (mipLevel, cubeFace, depthSlice);
            Element = RenderTextureSubElement.Default;
        }

        public RenderTargetIdentifier(string name) : this(Shader.PropertyToID(name), 0) { }
        public RenderTargetIdentifier(string name, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(Shader.PropertyToID(name), mipLevel, cubeFace, depthSlice) { }
        public RenderTargetIdentifier(int nameID) : this(nameID, 0) { }
        public RenderTargetIdentifier(int nameID, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(BuiltinRenderTextureType.PropertyName, mipLevel, cubeFace, depthSlice) => NameId = nameID;
        public RenderTargetIdentifier(Texture tex) : this(tex, 0) { }

        public RenderTargetIdentifier(Texture tex, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(ReferenceEquals(tex, null) ? BuiltinRenderTextureType.None : tex is RenderTexture
                ? BuiltinRenderTextureType.RenderTexture : BuiltinRenderTextureType.BindableTexture, mipLevel, cubeFace,
                depthSlice) => Texture = tex;

        public RenderTargetIdentifier(RenderBuffer buf, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(BuiltinRenderTextureType.BufferPtr, mipLevel, cubeFace, depthSlice)
        {
            Texture = buf.Texture;
            Element = buf.Element;
        }

        public RenderTargetIdentifier(RenderTargetIdentifier renderTargetIdentifier, int mipLevel,
            CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
        {
            this = renderTargetIdentifier;
            (Mip, Face, DepthSlice) = (mipLevel, cubeFace, depthSlice);
        }

        public static implicit operator RenderTargetIdentifier(BuiltinRenderTextureType type) => new RenderTargetIdentifier(type);
        public static implicit operator RenderTargetIdentifier(string name) => new RenderTargetIdentifier(name);
        public static implicit operator RenderTargetIdentifier(int nameID) => new RenderTargetIdentifier(nameID);
        public static implicit operator RenderTargetIdentifier(Texture tex) => new RenderTargetIdentifier(tex);
        public static implicit operator RenderTargetIdentifier(RenderBuffer buf) => new RenderTargetIdentifier(buf);

        /// <summary>The texture meant, at the time of execution; null for none.</summary>
        internal Texture Resolve()
        {
            switch (Type)
            {
                case BuiltinRenderTextureType.PropertyName:
                    return TemporaryTargets.TryGet(NameId, out RenderTexture temporary) ? temporary : Shader.Globals.GetTexture(NameId);
                case BuiltinRenderTextureType.CameraTarget: return RenderState.CameraTarget;
                case BuiltinRenderTextureType.CurrentActive: return RenderState.CurrentTexture;
                case BuiltinRenderTextureType.RenderTexture:
                case BuiltinRenderTextureType.BindableTexture:
                case BuiltinRenderTextureType.BufferPtr: return Texture;
                case BuiltinRenderTextureType.None: return null;
                default: throw new NotSupportedException($"BuiltinRenderTextureType.{Type} is not supported by the headless host.");
            }
        }

        public bool Equals(RenderTargetIdentifier rhs) =>
            Type == rhs.Type && NameId == rhs.NameId && ReferenceEquals(Texture, rhs.Texture) && Element == rhs.Element && Mip == rhs.Mip
            && Face == rhs.Face && DepthSlice == rhs.DepthSlice;
        public override bool Equals(object obj) => obj is RenderTargetIdentifier other && Equals(other);
        public override int GetHashCode() => HashCode.Combine(Type, NameId, ReferenceEquals(Texture, null) ? 0 : Texture.GetInstanceID(),
            Mip, Face, DepthSlice);
        public override string ToString()
            => $"Type {Type} NameID {NameId} InstanceID {(ReferenceEquals(Texture, null) ? 0 : Texture.GetInstanceID())}";
        public static bool operator ==(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => lhs.Equals(rhs);
        public static bool operator !=(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => !lhs.Equals(rhs);
    }

    public struct RenderTargetBinding
    {
        public RenderTargetBinding(RenderTargetIdentifier[] colorRenderTargets, RenderBufferLoadAction[] colorLoadActions,
            RenderBufferStoreAction[] colorStoreActions,
            RenderTargetIdentifier depthRenderTarget, RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction)
        {
            this.colorRenderTargets = colorRenderTargets;
            this.depthRenderTarget = depthRenderTarget;
            this.colorLoadActions = colorLoadActions;
            this.colorStoreActions = colorStoreActions;
            this.depthLoadAction = depthLoadAction;
            this.depthStoreAction = depthStoreAction;
        }

        public RenderTargetBinding(RenderTargetIdentifier colorRenderTarget, RenderBufferLoadAction colorLoadAction,
            RenderBufferStoreAction colorStoreAction,
            RenderTargetIdentifier depthRenderTarget, RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction)
            : this(new[] { colorRenderTarget }, new[] { colorLoadAction }, new[] { colorStoreAction }, depthRenderTarget, depthLoadAction,
                depthStoreAction) { }

        public RenderTargetIdentifier[] colorRenderTargets { get; set; }
        public RenderTargetIdentifier depthRenderTarget { get; set; }
        public RenderBufferLoadAction[] colorLoadActions { get; set; }
        public RenderBufferStoreAction[] colorStoreActions { get; set; }
        public RenderBufferLoadAction depthLoadAction { get; set; }
        public RenderBufferStoreAction depthStoreAction { get; set; }
    }
}
