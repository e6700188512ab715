using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Graphics buffers of one owner: makes each by one line, and describes, binds and releases all of them.</summary>
    /// <remarks>A buffer "Rill.Coarse.Flow" is <c>_Flow</c> in shaders unless another name is given. A kernel that does not declare a buffer
    /// ignores it.</remarks>
    sealed class BufferSet : IDisposable
    {
        struct Item
        {
            public string name;
            public int property;
            public GraphicsBuffer buffer;
            public bool isBound, isConstant, isOwned;
        }

        /// <summary>Instead of a name in shaders: <see cref="Bind"/> leaves the buffer out, as it may go before recorded commands run.</summary>
        public const string Unbound = "";

        readonly List<Item> items = new List<Item>();

        /// <param name="name">Name on the GPU and in descriptions.</param>
        /// <param name="property">Name in shaders.</param>
        /// <exception cref="ArgumentOutOfRangeException">No element, or more bytes than the device can bind.</exception>
        public GraphicsBuffer Structured<T>(string name, long count, string property = null) where T : struct
            => Add(name, GpuBuffer.Structured<T>(name, count), property);

        /// <summary>A raw buffer of words that may be vertices or indices too.</summary>
        /// <exception cref="ArgumentOutOfRangeException">No word, or more bytes than the device can bind.</exception>
        public GraphicsBuffer Raw(string name, long words, GraphicsBuffer.Target target, string property = null)
            => Add(name, GpuBuffer.Raw(name, words, target), property);

        /// <summary>See <see cref="GpuBuffer.Arguments"/>.</summary>
        public GraphicsBuffer Arguments(string name, int words = 12, string property = null)
            => Add(name, GpuBuffer.Arguments(name, words), property);

        /// <summary>One struct as a constant buffer; its size is a multiple of 16 bytes.</summary>
        /// <param name="block">Name of the cbuffer in shaders.</param>
        public GraphicsBuffer Constants<T>(string name, string block) where T : struct
            => Add(name, GpuBuffer.Constants<T>(name), block);

        /// <summary>Describes and binds a buffer that another object releases.</summary>
        public GraphicsBuffer AddShared(string name, GraphicsBuffer buffer, string property = null) => Add(name, buffer, property, false);

        /// <summary>Makes two buffers change roles, and names.</summary>
        public void Swap(ref GraphicsBuffer a, ref GraphicsBuffer b)
        {
            int first = IndexOf(a), second = IndexOf(b);
            (a, b) = (b, a);
            Set(first, a);
            Set(second, b);
        }

        /// <summary>Records all buffers as what a kernel reads and writes.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            foreach (Item item in items)
            {
                if (item.buffer == null || !item.isBound)
                    continue;
                if (item.isConstant)
                    cmd.SetComputeConstantBufferParam(shader, item.property, item.buffer, 0, item.buffer.stride);
                else
                    cmd.SetComputeBufferParam(shader, kernel, item.property, item.buffer);
            }
        }

        public void Describe(StageDescription stage)
        {
            foreach (Item item in items)
                stage.Buffer(item.name, item.buffer);
        }

        /// <summary>Releases one of them; a buffer of the same name can be made again.</summary>
        public void Release(ref GraphicsBuffer buffer)
        {
            if (buffer != null)
                Set(IndexOf(buffer), null);
            GpuBuffer.Release(ref buffer);
        }

        /// <summary>Releases all; each at once, or when the last request that reads it has ended.</summary>
        public void Dispose()
        {
            foreach (Item item in items)
            {
                GraphicsBuffer buffer = item.buffer;
                if (item.isOwned)
                    GpuBuffer.Release(ref buffer);
            }
            items.Clear();
        }

        GraphicsBuffer Add(string name, GraphicsBuffer buffer, string property, bool isOwned = true)
        {
            var item = new Item
            {
                name = name,
                property = Shader.PropertyToID(property ?? "_" + name.Substring(name.LastIndexOf('.') + 1)),
                buffer = buffer,
                isBound = property != Unbound,
                isConstant = (buffer.target & GraphicsBuffer.Target.Constant) != 0,
                isOwned = isOwned,
            };
            for (int i = 0; i < items.Count; i++)
                if (items[i].name == name)
                {
                    items[i] = item;
                    return buffer;
                }
            items.Add(item);
            return buffer;
        }

        int IndexOf(GraphicsBuffer buffer)
        {
            for (int i = 0; i < items.Count; i++)
                if (ReferenceEquals(items[i].buffer, buffer))
                    return i;
            throw new ArgumentException("The buffer is not of this set.");
        }

        void Set(int index, GraphicsBuffer buffer)
        {
            Item item = items[index];
            item.buffer = buffer;
            items[index] = item;
        }
    }
}
