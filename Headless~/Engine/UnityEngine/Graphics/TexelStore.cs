using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace UnityEngine.Headless
{
    /// <summary>
    /// The texels of a script-made texture: the managed copy that SetPixels writes and the device texture that Apply fills.
    /// Row 0 is the bottom row and v = 0, in both.
    /// </summary>
    internal sealed class TexelStore
    {
        public readonly int Width, Height, Depth, Slices, Mips;
        public readonly TextureFormat Format;
        public readonly Experimental.Rendering.GraphicsFormat GraphicsFormat;

        readonly byte[][] texels;   // [slice * Mips + mip]; a 3D texture has one slice of all its depth
        readonly GCHandle[] pins;
        readonly string name;
        DeviceTexture device;

        public TexelStore(string name, DeviceTextureDimension dimension, int width, int height, int depth, int slices, TextureFormat format,
            int mips, bool linear)
        {
            if (width <= 0 || height <= 0 || depth <= 0 || slices <= 0)
                throw new UnityException($"Failed to create {name} of {width} x {height} x {Math.Max(depth, slices)}: each side must be at least 1.");
            Gpu.RequireDevice($"new {name}");
            int limit = dimension == DeviceTextureDimension.Tex3D ? Player.Device.Info.MaxTexture3D : Player.Device.Info.MaxTexture2D;
            if (Math.Max(width, Math.Max(height, depth)) > limit)
                throw new UnityException(
                    $"Failed to create {name} of {width} x {height} x {depth}: {Player.Device.Info.Name} allows {limit} a side.");

            this.name = name;
            (Width, Height, Depth, Slices, Format) = (width, height, depth, slices, format);
            int all = 1 + (int)Math.Floor(Math.Log(Math.Max(width, Math.Max(height, depth)), 2));
            Mips = mips < 0 ? all : Math.Max(1, Math.Min(mips, all));
            GraphicsFormat = Formats.Of(format, linear);
            texels = new byte[slices * Mips][];
            pins = new GCHandle[texels.Length];
            for (int slice = 0; slice < slices; slice++)
                for (int mip = 0; mip < Mips; mip++)
                {
                    texels[slice * Mips + mip] = new byte[TexelCount(mip) * Formats.TexelBytes(format)];
                    pins[slice * Mips + mip] = GCHandle.Alloc(texels[slice * Mips + mip], GCHandleType.Pinned);
                }

            device = Gpu.Device.CreateTexture(new DeviceTextureDescription
            {
                Name = name, Dimension = dimension, Format = Formats.Device(GraphicsFormat),
                Width = width, Height = height, Depth = depth, Slices = slices, Mips = Mips, Samples = 1,
            });
            Gpu.Device.ClearTexture(device, default);
            LiveObjects.Add(this, dimension == DeviceTextureDimension.Tex3D ? "Texture3D" : dimension == DeviceTextureDimension.Tex2D
                ? "Texture2D" : dimension == DeviceTextureDimension.Cube ? "Cubemap" : "Texture2DArray", name);
        }

        public DeviceTexture Device => device;
        public override string ToString() => name;

        public int MipWidth(int mip) => Math.Max(1, Width >> mip);
        public int MipHeight(int mip) => Math.Max(1, Height >> mip);
        public int MipDepth(int mip) => Math.Max(1, Depth >> mip);
        public int TexelCount(int mip) => MipWidth(mip) * MipHeight(mip) * MipDepth(mip);

        public byte[] Bytes(int mip, int slice = 0)
        {
            if (mip < 0 || mip >= Mips)
                throw new ArgumentException($"{name} has {Mips} mip levels; level {mip} does not exist.");
            if (slice < 0 || slice >= Slices)
                throw new ArgumentException($"{name} has {Slices} slices; slice {slice} does not exist.");
            return texels[slice * Mips + mip];
        }

        public unsafe NativeArray<T> View<T>(int mip, int slice = 0) where T : struct
        {
            byte[] bytes = Bytes(mip, slice);
            return NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<T>((void*)pins[slice * Mips + mip].AddrOfPinnedObject(),
                bytes.Length / ElementSize<T>.Bytes, Allocator.None);
        }

        public void Assign(ReadOnlySpan<byte> source, int mip, int slice)
        {
            byte[] bytes = Bytes(mip, slice);
            if (source.Length < bytes.Length)
                throw new UnityException($"{name}: level {mip} needs {bytes.Length:N0} bytes, but the data has {source.Length:N0}.");
            source.Slice(0, bytes.Length).CopyTo(bytes);
        }

        public Color Get(int mip, int slice, int index) => TexelCodec.Decode(Bytes(mip, slice), index, Format);
        public void Set(int mip, int slice, int index, Color color) => TexelCodec.Encode(Bytes(mip, slice), index, Format, color);

        public Color[] GetAll(int mip, int slice = 0)
        {
            var colors = new Color[TexelCount(mip)];
            for (int i = 0; i < colors.Length; i++)
                colors[i] = Get(mip, slice, i);
            return colors;
        }

        public Color32[] GetAll32(int mip, int slice = 0) => Array.ConvertAll(GetAll(mip, slice), c => (Color32)c);

        public void SetAll(Color[] colors, int mip, int slice = 0)
        {
            if (colors.Length < TexelCount(mip))
                throw new ArgumentException($"{name}: level {mip} has {TexelCount(mip)} texels, but {colors.Length} colors were given.");
            for (int i = 0; i < TexelCount(mip); i++)
                Set(mip, slice, i, colors[i]);
        }

        public void SetAll32(Color32[] colors, int mip, int slice = 0) => SetAll(Array.ConvertAll(colors, c => (Color)c), mip, slice);

        public void Apply(bool updateMips)
        {
            for (int slice = 0; slice < Slices; slice++)
                for (int mip = 0; mip < Mips; mip++)
                {
                    if (mip > 0 && updateMips)
                        Halve(mip, slice);
                    Gpu.Device.UploadTexture(device, mip, slice, TexelCodec.ForDevice(texels[slice * Mips + mip], Format));
                }
        }

        /// <summary>Each texel the mean of the up to eight above it.</summary>
        void Halve(int mip, int slice)
        {
            int w = MipWidth(mip), h = MipHeight(mip), d = MipDepth(mip);
            int W = MipWidth(mip - 1), H = MipHeight(mip - 1), D = MipDepth(mip - 1);
            for (int z = 0; z < d; z++)
                for (int y = 0; y < h; y++)
                    for (int x = 0; x < w; x++)
                    {
                        Color sum = default;
                        for (int k = 0; k < 8; k++)
                        {
                            int sx = Math.Min(2 * x + (k & 1), W - 1), sy = Math.Min(2 * y + (k >> 1 & 1), H - 1),
                                sz = Math.Min(2 * z + (k >> 2), D - 1);
                            sum += Get(mip - 1, slice, (sz * H + sy) * W + sx);
                        }
                        Set(mip, slice, (z * h + y) * w + x, sum / 8f);
                    }
        }

        public void Release()
        {
            if (device == null)
                return;
            device.Dispose();
            device = null;
            foreach (GCHandle pin in pins)
                pin.Free();
            LiveObjects.Remove(this);
        }
    }
}
