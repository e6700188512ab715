using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Makes the package's render textures: named, hidden, and only of formats that the device has.</summary>
    /// <remarks>
    /// None of 32 bits a channel is read through a filter, which is optional on Metal, WebGPU and many Androids: shaders load four texels
    /// or eight, see Filtering.hlsl. Formats of 16 bits are filtered everywhere.
    /// </remarks>
    static class GpuTexture
    {
        /// <summary>Asks the device for a format before something that needs it begins.</summary>
        /// <param name="format">Depth: as a texture of depth alone.</param>
        /// <param name="isWritten">By kernels; otherwise it is drawn into.</param>
        /// <returns>Why the device lacks such textures, as the start of a sentence; null if it has them.</returns>
        public static string WhyNot(RenderTextureFormat format, bool isWritten)
        {
            bool has = isWritten ? SystemInfo.SupportsRandomWriteOnRenderTextureFormat(format) : SystemInfo.SupportsRenderTextureFormat(format);
            string use = isWritten ? "kernels write" : "can be drawn into", asked = isWritten ? "RandomWriteOn" : "";
            return has ? null : Invariant($"this device ({SystemInfo.graphicsDeviceName}, {SystemInfo.graphicsDeviceType}) has no textures of the ")
                + Invariant($"format {format} that {use} (SystemInfo.Supports{asked}RenderTextureFormat)");
        }

        /// <exception cref="InvalidOperationException">The device has no such textures; the message says which. Ask before:
        /// <see cref="WhyNot"/>.</exception>
        public static RenderTexture Create(string name, in RenderTextureDescriptor description, FilterMode filter = FilterMode.Point)
        {
            RenderTextureFormat format = description.graphicsFormat == GraphicsFormat.None ? RenderTextureFormat.Depth : description.colorFormat;
            if (WhyNot(format, description.enableRandomWrite) is string why)
                throw new InvalidOperationException($"{name}: {why}.");
            var texture = new RenderTexture(description)
            {
                name = name, hideFlags = HideFlags.HideAndDontSave, filterMode = filter, wrapMode = TextureWrapMode.Clamp,
            };
            texture.Create();
            return texture;
        }

        /// <summary>Creates a texture with a layer for each eye.</summary>
        /// <param name="format">None: of depth alone.</param>
        /// <param name="isWritten">By kernels; otherwise it is drawn into.</param>
        /// <exception cref="InvalidOperationException">The device has no such textures; the message says which.</exception>
        public static RenderTexture CreateLayers(string name, int width, int height, int eyes, GraphicsFormat format, bool isWritten)
        {
            return Create(name, new RenderTextureDescriptor(width, height, format, format == GraphicsFormat.None
                ? GraphicsFormat.D32_SFloat : GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex2DArray, volumeDepth = eyes, enableRandomWrite = isWritten,
            });
        }
    }
}
