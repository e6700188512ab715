using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;

namespace UnityEngine.Rendering
{
    public struct AsyncGPUReadbackRequest
    {
        internal readonly ReadbackRequest Request;
        internal AsyncGPUReadbackRequest(ReadbackRequest request) => Request = request;

        public bool done => Request == null || Request.IsDone;
        public bool hasError => Request == null || Request.HasError;
        public int layerCount => Request?.LayerCount ?? 0;
        public int layerDataSize => Request?.LayerBytes ?? 0;
        public int width => Request?.Width ?? 0;
        public int height => Request?.Height ?? 0;
        public int depth => Request?.Depth ?? 0;
        public bool forcePlayerLoopUpdate { get => Request != null && Request.ForceUpdate; set { if (Request != null) Request.ForceUpdate = value; } }

        /// <summary>Takes what the device has finished, without waiting and without a frame; it is then done.</summary>
        public void Update() => Request?.Update();
        public void WaitForCompletion() => Request?.Complete(ReadbackQueue.CallsBackLate);

        public NativeArray<T> GetData<T>(int layer = 0) where T : struct
        {
            if (Request == null || !Request.IsDone || Request.HasError)
                throw new InvalidOperationException("Cannot access the data as it is not available: "
                    + (Request == null ? "no such request." : Request.WhyUnavailable()));
            if (layer < 0 || layer >= Request.LayerCount)
                throw new ArgumentException($"Layer index is out of range {layer} / {Request.LayerCount}");
            return Request.View<T>(layer);
        }
    }

    public static class AsyncGPUReadback
    {
        public static void WaitAllRequests() => ReadbackQueue.WaitAll();

        public static AsyncGPUReadbackRequest Request(ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback = null)
            => ReadbackQueue.Request(src?.Storage, 0, -1, null, callback);
        public static AsyncGPUReadbackRequest Request(ComputeBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src?.Storage, offset, size, null, callback);
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, ComputeBuffer src,
            Action<AsyncGPUReadbackRequest> callback = null) where T
            : struct => ReadbackQueue.Request(src?.Storage, 0, -1, ReadbackOutput.Of(output), callback);
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, ComputeBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback = null) where T
            : struct => ReadbackQueue.Request(src?.Storage, offset, size, ReadbackOutput.Of(output), callback);
        public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback = null)
            => ReadbackQueue.Request(src?.Storage, 0, -1, null, callback);
        public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src?.Storage, offset, size, null, callback);
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src,
            Action<AsyncGPUReadbackRequest> callback = null) where T
            : struct => ReadbackQueue.Request(src?.Storage, 0, -1, ReadbackOutput.Of(output), callback);
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback = null) where T
            : struct => ReadbackQueue.Request(src?.Storage, offset, size, ReadbackOutput.Of(output), callback);

        static ReadbackRegion All(Texture src, int mip) => ReadbackRegion.Whole(src, mip);

        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0, Action<AsyncGPUReadbackRequest> callback = null)
            => ReadbackQueue.Request(src, mipIndex, All(src, mipIndex), null, null, callback);
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, TextureFormat dstFormat,
            Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src, mipIndex, All(src, mipIndex), dstFormat, null,
            callback);
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, GraphicsFormat dstFormat,
            Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src, mipIndex, All(src, mipIndex),
            Formats.ToTextureFormat(dstFormat), null, callback);
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, int x, int width, int y, int height, int z, int depth,
            Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src, mipIndex,
            new ReadbackRegion(x, width, y, height, z, depth), null, null, callback);
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, int x, int width, int y, int height, int z, int depth,
            TextureFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src, mipIndex,
            new ReadbackRegion(x, width, y, height, z, depth), dstFormat, null, callback);
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, int x, int width, int y, int height, int z, int depth,
            GraphicsFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null) => ReadbackQueue.Request(src, mipIndex,
            new ReadbackRegion(x, width, y, height, z, depth), Formats.ToTextureFormat(dstFormat), null, callback);
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, Texture src, int mipIndex = 0,
            Action<AsyncGPUReadbackRequest> callback = null) where T
            : struct => ReadbackQueue.Request(src, mipIndex, All(src, mipIndex), null, ReadbackOutput.Of(output), callback);
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, Texture src, int mipIndex,
            TextureFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null) where T
            : struct => ReadbackQueue.Request(src, mipIndex, All(src, mipIndex), dstFormat, ReadbackOutput.Of(output), callback);
    }
}
