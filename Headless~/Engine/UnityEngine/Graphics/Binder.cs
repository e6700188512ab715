using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>Finds for each resource of a program what the scripts have set, checks it, and lays it out for the device.</summary>
    internal static class Binder
    {
        static DeviceBinding[] bindings = new DeviceBinding[64];
        static int bound, firstInstance;
        static readonly List<(BufferStorage buffer, string name)> read = new List<(BufferStorage, string)>(),
            written = new List<(BufferStorage, string)>();

        static readonly DeviceSampler defaultSampler = new DeviceSampler { Linear = true, LinearMip = false };

        public static ReadOnlySpan<DeviceBinding> Bindings => bindings.AsSpan(0, bound);

        /// <summary>False: something is missing, was reported, and the dispatch is skipped.</summary>
        public static bool Compute(ComputeShader shader, int kernel, ProgramLayout layout)
        {
            Begin(layout.Slots.Length);
            bool complete = true;
            PropertyTable own = shader.Values, resources = shader.KernelResources(kernel);
            string name = layout.Program.Name;

            for (int i = 0; i < layout.Slots.Length; i++)
            {
                ref ProgramLayout.Slot slot = ref layout.Slots[i];
                ShaderResource resource = slot.Resource;
                ref DeviceBinding binding = ref bindings[bound++];
                switch (resource.Kind)
                {
                    case ShaderResourceKind.ConstantBuffer:
                        if (!resource.Constants.IsGlobals
                            && (own.TryGet(slot.Id, out PropertyResource whole) || Shader.Globals.TryGet(slot.Id, out whole))
                            && whole.Buffer != null)
                            complete &= WholeConstants(name, resource, whole, ref binding);
                        else
                            ComputeConstants(own, name, ref slot, ref binding);
                        break;

                    case ShaderResourceKind.Sampler:
                        binding.Sampler = resource.InlineSampler ??
                            (slot.SamplerOf >= 0
                            && (resources.TryGet(slot.SamplerOf, out PropertyResource sampled)
                            || Shader.Globals.TryGet(slot.SamplerOf, out sampled)) && !ReferenceEquals(sampled.Texture, null)
                                ? sampled.Texture.Sampler : defaultSampler);
                        break;

                    default:
                        bool isOwn = resources.TryGet(slot.Id, out PropertyResource found);
                        if (isOwn)
                            GpuChecks.Keywords(name, resource, found.KeywordVersion == shader.KeywordVersion);
                        if (!isOwn && !Shader.Globals.TryGet(slot.Id, out found))
                            complete &= GpuChecks.Missing(name, resource, kernel);
                        else
                            complete &= Resource(name, resource, found, kernel, ref binding);
                        break;
                }
            }
            CheckFilters(layout);
            return complete && !Aliased(name);
        }

        /// <summary>Bindings of the vertex program, then of the fragment program.</summary>
        /// <param name="instance">Where the arrays of instanced properties begin for this draw.</param>
        public static bool Draw(ProgramLayout vertex, ProgramLayout fragment, PropertyTable block, Material material, int instance = 0)
        {
            firstInstance = instance;
            Begin(vertex.Slots.Length + fragment.Slots.Length);
            bool complete = Stage(vertex, block, material);
            return Stage(fragment, block, material) && complete && !Aliased(vertex.Program.Name);
        }

        static bool Stage(ProgramLayout layout, PropertyTable block, Material material)
        {
            bool complete = true;
            string name = layout.Program.Name;
            for (int i = 0; i < layout.Slots.Length; i++)
            {
                ref ProgramLayout.Slot slot = ref layout.Slots[i];
                ShaderResource resource = slot.Resource;
                ref DeviceBinding binding = ref bindings[bound++];
                switch (resource.Kind)
                {
                    case ShaderResourceKind.ConstantBuffer:
                        if (!resource.Constants.IsGlobals && TryResource(slot.Id, block, material, out PropertyResource whole)
                            && whole.Buffer != null)
                            complete &= WholeConstants(name, resource, whole, ref binding);
                        else
                            DrawConstants(ref slot, block, material, ref binding);
                        break;

                    case ShaderResourceKind.Sampler:
                        binding.Sampler = resource.InlineSampler ??
                            (slot.SamplerOf >= 0 ? TextureFor(slot.SamplerOf, block, material, DeviceTextureDimension.Tex2D)?.Sampler
                            ?? defaultSampler : defaultSampler);
                        break;

                    case ShaderResourceKind.Texture:
                        if (TryResource(slot.Id, block, material, out PropertyResource texture) && !ReferenceEquals(texture.Texture, null))
                        {
                            // Unlike a kernel, a draw goes on with a texture that is not there (it reads 0).
                            DeviceTexture device = texture.Texture.GetDevice(texture.Element);
                            if (device != null && GpuChecks.Texture(name, resource, texture.Texture, device))
                                binding.Texture = device;
                        }
                        else
                        {
                            binding.Texture = TextureFor(slot.Id, block, material, resource.Dimension)?.GetDevice(RenderTextureSubElement.Default);
                        }
                        break;

                    default:
                        if (!TryResource(slot.Id, block, material, out PropertyResource found))
                            complete &= GpuChecks.Missing(name, resource, -1);
                        else
                            complete &= Resource(name, resource, found, -1, ref binding);
                        break;
                }
            }
            CheckFilters(layout);
            return complete;
        }

        // Checks the program whose slots were bound last.
        static void CheckFilters(ProgramLayout layout)
        {
            if (!Player.Strict)
                return;
            int first = bound - layout.Slots.Length;
            for (int i = 0; i < layout.Slots.Length; i++)
                if (layout.Slots[i].Sampled is int[] sampled)
                    foreach (int slot in sampled)
                        GpuChecks.Filter(layout.Program.Name, layout.Slots[i].Resource, bindings[first + i].Sampler,
                            layout.Slots[slot].Resource, bindings[first + slot].Texture);
        }

        static void Begin(int count)
        {
            if (bindings.Length < count)
                bindings = new DeviceBinding[count * 2];
            Array.Clear(bindings, 0, Math.Max(count, bound));
            bound = 0;
            read.Clear();
            written.Clear();
        }

        static bool Resource(string name, ShaderResource resource, in PropertyResource found, int kernel, ref DeviceBinding binding)
        {
            if (resource.Kind == ShaderResourceKind.Texture || resource.Kind == ShaderResourceKind.RWTexture)
            {
                if (ReferenceEquals(found.Texture, null))
                    return GpuChecks.Missing(name, resource, kernel);
                DeviceTexture device = found.Texture.GetDevice(found.Element);
                if (!GpuChecks.Texture(name, resource, found.Texture, device))
                    return false;
                binding.Texture = device;
                binding.Mip = found.Mip;
                return true;
            }

            BufferStorage buffer = found.Buffer;
            if (buffer == null)
                return GpuChecks.Missing(name, resource, kernel);
            if (resource.Kind == ShaderResourceKind.Counter)
            {
                // Its buffer is a resource of its own and is checked there.
                binding.Buffer = buffer.Counter;
                return true;
            }
            if (!GpuChecks.Buffer(name, resource, buffer, kernel))
                return false;
            binding.Buffer = buffer.Device;
            (GpuChecks.IsUav(resource.Kind) ? written : read).Add((buffer, resource.Name));
            return true;
        }

        static bool Aliased(string name)
        {
            for (int w = 0; w < written.Count; w++)
                for (int r = 0; r < read.Count; r++)
                    if (read[r].buffer == written[w].buffer)
                        GpuChecks.Aliased(name, read[r].buffer, read[r].name, written[w].name);
            return false;
        }

        /// <summary>After the work was handed to the device: what was bound for writing counts as written.</summary>
        public static void MarkWritten()
        {
            for (int i = 0; i < written.Count; i++)
                written[i].buffer.MarkWritten();
        }

        static bool WholeConstants(string name, ShaderResource resource, in PropertyResource whole, ref DeviceBinding binding)
        {
            if (!GpuChecks.ConstantBuffer(name, resource, whole))
                return false;
            binding.Buffer = whole.Buffer.Device;
            binding.Offset = whole.Offset;
            binding.Bytes = whole.Size;
            return true;
        }

        static void ComputeConstants(PropertyTable own, string name, ref ProgramLayout.Slot slot, ref DeviceBinding binding)
        {
            Span<byte> bytes = slot.Constants;
            bytes.Clear();
            for (int f = 0; f < slot.Fields.Length; f++)
            {
                ref ProgramLayout.Field field = ref slot.Fields[f];
                if (own.TryGet(field.Id, out PropertyValue value))
                {
                    if ((value.Kind == PropertyKind.Int) == (field.Layout.Type == ConstantType.Float))
                        GpuError.Strictly($"{name}: '{field.Layout.Name}' is declared {field.Layout.Type}, but was set as " +
                            $"{value.Kind}; compute shaders take the bits as they are.");
                    value.WriteRaw(bytes, field.Layout);
                }
                else if (Shader.Globals.TryGet(field.Id, out value))
                    value.WriteConverted(bytes, field.Layout);
            }
            binding.Constants = slot.Constants;
            binding.ConstantsLength = slot.Resource.Constants.Bytes;
        }

        static void DrawConstants(ref ProgramLayout.Slot slot, PropertyTable block, Material material, ref DeviceBinding binding)
        {
            Span<byte> bytes = slot.Constants;
            bytes.Clear();
            for (int f = 0; f < slot.Fields.Length; f++)
            {
                ref ProgramLayout.Field field = ref slot.Fields[f];
                if (TryValue(field.Id, block, material, out PropertyValue value))
                {
                    if (slot.Instanced)
                        value.WriteInstances(bytes, field.Layout, firstInstance);
                    else
                        value.WriteConverted(bytes, field.Layout);
                }
                else if (field.TexelSizeOf >= 0)
                {
                    Texture texture = TextureFor(field.TexelSizeOf, block, material, DeviceTextureDimension.Tex2D);
                    if (!ReferenceEquals(texture, null))
                        Write(bytes, field.Layout, new Vector4(1f / texture.width, 1f / texture.height, texture.width, texture.height));
                }
                else if (field.ScaleOffsetOf >= 0)
                    Write(bytes, field.Layout, new Vector4(1, 1, 0, 0));
            }
            binding.Constants = slot.Constants;
            binding.ConstantsLength = slot.Resource.Constants.Bytes;
        }

        static readonly PropertyValue scratch = new PropertyValue();

        static void Write(Span<byte> bytes, in ConstantField field, Vector4 value)
        {
            scratch.Assign(PropertyKind.Vector, false,
                System.Runtime.InteropServices.MemoryMarshal.AsBytes(
                System.Runtime.InteropServices.MemoryMarshal.CreateReadOnlySpan(ref value, 1)));
            scratch.WriteConverted(bytes, field);
        }

        static bool TryValue(int id, PropertyTable block, Material material, out PropertyValue value) =>
            block != null && block.TryGet(id, out value) || material.Values.TryGet(id, out value) || Shader.Globals.TryGet(id, out value);

        static bool TryResource(int id, PropertyTable block, Material material, out PropertyResource resource) =>
            block != null && block.TryGet(id, out resource) || material.Values.TryGet(id, out resource) || Shader.Globals.TryGet(id, out resource);

        static Texture TextureFor(int id, PropertyTable block, Material material, DeviceTextureDimension dimension)
        {
            if (TryResource(id, block, material, out PropertyResource resource) && !ReferenceEquals(resource.Texture, null))
                return resource.Texture;
            return BuiltinTextures.Named(material.shader.DefaultTextureName(id), dimension);
        }
    }
}
