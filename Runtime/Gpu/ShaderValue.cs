using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Value of a parameter of a shader, of the type that the shader declares it with: int and float differ.</summary>
    readonly struct ShaderValue
    {
        public enum Type { None, Int, Float, Vector, Buffer, Texture }

        public readonly Type type;
        public readonly int integer;
        /// <summary>A float is its x.</summary>
        public readonly Vector4 vector;
        /// <summary>Null for a buffer or texture that is left out.</summary>
        public readonly object resource;

        public bool IsNull => type >= Type.Buffer && resource == null;

        ShaderValue(Type type, int integer = 0, Vector4 vector = default, object resource = null)
        {
            this.type = type;
            this.integer = integer;
            this.vector = vector;
            this.resource = resource;
        }

        public static implicit operator ShaderValue(bool value) => new ShaderValue(Type.Int, value ? 1 : 0);

        public static implicit operator ShaderValue(int value) => new ShaderValue(Type.Int, value);

        public static implicit operator ShaderValue(uint value) => new ShaderValue(Type.Int, unchecked((int)value));

        public static implicit operator ShaderValue(float value) => new ShaderValue(Type.Float, vector: new Vector4(value, 0f, 0f, 0f));

        public static implicit operator ShaderValue(float3 value) => new float4(value, 0f);

        public static implicit operator ShaderValue(float4 value) => new ShaderValue(Type.Vector, vector: value);

        public static implicit operator ShaderValue(Vector4 value) => new ShaderValue(Type.Vector, vector: value);

        public static implicit operator ShaderValue(GraphicsBuffer value) => new ShaderValue(Type.Buffer, resource: value);

        public static implicit operator ShaderValue(Texture value) => new ShaderValue(Type.Texture, resource: value);
    }
}
