using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Render textures that a command buffer got by name, until it releases them.</summary>
    internal static class TemporaryTargets
    {
        static readonly Dictionary<int, RenderTexture> byName = new Dictionary<int, RenderTexture>();

        public static bool TryGet(int nameId, out RenderTexture texture) => byName.TryGetValue(nameId, out texture);

        public static void Get(int nameId, RenderTextureDescriptor description, FilterMode filter)
        {
            if (description.width < 0)
                description.width = Math.Max(1, RenderState.CameraTarget.width / -description.width);
            if (description.height < 0)
                description.height = Math.Max(1, RenderState.CameraTarget.height / -description.height);
            Release(nameId);
            RenderTexture texture = RenderTexture.GetTemporary(description);
            texture.filterMode = filter;
            byName[nameId] = texture;
            Shader.Globals.SetTexture(nameId, texture);
        }

        public static void Release(int nameId)
        {
            if (byName.TryGetValue(nameId, out RenderTexture texture))
                RenderTexture.ReleaseTemporary(texture);
            byName.Remove(nameId);
        }
    }
}
