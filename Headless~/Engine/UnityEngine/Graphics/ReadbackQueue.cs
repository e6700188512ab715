using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>Read-backs in order of their requests.</summary>
    internal static class ReadbackQueue
    {
        /// <summary>A request of frame n arrives at the beginning of frame n + this, on every machine.</summary>
        const int FramesUntilDone = 2;

        static readonly List<ReadbackRequest> requests = new List<ReadbackRequest>();

        public static int Frame { get; private set; }

        /// <summary>For tests: which requests end with an error when they are due, by the words for their buffer or texture, as where the
        /// device was lost. Null for none.</summary>
        public static Func<string, bool> Fails { get; set; }

        /// <summary>For tests: whether the callback of a request that is waited for comes with the next frame. Unity does not say when it
        /// comes.</summary>
        public static bool CallsBackLate { get; set; }

        /// <summary>Whether a request for a buffer is pending.</summary>
        public static bool IsPending(BufferStorage buffer)
        {
            foreach (ReadbackRequest request in requests)
                if (ReferenceEquals(request.Buffer, buffer) && !request.IsDone && !request.HasError)
                    return true;
            return false;
        }

        public static void BeginFrame()
        {
            Frame++;
            List<Exception> failures = null;
            int kept = 0, count = requests.Count;       // callbacks may add requests; those are not due yet
            for (int i = 0; i < count; i++)
            {
                ReadbackRequest request = requests[i];
                if (request.CallbackIsDue && request.DoneFrame < Frame)
                {
                    try
                    {
                        request.CallBack();
                    }
                    catch (Exception e)
                    {
                        (failures ??= new List<Exception>()).Add(e);
                    }
                }
                if (request.IsDone && request.DoneFrame < Frame)
                {
                    if (request.Output == null)
                        request.Expire();
                    continue;
                }
                if (!request.IsDone && request.DueFrame <= Frame)
                {
                    try
                    {
                        request.Complete();
                    }
                    catch (Exception e)
                    {
                        (failures ??= new List<Exception>()).Add(e);
                    }
                }
                requests[kept++] = request;
            }
            requests.RemoveRange(kept, count - kept);
            // Every request arrives before any failure is told.
            if (failures != null)
                foreach (Exception e in failures)
                    Debug.LogException(e);
        }

        public static void WaitAll()
        {
            for (int i = 0; i < requests.Count; i++)
                requests[i].Complete();
            GpuChecks.InspectArguments(wait: true);
        }

        public static void Reset()
        {
            foreach (ReadbackRequest request in requests)
                request.Expire();
            requests.Clear();
            Fails = null;
            CallsBackLate = false;
        }

        /// <summary>Requests that are pending no longer call these back.</summary>
        public static void DropCallbacks(Predicate<Delegate> which)
        {
            foreach (ReadbackRequest request in requests)
                if (request.Callback != null && which(request.Callback))
                    request.Callback = null;
        }

        /// <param name="size">Bytes; -1 for all behind the offset.</param>
        public static AsyncGPUReadbackRequest Request(BufferStorage buffer, int offset, int size, ReadbackOutput output,
            Action<AsyncGPUReadbackRequest> callback)
        {
            using NativeWork.Scope native = NativeWork.Enter();
            if (buffer == null)
                throw new ArgumentNullException("src", "AsyncGPUReadback.Request: the buffer is null.");
            Gpu.RequireCompute("AsyncGPUReadback.Request");
            BufferChecks.Readable(buffer, "AsyncGPUReadback.Request");
            long bytes = size < 0 ? buffer.Bytes - offset : size;
            if (offset < 0 || bytes <= 0 || offset + bytes > buffer.Bytes)
                throw new ArgumentException(
                    $"AsyncGPUReadback.Request of {bytes:N0} bytes at byte {offset:N0} of {buffer}, which holds {buffer.Bytes:N0}.");
            if (output != null && output.Bytes < bytes)
                throw new ArgumentException($"AsyncGPUReadback.Request of {bytes:N0} bytes of {buffer} into an array of {output.Bytes:N0} bytes.");
            var request = new ReadbackRequest { LayerCount = 1, LayerBytes = checked((int)bytes), Width = (int)bytes, Height = 1, Depth = 1,
                Source = buffer.ToString(), Buffer = buffer };
            // The device copies whole words.
            long start = offset & ~3, end = Math.Min((buffer.Bytes + 3) & ~3, (offset + bytes + 3) & ~3);
            request.Copies.Add(Gpu.Device.BeginReadback(buffer.Device, start, end - start));
            if (start != offset || end - start != bytes)
                request.Convert = PartOf((int)(offset - start), (int)bytes);
            return Enqueue(request, output, callback);
        }

        // Apart, because what a lambda captures is allocated where its method begins, and a request's begins in a script's name.
        static Func<List<DeviceReadback>, byte[][]> PartOf(int start, int bytes) => copies => new[] { copies[0].Data.Slice(start, bytes).ToArray() };

        public static AsyncGPUReadbackRequest Request(Texture texture, int mip, ReadbackRegion region, TextureFormat? format,
            ReadbackOutput output, Action<AsyncGPUReadbackRequest> callback)
        {
            using NativeWork.Scope native = NativeWork.Enter();
            if (texture == null)
                throw new ArgumentNullException("src", "AsyncGPUReadback.Request: the texture is null.");
            Gpu.RequireCompute("AsyncGPUReadback.Request");
            if (mip < 0 || mip >= texture.mipmapCount)
                throw new ArgumentException(
                    $"AsyncGPUReadback.Request: texture '{texture.name}' has {texture.mipmapCount} mip levels; level {mip} does not exist.");
            ReadbackRegion whole = ReadbackRegion.Whole(texture, mip);
            if (region.X < 0 || region.Y < 0 || region.Z < 0 || region.Width < 1 || region.Height < 1 || region.Depth < 1 ||
                region.X + region.Width > whole.Width || region.Y + region.Height > whole.Height || region.Z + region.Depth > whole.Depth)
                throw new ArgumentException($"AsyncGPUReadback.Request: the region {region.X}, {region.Y}, {region.Z} of " +
                    $"{region.Width} x {region.Height} x {region.Depth} exceeds '{texture.name}', {whole.Width} x {whole.Height} x " +
                    $"{whole.Depth}.");
            DeviceTexture device = texture.GetDevice(RenderTextureSubElement.Default)
                ?? throw new GpuUsageException($"AsyncGPUReadback.Request: texture '{texture.name}' was not created or was released.");

            int fromBytes = Formats.TexelBytes(device.Description.Format);
            bool depthFormat = Formats.IsDepth(texture.graphicsFormat) || texture.graphicsFormat == Experimental.Rendering.GraphicsFormat.None;
            TextureFormat stored = depthFormat ? TextureFormat.RFloat : format.HasValue ? Formats.ToTextureFormat(texture.graphicsFormat) : default;
            bool convert = format.HasValue && stored != format.Value;
            int toBytes = convert ? Formats.TexelBytes(format.Value) : fromBytes;
            bool volume = device.Description.Dimension == DeviceTextureDimension.Tex3D;

            var request = new ReadbackRequest
            {
                LayerCount = region.Depth, LayerBytes = region.Width * region.Height * toBytes, Width = region.Width,
                    Height = region.Height, Depth = region.Depth,
                Source = $"{texture.GetType().Name} '{texture.name}'",
            };
            if (output != null && output.Bytes < (long)request.LayerBytes * request.LayerCount)
                throw new ArgumentException($"AsyncGPUReadback.Request of {(long)request.LayerBytes * request.LayerCount:N0} bytes of " +
                    $"{request.Source} into an array of {output.Bytes:N0} bytes.");

            for (int layer = volume ? 0 : region.Z; layer < (volume ? 1 : region.Z + region.Depth); layer++)
                request.Copies.Add(Gpu.Device.BeginReadback(device, mip, layer));
            request.Convert = copies =>
            {
                var layers = new byte[region.Depth][];
                for (int z = 0; z < region.Depth; z++)
                {
                    ReadOnlySpan<byte> slice = volume ? copies[0].Data.Slice((region.Z + z) * whole.Width * whole.Height * fromBytes)
                        : copies[z].Data;
                    layers[z] = new byte[request.LayerBytes];
                    for (int y = 0; y < region.Height; y++)
                    {
                        int from = (region.Y + y) * whole.Width + region.X, to = y * region.Width;
                        if (!convert)
                            slice.Slice(from * fromBytes, region.Width * fromBytes).CopyTo(layers[z].AsSpan(to * toBytes));
                        else
                            for (int x = 0; x < region.Width; x++)
                                TexelCodec.Encode(layers[z], to + x, format.Value, TexelCodec.Decode(slice, from + x, stored));
                    }
                }
                if (output == null || layers.Length == 1)
                    return layers;
                var all = new byte[request.LayerBytes * layers.Length];
                for (int z = 0; z < layers.Length; z++)
                    layers[z].CopyTo(all, z * request.LayerBytes);
                return new[] { all };
            };
            return Enqueue(request, output, callback);
        }

        static AsyncGPUReadbackRequest Enqueue(ReadbackRequest request, ReadbackOutput output, Action<AsyncGPUReadbackRequest> callback)
        {
            request.Output = output;
            request.Callback = callback;
            request.DueFrame = Frame + FramesUntilDone;
            requests.Add(request);
            return new AsyncGPUReadbackRequest(request);
        }
    }

    /// <summary>A read-back in a command buffer: requested again whenever that executes.</summary>
    internal sealed class RecordedReadback
    {
        readonly BufferStorage buffer;
        readonly Texture texture;
        readonly int offset, size, mip;
        readonly Action<AsyncGPUReadbackRequest> callback;
        public ReadbackOutput Output;

        public RecordedReadback(BufferStorage buffer, int offset, int size, Action<AsyncGPUReadbackRequest> callback)
        {
            this.buffer = buffer ?? throw new ArgumentNullException("src", "CommandBuffer.RequestAsyncReadback: the buffer is null.");
            this.callback = callback ?? throw new ArgumentNullException(nameof(callback),
                "CommandBuffer.RequestAsyncReadback: the callback is null.");
            (this.offset, this.size) = (offset, size);
        }

        public RecordedReadback(Texture texture, int mip, Action<AsyncGPUReadbackRequest> callback)
        {
            this.texture = texture ?? throw new ArgumentNullException("src", "CommandBuffer.RequestAsyncReadback: the texture is null.");
            this.callback = callback ?? throw new ArgumentNullException(nameof(callback),
                "CommandBuffer.RequestAsyncReadback: the callback is null.");
            this.mip = mip;
        }

        public void Execute()
        {
            if (buffer != null)
                ReadbackQueue.Request(buffer, offset, size, Output, callback);
            else
                ReadbackQueue.Request(texture, mip, ReadbackRegion.Whole(texture, mip), null, Output, callback);
        }
    }
}
