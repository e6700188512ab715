using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    internal enum PropertyKind : byte { Float, Int, Vector, Matrix }

    /// <summary>Numbers set on a shader property: 32-bit words, and what they mean.</summary>
    internal sealed class PropertyValue
    {
        public PropertyKind Kind;
        public bool IsArray;
        public byte[] Data = Array.Empty<byte>();
        /// <summary>Bytes of <see cref="Data"/> in use.</summary>
        public int Length;

        public int ElementBytes => Kind == PropertyKind.Vector ? 16 : Kind == PropertyKind.Matrix ? 64 : 4;
        public int Count => Length / ElementBytes;
        public ReadOnlySpan<T> As<T>() where T : struct => MemoryMarshal.Cast<byte, T>(Data.AsSpan(0, Length));

        public void Assign(PropertyKind kind, bool isArray, ReadOnlySpan<byte> bytes)
        {
            Kind = kind;
            IsArray = isArray;
            Reserve(bytes.Length);
            bytes.CopyTo(Data);
            Length = bytes.Length;
        }

        /// <summary>Stores like a compute shader: the bytes given replace the front, what lay behind them stays.</summary>
        public void Overwrite(PropertyKind kind, ReadOnlySpan<byte> bytes)
        {
            Kind = kind;
            Reserve(bytes.Length);
            bytes.CopyTo(Data);
            Length = Math.Max(Length, bytes.Length);
        }

        public void Assign(PropertyValue other) => Assign(other.Kind, other.IsArray, other.Data.AsSpan(0, other.Length));

        void Reserve(int bytes)
        {
            if (Data.Length < bytes)
                Array.Resize(ref Data, Math.Max(bytes, 16));
        }

        /// <summary>Bytes as they are: what ComputeShader.Set* does, whose SetFloats does not spread an array to 16 bytes an element.</summary>
        public void WriteRaw(Span<byte> constants, in ConstantField field) =>
            Data.AsSpan(0, Math.Min(Length, field.Bytes)).CopyTo(constants.Slice(field.Offset));

        /// <summary>By element and type: what materials and globals do. Numbers are converted to the declared type.</summary>
        public void WriteConverted(Span<byte> constants, in ConstantField field)
            => Write(constants, field, 0, Math.Min(Math.Max(1, field.ArrayLength), Count), 1);

        /// <summary>A value for each instance from one on; a value that is not an array is that of all.</summary>
        public void WriteInstances(Span<byte> constants, in ConstantField field, int first)
        {
            int length = Math.Max(1, field.ArrayLength);
            if (IsArray)
                Write(constants, field, first, Math.Max(0, Math.Min(length, Count - first)), 1);
            else if (Count > 0)
                Write(constants, field, 0, length, 0);
        }

        void Write(Span<byte> constants, in ConstantField field, int first, int count, int step)
        {
            int stride = field.ArrayLength > 0 ? field.ArrayStride : field.Bytes;
            int size = ElementBytes;
            int lastBytes = field.Bytes - (Math.Max(1, field.ArrayLength) - 1) * stride;    // an array's last element is not padded
            for (int i = 0; i < count; i++)
            {
                Span<byte> target = constants.Slice(field.Offset + i * stride, Math.Min(size, lastBytes));
                Data.AsSpan((first + i * step) * size, target.Length).CopyTo(target);
                Convert(MemoryMarshal.Cast<byte, uint>(target), field.Type);
            }
        }

        void Convert(Span<uint> words, ConstantType type)
        {
            bool isInt = Kind == PropertyKind.Int;
            if (isInt == (type != ConstantType.Float))
                return;
            for (int k = 0; k < words.Length; k++)
            {
                if (isInt)
                    words[k] = (uint)BitConverter.SingleToInt32Bits((int)words[k]);
                else
                    words[k] = (uint)(int)BitConverter.Int32BitsToSingle((int)words[k]);
            }
        }
    }

    /// <summary>A texture or buffer set on a shader property.</summary>
    internal struct PropertyResource
    {
        public Texture Texture;
        public int Mip;
        public Rendering.RenderTextureSubElement Element;
        public BufferStorage Buffer;
        /// <summary>Window of a buffer bound as a whole constant buffer.</summary>
        public int Offset, Size;
        /// <summary>Version of the compute shader's keywords when this was bound to one of its kernels.</summary>
        public int KeywordVersion;
    }

    /// <summary>Property values by id: a material's, a property block's, a compute shader's or the globals.</summary>
    internal sealed class PropertyTable
    {
        readonly Dictionary<int, PropertyValue> values = new Dictionary<int, PropertyValue>();
        readonly Dictionary<int, PropertyResource> resources = new Dictionary<int, PropertyResource>();

        public bool IsEmpty => values.Count == 0 && resources.Count == 0;
        public IEnumerable<int> ValueIds => values.Keys;
        public IEnumerable<KeyValuePair<int, PropertyResource>> Resources => resources;

        public bool TryGet(int id, out PropertyValue value) => values.TryGetValue(id, out value);
        public bool TryGet(int id, out PropertyResource resource) => resources.TryGetValue(id, out resource);

        public void Set(int id, PropertyKind kind, bool isArray, ReadOnlySpan<byte> bytes) => Slot(id).Assign(kind, isArray, bytes);
        public void Overwrite(int id, PropertyKind kind, ReadOnlySpan<byte> bytes) => Slot(id).Overwrite(kind, bytes);

        public void SetFloat(int id, float value) => Slot(id).Assign(PropertyKind.Float, false, Bytes(ref value));
        public void SetInt(int id, int value) => Slot(id).Assign(PropertyKind.Int, false, Bytes(ref value));
        public void SetVector(int id, Vector4 value) => Slot(id).Assign(PropertyKind.Vector, false, Bytes(ref value));
        public void SetMatrix(int id, in Matrix4x4 value)
        {
            Matrix4x4 copy = value;
            Slot(id).Assign(PropertyKind.Matrix, false, Bytes(ref copy));
        }

        /// <summary>Colors are stored as shaders want them: linear when the project is.</summary>
        public void SetColor(int id, Color value) => SetVector(id, Player.LinearColorSpace ? (Vector4)value.linear : (Vector4)value);

        /// <exception cref="ArgumentException">The array is empty, as Unity refuses it.</exception>
        public void SetArray<T>(int id, PropertyKind kind, T[] array, int count) where T : struct
        {
            if (array == null)
                throw new ArgumentNullException(nameof(array));
            if (count == 0)
                throw new ArgumentException("Zero-sized array is not allowed.");
            // Unity fixes the length of an array property at its first use.
            PropertyValue slot = Slot(id);
            ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes<T>(array.AsSpan(0, count));
            if (slot.IsArray && slot.Length != 0 && slot.Length < bytes.Length)
            {
                Debug.LogWarning(
                    $"Property ({PropertyNames.ToName(id)}) exceeds previous array size ({count} vs {slot.Count}). Cap to previous size.");
                bytes = bytes.Slice(0, slot.Length);
            }
            slot.Assign(kind, true, bytes);
        }

        public void SetArray<T>(int id, PropertyKind kind, List<T> list) where T : struct
        {
            if (list == null)
                throw new ArgumentNullException(nameof(list));
            SetArray(id, kind, list.ToArray(), list.Count);
        }

        public void SetTexture(int id, Texture texture, Rendering.RenderTextureSubElement element = Rendering.RenderTextureSubElement.Default)
        {
            if (ReferenceEquals(texture, null))
                resources.Remove(id);
            else
                resources[id] = new PropertyResource { Texture = texture, Element = element };
        }

        public void SetBuffer(int id, BufferStorage buffer)
        {
            if (buffer == null)
                resources.Remove(id);
            else
                resources[id] = new PropertyResource { Buffer = buffer };
        }

        public void SetConstantBuffer(int id, BufferStorage buffer, int offset, int size)
        {
            if (buffer == null)
                resources.Remove(id);
            else
                resources[id] = new PropertyResource { Buffer = buffer, Offset = offset, Size = size };
        }

        public void SetResource(int id, in PropertyResource resource) => resources[id] = resource;

        public float GetFloat(int id)
        {
            if (!values.TryGetValue(id, out PropertyValue value) || value.Length < 4)
                return 0;
            return value.Kind == PropertyKind.Int ? value.As<int>()[0] : value.As<float>()[0];
        }

        public int GetInt(int id)
        {
            if (!values.TryGetValue(id, out PropertyValue value) || value.Length < 4)
                return 0;
            return value.Kind == PropertyKind.Int ? value.As<int>()[0] : (int)value.As<float>()[0];
        }

        public Vector4 GetVector(int id) =>
            values.TryGetValue(id, out PropertyValue value) && value.Length >= 16 ? value.As<Vector4>()[0] : Vector4.zero;

        public Color GetColor(int id)
        {
            Color stored = (Color)GetVector(id);
            return Player.LinearColorSpace ? stored.gamma : stored;
        }

        public Matrix4x4 GetMatrix(int id) =>
            values.TryGetValue(id, out PropertyValue value) && value.Length >= 64 ? value.As<Matrix4x4>()[0] : Matrix4x4.identity;

        public T[] GetArray<T>(int id) where T : struct =>
            values.TryGetValue(id, out PropertyValue value) && value.IsArray ? value.As<T>().ToArray() : null;

        public void GetArray<T>(int id, List<T> into) where T : struct
        {
            if (into == null)
                throw new ArgumentNullException(nameof(into));
            into.Clear();
            T[] array = GetArray<T>(id);
            if (array != null)
                into.AddRange(array);
        }

        public Texture GetTexture(int id) => resources.TryGetValue(id, out PropertyResource resource) ? resource.Texture : null;

        public bool HasValue(int id, PropertyKind kind) => values.TryGetValue(id, out PropertyValue value) && value.Kind == kind;
        public bool HasTexture(int id) => resources.TryGetValue(id, out PropertyResource r) && !ReferenceEquals(r.Texture, null);
        public bool HasBuffer(int id) => resources.TryGetValue(id, out PropertyResource r) && r.Buffer != null && r.Size == 0;
        public bool HasConstantBuffer(int id) => resources.TryGetValue(id, out PropertyResource r) && r.Buffer != null && r.Size != 0;
        public bool Has(int id) => values.ContainsKey(id) || resources.ContainsKey(id);

        public void Clear()
        {
            values.Clear();
            resources.Clear();
        }

        public void CopyFrom(PropertyTable other)
        {
            foreach (KeyValuePair<int, PropertyValue> pair in other.values)
                Slot(pair.Key).Assign(pair.Value);
            foreach (KeyValuePair<int, PropertyResource> pair in other.resources)
                resources[pair.Key] = pair.Value;
        }

        PropertyValue Slot(int id)
        {
            if (!values.TryGetValue(id, out PropertyValue value))
                values.Add(id, value = new PropertyValue());
            return value;
        }

        static ReadOnlySpan<byte> Bytes<T>(ref T value) where T : struct => MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref value, 1));
    }
}
