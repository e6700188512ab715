using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>Demands of Direct3D 11 on a dispatch or draw: its size, its kernel's limits, and everything bound to it.</summary>
    internal static class GpuChecks
    {
        public const int MaxGroups = 65535;
        const int MaxUavs = 8;

        /// <summary>Refuses programs above the player's limits, and above Unity's own of 8 views to write.</summary>
        public static bool Program(ProgramLayout layout)
        {
            ShaderProgram program = layout.Program;
            string strict = null;
            if (program.UavCount > MaxUavs)
                strict = $"{program.Name} uses {program.UavCount} unordered access views (append and consume counters included in " +
                    $"their buffers'); Direct3D 11 allows {MaxUavs}, and so does Unity elsewhere. Pack or split buffers.";
            else if (layout.Excess != null)
                strict = $"{program.Name} is more than {Player.Limits.Title} holds: {layout.Excess}. Use a smaller variant where " +
                    $"SystemInfo reports less.";
            if (strict == null)
                return true;
            GpuError.Report(strict, strict);
            return false;
        }

        public static bool Groups(string kernel, int x, int y, int z)
        {
            if (x >= 1 && y >= 1 && z >= 1 && x <= MaxGroups && y <= MaxGroups && z <= MaxGroups)
                return true;
            if (x < 1 || y < 1 || z < 1)
                GpuError.Report($"Dispatch of {kernel} with {x} x {y} x {z} thread groups: each must be at least 1; skip the dispatch " +
                    $"when there is nothing to do.",
                    "Thread group count must be above zero");
            else
                GpuError.Report($"Dispatch of {kernel} with {x:N0} x {y:N0} x {z:N0} thread groups: Direct3D 11 allows {MaxGroups:N0} " +
                $"in each dimension; fold the dispatch into two dimensions.",
                    "Thread group count is above the maximum allowed limit. Maximum allowed thread group count is 65535");
            return false;
        }

        public static bool Missing(string program, ShaderResource resource, int kernel)
        {
            GpuError.Report($"{program}: nothing is bound to '{resource.Name}' ({resource.Kind}).",
                kernel >= 0 ? $"Compute shader ({program}): Property ({resource.Name}) at kernel index ({kernel}) is not set"
                            : $"{program}: a {resource.Kind} '{resource.Name}' is required, but none is bound; the draw is skipped.");
            return false;
        }

        /// <summary>A keyword selects another variant, and whether what was bound for the one before is bound for it too, Unity does not
        /// say.</summary>
        public static void Keywords(string program, ShaderResource resource, bool unchanged)
        {
            if (!unchanged)
                GpuError.Strictly($"{program}: a keyword of its shader was changed after '{resource.Name}' was bound, which selects " +
                    $"another variant. Set the keywords first, then bind.");
        }

        public static bool Released(string program, ShaderResource resource, string what)
        {
            GpuError.Report($"{program}: what is bound to '{resource.Name}' was released before this use: {what}.",
                $"{program}: Property ({resource.Name}) is bound to a released resource: {what}");
            return false;
        }

        public static bool Buffer(string program, ShaderResource resource, BufferStorage buffer, int kernel)
        {
            if (buffer.IsReleased)
                return Released(program, resource, buffer.ToString());

            long limit = Player.Device.Info.MaxBufferBytes;
            if (buffer.Bytes > limit)
                throw new GpuUsageException($"{program}: {buffer} bound to '{resource.Name}' holds {buffer.Bytes:N0} bytes, but " +
                    $"{Player.Device.Info.Name} binds at most {limit:N0} at once; split the buffer or use a smaller count.");

            switch (resource.Kind)
            {
                case ShaderResourceKind.StructuredBuffer:
                case ShaderResourceKind.RWStructuredBuffer:
                    if (!buffer.IsStructured)
                        GpuError.Strictly($"{program}: '{resource.Name}' is a structured buffer, but {buffer} was created without " +
                            $"Structured, Append or Counter among its targets (it has {buffer.Target}).");
                    if (resource.Stride != buffer.Stride)
                        GpuError.Strictly($"{program}: '{resource.Name}' has elements of {resource.Stride} bytes, but {buffer} has a " +
                            $"stride of {buffer.Stride}.");
                    if (resource.IsAppendConsume && buffer.Counter == null)
                    {
                        GpuError.Report($"{program}: '{resource.Name}' appends, consumes or counts, but {buffer} was created without " +
                            $"Append or Counter among its targets (it has {buffer.Target}).",
                            $"{program}: Property ({resource.Name}) needs a buffer of type Append or Counter");
                        return false;
                    }
                    break;
                case ShaderResourceKind.RawBuffer:
                case ShaderResourceKind.RWRawBuffer:
                    if (!buffer.Is(GraphicsBuffer.Target.Raw))
                        GpuError.Strictly($"{program}: '{resource.Name}' is a ByteAddressBuffer, but {buffer} was created without Raw " +
                            $"among its targets (it has {buffer.Target}).");
                    break;
            }

            if (!IsUav(resource.Kind) && !buffer.Written)
                GpuError.Strictly($"{program} reads {buffer} through '{resource.Name}', but nothing has written it yet (no SetData, " +
                    $"copy or RW binding); its content is undefined.");
            return true;
        }

        public static void Aliased(string program, BufferStorage buffer, string srv, string uav) =>
            GpuError.Strictly($"{program}: {buffer} is bound to '{srv}' for reading and to '{uav}' for writing in one dispatch; " +
            $"Direct3D 11 unbinds the former. Declare one RWStructuredBuffer or use two buffers.");

        public static bool ConstantBuffer(string program, ShaderResource resource, in PropertyResource bound)
        {
            BufferStorage buffer = bound.Buffer;
            if (buffer.IsReleased)
                return Released(program, resource, buffer.ToString());
            if (!buffer.Is(GraphicsBuffer.Target.Constant))
                GpuError.Strictly($"{program}: {buffer} is bound to the constant buffer '{resource.Name}', but was created without " +
                    $"Constant among its targets (it has {buffer.Target}).");
            if (bound.Offset < 0 || bound.Offset % 256 != 0)
                GpuError.Strictly($"{program}: constant buffer '{resource.Name}' is bound at offset {bound.Offset} of {buffer}; " +
                    $"offsets are multiples of 256.");
            if (bound.Offset + (long)bound.Size > buffer.Bytes)
                GpuError.Strictly($"{program}: constant buffer '{resource.Name}' is bound to bytes {bound.Offset:N0} to " +
                    $"{bound.Offset + (long)bound.Size:N0} of {buffer}, which holds {buffer.Bytes:N0}.");
            if (bound.Size < resource.Constants.Bytes)
                GpuError.Strictly($"{program}: constant buffer '{resource.Name}' needs {resource.Constants.Bytes} bytes, but " +
                    $"{bound.Size} of {buffer} are bound.");
            if (!buffer.Written)
                GpuError.Strictly($"{program} reads {buffer} through the constant buffer '{resource.Name}', but nothing has written it " +
                    $"yet; its content is undefined.");
            return true;
        }

        /// <summary>Textures that what runs now must not read, and why: of a render graph's pass, those that it has not declared.</summary>
        public static readonly System.Collections.Generic.HashSet<Texture> Withheld = new System.Collections.Generic.HashSet<Texture>();
        public static string WithheldBecause;

        public static bool Texture(string program, ShaderResource resource, Texture texture, DeviceTexture device)
        {
            if (Withheld.Count > 0 && Withheld.Contains(texture))
                throw new GpuUsageException($"{program}: '{resource.Name}' is {texture.GetType().Name} '{texture.NameOf}', {WithheldBecause}.");
            if (device == null)
            {
                GpuError.Report($"{program}: {texture.GetType().Name} '{texture.NameOf}', bound to '{resource.Name}', does not exist: " +
                    $"it was never created (RenderTexture.Create), or it was released or destroyed.",
                    $"{program}: Property ({resource.Name}) is bound to a texture that was not created: '{texture.NameOf}'");
                return false;
            }
            if (device.Description.Dimension != resource.Dimension)
            {
                GpuError.Report($"{program}: '{resource.Name}' is a {resource.Dimension} texture, but {texture.GetType().Name} " +
                    $"'{texture.NameOf}' is {device.Description.Dimension}.",
                    $"{program}: Texture dimension mismatch at '{resource.Name}': expected {resource.Dimension}, got {device.Description.Dimension}");
                return false;
            }
            if (resource.Kind == ShaderResourceKind.RWTexture && !device.Description.RandomWrite)
            {
                GpuError.Report($"{program}: '{resource.Name}' is an RWTexture, but {texture.GetType().Name} '{texture.NameOf}' was " +
                    $"created without enableRandomWrite.",
                    $"{program}: Attempting to bind texture '{texture.NameOf}' as UAV but the texture wasn't created with the UAV usage flag set!");
                return false;
            }
            return true;
        }

        /// <summary>No device has to filter 32-bit floats: Metal, WebGPU and Vulkan on phones need not, and many do not.</summary>
        public static void Filter(string program, ShaderResource sampler, in DeviceSampler state, ShaderResource resource, DeviceTexture device)
        {
            if (device == null || state.Comparison || !(state.Linear || state.LinearMip && device.Description.Mips > 1))
                return;
            DeviceFormat format = device.Description.Format;
            bool optional = format is DeviceFormat.R32_Float or DeviceFormat.RG32_Float or DeviceFormat.RGBA32_Float or DeviceFormat.D32_Float
                or DeviceFormat.D32_S8;
            // Blits of the engine itself: their textures are a project's own.
            if (optional && !program.Contains("(Hidden/", System.StringComparison.Ordinal))
                GpuError.Strictly($"{program}: '{resource.Name}' ({device.Description.Name}) is {format} and is read through '{sampler.Name}', " +
                    $"which filters. Metal, WebGPU and many Androids do not filter 32-bit floats: load texels and filter by hand, or use a " +
                    $"16-bit format.");
        }

        public static bool IsUav(ShaderResourceKind kind) =>
            kind == ShaderResourceKind.RWStructuredBuffer || kind == ShaderResourceKind.RWRawBuffer || kind == ShaderResourceKind.RWTypedBuffer ||
            kind == ShaderResourceKind.RWTexture || kind == ShaderResourceKind.Counter;

        // ---- indirect arguments written on the GPU

        struct PendingArguments
        {
            public DeviceReadback Readback;
            public string Call;
            public BufferStorage Buffer;
            public long Offset;
        }

        static readonly List<PendingArguments> pending = new List<PendingArguments>();
        static readonly Dictionary<(BufferStorage, long), int> inspected = new Dictionary<(BufferStorage, long), int>();

        /// <summary>Takes a copy of a dispatch's arguments in stream order; content seen before is not looked at again.</summary>
        public static void WatchArguments(string kernel, BufferStorage buffer, long offset)
        {
            if (!Player.Strict)
                return;
            if (inspected.TryGetValue((buffer, offset), out int version) && version == buffer.Version)
                return;
            inspected[(buffer, offset)] = buffer.Version;
            pending.Add(new PendingArguments
            {
                Readback = Gpu.Device.BeginReadback(buffer.Device, offset, 12), Call = kernel, Buffer = buffer, Offset = offset,
            });
        }

        /// <summary>Looks at the copies that have arrived, or at all of them.</summary>
        public static void InspectArguments(bool wait)
        {
            string fault = null;
            int kept = 0;
            for (int i = 0; i < pending.Count; i++)
            {
                PendingArguments p = pending[i];
                if (!wait && !p.Readback.IsDone)
                {
                    pending[kept++] = p;
                    continue;
                }
                System.ReadOnlySpan<uint> groups = MemoryMarshal.Cast<byte, uint>(p.Readback.Data);
                if (groups[0] > MaxGroups || groups[1] > MaxGroups || groups[2] > MaxGroups)
                    fault ??= $"Indirect dispatch of {p.Call} found {groups[0]:N0} x {groups[1]:N0} x {groups[2]:N0} thread groups at " +
                        $"byte {p.Offset:N0} of {p.Buffer}; Direct3D 11 allows {MaxGroups:N0} in each dimension.";
                p.Readback.Dispose();
            }
            pending.RemoveRange(kept, pending.Count - kept);
            if (inspected.Count > 1024)
                inspected.Clear();
            if (fault != null)
                throw new GpuUsageException(fault);
        }

        public static void Reset()
        {
            foreach (PendingArguments p in pending)
                p.Readback.Dispose();
            pending.Clear();
            inspected.Clear();
        }
    }
}
