using System;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    internal static class GraphicsCopies
    {
        public static void Buffer(BufferStorage source, BufferStorage target)
        {
            BufferChecks.Copy(source, target);
            Gpu.Device.Copy(source.Device, 0, target.Device, 0, source.Bytes);
            target.MarkWritten();
        }

        public static void Texture(Texture source, Texture target)
        {
            if (source == null)
                throw new ArgumentNullException("src", "CopyTexture: the source is null.");
            if (target == null)
                throw new ArgumentNullException("dst", "CopyTexture: the destination is null.");
            (target as RenderTexture)?.Create();
            DeviceTexture from = source.GetDevice(RenderTextureSubElement.Default), to = target.GetDevice(RenderTextureSubElement.Default);
            if (from == null)
                throw new GpuUsageException($"CopyTexture: the source '{source.name}' was not created.");
            if (source.width != target.width || source.height != target.height || from.Description.Format != to.Description.Format
                || from.Description.Depth != to.Description.Depth || from.Description.Slices != to.Description.Slices)
            {
                GpuError.Report($"CopyTexture: '{source.name}' ({source.width} x {source.height} {from.Description.Format}) and " +
                    $"'{target.name}' ({target.width} x {target.height} {to.Description.Format}) must have equal size and format.",
                    "Graphics.CopyTexture called with mismatching texture sizes or formats.");
                return;
            }
            Gpu.Device.CopyTexture(from, to);
        }
    }
}
