using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>Memory of the caller's that a read-back fills, by a NativeArray over it.</summary>
    internal sealed class ReadbackOutput
    {
        public delegate void Filler(ReadOnlySpan<byte> data);
        public long Bytes;
        public Filler Fill;

        public static ReadbackOutput Of<T>(NativeArray<T> array) where T : struct
        {
            using NativeWork.Scope native = NativeWork.Enter();
            if (!array.IsCreated)
                throw new ArgumentException("AsyncGPUReadback: the output array was not created.");
            return Into(array);
        }

        // Apart, because what a lambda captures is allocated where its method begins: here, in native code's name.
        static ReadbackOutput Into<T>(NativeArray<T> array) where T : struct => new ReadbackOutput
        {
            Bytes = (long)array.Length * ElementSize<T>.Bytes,
            Fill = data => Copy(data, Transfer.Bytes(array)),      // throws when the array was disposed meanwhile
        };

        // Large ones spend most of the time on the pages of memory that is new, which cores can touch side by side.
        static unsafe void Copy(ReadOnlySpan<byte> data, Span<byte> target)
        {
            const int piece = 1 << 20;
            if (target.Length < data.Length || data.Length <= piece)
            {
                data.CopyTo(target);
                return;
            }
            int length = data.Length;
            fixed (byte* from = data, to = target)
            {
                byte* source = from, destination = to;
                Parallel.For(0, (length + piece - 1) / piece, i =>
                {
                    long first = (long)i * piece, bytes = Math.Min(piece, length - first);
                    Buffer.MemoryCopy(source + first, destination + first, bytes, bytes);
                });
            }
        }
    }

    internal readonly struct ReadbackRegion
    {
        public readonly int X, Width, Y, Height, Z, Depth;
        public ReadbackRegion(int x, int width, int y, int height, int z, int depth)
            => (X, Width, Y, Height, Z, Depth) = (x, width, y, height, z, depth);

        public static ReadbackRegion Whole(Texture texture, int mip)
        {
            if (texture == null)
                throw new ArgumentNullException("src", "AsyncGPUReadback.Request: the texture is null.");
            return new ReadbackRegion(0, Math.Max(1, texture.width >> mip), 0, Math.Max(1, texture.height >> mip), 0, FullDepth(texture, mip));
        }

        public static int FullDepth(Texture texture, int mip)
        {
            switch (texture)
            {
                case Texture3D volume: return Math.Max(1, volume.depth >> mip);
                case Texture2DArray array: return array.depth;
                case RenderTexture target: return target.dimension == TextureDimension.Tex3D ? Math.Max(1, target.volumeDepth >> mip)
                    : target.volumeDepth;
                default: return 1;
            }
        }
    }

    /// <summary>A pending read-back: copied on the device at the request, fetched at the second frame after it or by an Update before, gone
    /// with the next.</summary>
    internal sealed unsafe class ReadbackRequest
    {
        public int LayerCount, LayerBytes, Width, Height, Depth;
        public bool ForceUpdate;
        public int DueFrame, DoneFrame = -1;
        /// <summary>For messages: the buffer or texture.</summary>
        public object Source;
        /// <summary>Buffer that it reads; null for a texture.</summary>
        public BufferStorage Buffer;

        public List<DeviceReadback> Copies = new List<DeviceReadback>();
        /// <summary>Turns what the device copied into the layers that were asked for; null takes them as they are.</summary>
        public Func<List<DeviceReadback>, byte[][]> Convert;
        public ReadbackOutput Output;
        public Action<AsyncGPUReadbackRequest> Callback;

        readonly List<IntPtr> layers = new List<IntPtr>();
        SafetyHandle safety;
        bool expired, failed;

        public bool IsDone => DoneFrame >= 0;
        public bool HasError => expired || failed;

        public string WhyUnavailable() => failed ? $"the request for {Source} ended with an error." : !IsDone
            ? $"the request for {Source} is not done; it arrives at the beginning of the second frame after it."
            : $"the data of {Source} was valid in the frame in which it arrived; copy it there, or request into a NativeArray.";

        /// <summary>Completes the request if the device is through with it, and sees to it that it gets there.</summary>
        public void Update()
        {
            if (IsDone || expired)
                return;
            // Unity's render thread submits by itself; here what was recorded lies until somebody asks for it.
            Gpu.Device.Flush();
            foreach (DeviceReadback copy in Copies)
                if (!copy.IsDone)
                    return;
            Complete();
        }

        /// <summary>Whether the data have come and the callback has not.</summary>
        public bool CallbackIsDue { get; private set; }

        /// <summary>Waits for the device if need be.</summary>
        /// <param name="callsBackLate">The callback comes with the next frame, not now.</param>
        public void Complete(bool callsBackLate = false)
        {
            if (IsDone)
                return;
            Fetch();
            CallbackIsDue = true;
            if (!callsBackLate)
                CallBack();
        }

        public void CallBack()
        {
            CallbackIsDue = false;
            Callback?.Invoke(new AsyncGPUReadbackRequest(this));
        }

        void Fetch()
        {
            DoneFrame = ReadbackQueue.Frame;
            if (ReadbackQueue.Fails?.Invoke(Source.ToString()) == true)
            {
                failed = true;
                DropCopies();
                return;
            }
            byte[][] converted = Convert?.Invoke(Copies);
            int count = converted?.Length ?? Copies.Count;
            if (Output == null)
                safety = NativeMemory.OpenView();
            for (int i = 0; i < count; i++)
            {
                ReadOnlySpan<byte> data = converted != null ? converted[i] : Copies[i].Data;
                if (Output != null)
                {
                    Output.Fill(data);
                    continue;
                }
                void* memory = NativeMemory.Raw(data.Length);
                data.CopyTo(new Span<byte>(memory, data.Length));
                layers.Add((IntPtr)memory);
            }
            DropCopies();
        }

        public NativeArray<T> View<T>(int layer) where T : struct
        {
            if (Output != null)
                throw new InvalidOperationException($"The data of {Source} was requested into a NativeArray; read it there.");
            return NativeArray<T>.View((void*)layers[layer], LayerBytes / ElementSize<T>.Bytes, Allocator.None, safety);
        }

        /// <summary>The frame of the data is over.</summary>
        public void Expire()
        {
            expired = true;
            NativeMemory.Close(safety);
            foreach (IntPtr layer in layers)
                NativeMemory.FreeRaw((void*)layer);
            layers.Clear();
            DropCopies();
        }

        void DropCopies()
        {
            foreach (DeviceReadback copy in Copies)
                copy.Dispose();
            Copies.Clear();
        }
    }
}
