using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Parameters of a shader that are set together, in the order of their names.</summary>
    /// <remarks>A buffer or texture that is null is left out: a kernel that does not declare it needs none. Numbers hold for all kernels of
    /// a compute shader.</remarks>
    readonly struct ShaderParameters
    {
        readonly int[] ids;

        public ShaderParameters(params string[] names) => ids = Array.ConvertAll(names, Shader.PropertyToID);

        /// <summary>Records the values as what a kernel reads and writes.</summary>
        /// <exception cref="ArgumentException">More or fewer values than names.</exception>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel, in ShaderValue a, in ShaderValue b = default,
            in ShaderValue c = default, in ShaderValue d = default, in ShaderValue e = default, in ShaderValue f = default,
            in ShaderValue g = default, in ShaderValue h = default)
        {
            Record(cmd, shader, kernel, 0, a);
            Record(cmd, shader, kernel, 1, b);
            Record(cmd, shader, kernel, 2, c);
            Record(cmd, shader, kernel, 3, d);
            Record(cmd, shader, kernel, 4, e);
            Record(cmd, shader, kernel, 5, f);
            Record(cmd, shader, kernel, 6, g);
            Record(cmd, shader, kernel, 7, h);
        }

        /// <summary>Sets the values for a draw.</summary>
        /// <exception cref="ArgumentException">More or fewer values than names.</exception>
        public void Set(MaterialPropertyBlock block, in ShaderValue a, in ShaderValue b = default, in ShaderValue c = default,
            in ShaderValue d = default, in ShaderValue e = default, in ShaderValue f = default, in ShaderValue g = default,
            in ShaderValue h = default)
        {
            Set(block, 0, a);
            Set(block, 1, b);
            Set(block, 2, c);
            Set(block, 3, d);
            Set(block, 4, e);
            Set(block, 5, f);
            Set(block, 6, g);
            Set(block, 7, h);
        }

        void Record(CommandBuffer cmd, ComputeShader shader, int kernel, int index, in ShaderValue value)
        {
            if (!IsGiven(index, value))
                return;
            switch (value.type)
            {
                case ShaderValue.Type.Int: cmd.SetComputeIntParam(shader, ids[index], value.integer); break;
                case ShaderValue.Type.Float: cmd.SetComputeFloatParam(shader, ids[index], value.vector.x); break;
                case ShaderValue.Type.Vector: cmd.SetComputeVectorParam(shader, ids[index], value.vector); break;
                case ShaderValue.Type.Buffer: cmd.SetComputeBufferParam(shader, kernel, ids[index], (GraphicsBuffer)value.resource); break;
                case ShaderValue.Type.Texture: cmd.SetComputeTextureParam(shader, kernel, ids[index], (Texture)value.resource); break;
            }
        }

        void Set(MaterialPropertyBlock block, int index, in ShaderValue value)
        {
            if (!IsGiven(index, value))
                return;
            switch (value.type)
            {
                case ShaderValue.Type.Int: block.SetInteger(ids[index], value.integer); break;
                case ShaderValue.Type.Float: block.SetFloat(ids[index], value.vector.x); break;
                case ShaderValue.Type.Vector: block.SetVector(ids[index], value.vector); break;
                case ShaderValue.Type.Buffer: block.SetBuffer(ids[index], (GraphicsBuffer)value.resource); break;
                case ShaderValue.Type.Texture: block.SetTexture(ids[index], (Texture)value.resource); break;
            }
        }

        // A parameter that is forgotten would keep the value that another call gave it.
        bool IsGiven(int index, in ShaderValue value)
        {
            if (index < ids.Length == (value.type == ShaderValue.Type.None))
                throw new ArgumentException("There are more or fewer values than names.");
            return !value.IsNull;
        }
    }
}
