using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine.Headless;

namespace UnityEngine.Rendering
{
    public partial class CommandBuffer
    {
        void Global<T>(int id, PropertyKind kind, T value) where T : struct
        {
            ref Command c = ref Add(Op.GlobalValue);
            (c.A, c.Kind) = (id, kind);
            Store(ref c, value);
        }

        void Global<T>(int id, PropertyKind kind, T[] values) where T : struct
        {
            if (NotNull(values, "values", "SetGlobal*Array").Length == 0)
                throw new ArgumentException("Zero-sized array is not allowed.");
            ref Command c = ref Add(Op.GlobalValue);
            (c.A, c.Kind, c.Flag) = (id, kind, true);
            Store(ref c, values);
        }

        public void SetGlobalFloat(int nameID, float value) => Global(nameID, PropertyKind.Float, value);
        public void SetGlobalFloat(string name, float value) => SetGlobalFloat(Shader.PropertyToID(name), value);
        public void SetGlobalInt(int nameID, int value) => Global(nameID, PropertyKind.Float, (float)value);
        public void SetGlobalInt(string name, int value) => SetGlobalInt(Shader.PropertyToID(name), value);
        public void SetGlobalInteger(int nameID, int value) => Global(nameID, PropertyKind.Int, value);
        public void SetGlobalInteger(string name, int value) => SetGlobalInteger(Shader.PropertyToID(name), value);
        public void SetGlobalVector(int nameID, Vector4 value) => Global(nameID, PropertyKind.Vector, value);
        public void SetGlobalVector(string name, Vector4 value) => SetGlobalVector(Shader.PropertyToID(name), value);
        public void SetGlobalColor(int nameID, Color value)
            => Global(nameID, PropertyKind.Vector, Player.LinearColorSpace ? (Vector4)value.linear : (Vector4)value);
        public void SetGlobalColor(string name, Color value) => SetGlobalColor(Shader.PropertyToID(name), value);
        public void SetGlobalMatrix(int nameID, Matrix4x4 value) => Global(nameID, PropertyKind.Matrix, value);
        public void SetGlobalMatrix(string name, Matrix4x4 value) => SetGlobalMatrix(Shader.PropertyToID(name), value);
        public void SetGlobalFloatArray(int nameID, float[] values) => Global(nameID, PropertyKind.Float, values);
        public void SetGlobalFloatArray(string propertyName, float[] values) => SetGlobalFloatArray(Shader.PropertyToID(propertyName), values);
        public void SetGlobalFloatArray(int nameID, List<float> values) => Global(nameID, PropertyKind.Float, values?.ToArray());
        public void SetGlobalFloatArray(string propertyName, List<float> values) => SetGlobalFloatArray(Shader.PropertyToID(propertyName), values);
        public void SetGlobalVectorArray(int nameID, Vector4[] values) => Global(nameID, PropertyKind.Vector, values);
        public void SetGlobalVectorArray(string propertyName, Vector4[] values) => SetGlobalVectorArray(Shader.PropertyToID(propertyName), values);
        public void SetGlobalVectorArray(int nameID, List<Vector4> values) => Global(nameID, PropertyKind.Vector, values?.ToArray());
        public void SetGlobalVectorArray(string propertyName, List<Vector4> values)
            => SetGlobalVectorArray(Shader.PropertyToID(propertyName), values);
        public void SetGlobalMatrixArray(int nameID, Matrix4x4[] values) => Global(nameID, PropertyKind.Matrix, values);
        public void SetGlobalMatrixArray(string propertyName, Matrix4x4[] values) => SetGlobalMatrixArray(Shader.PropertyToID(propertyName), values);
        public void SetGlobalMatrixArray(int nameID, List<Matrix4x4> values) => Global(nameID, PropertyKind.Matrix, values?.ToArray());
        public void SetGlobalMatrixArray(string propertyName, List<Matrix4x4> values)
            => SetGlobalMatrixArray(Shader.PropertyToID(propertyName), values);
        public void SetGlobalBuffer(int nameID, ComputeBuffer value) => GlobalBuffer(nameID, value?.Storage);
        public void SetGlobalBuffer(string name, ComputeBuffer value) => SetGlobalBuffer(Shader.PropertyToID(name), value);
        public void SetGlobalConstantBuffer(ComputeBuffer buffer, int nameID, int offset, int size)
            => GlobalConstants(nameID, buffer?.Storage, offset, size);
        public void SetGlobalConstantBuffer(ComputeBuffer buffer, string name, int offset, int size)
            => GlobalConstants(Shader.PropertyToID(name), buffer?.Storage, offset, size);
        public void SetGlobalBuffer(int nameID, GraphicsBuffer value) => GlobalBuffer(nameID, value?.Storage);
        public void SetGlobalBuffer(string name, GraphicsBuffer value) => SetGlobalBuffer(Shader.PropertyToID(name), value);
        public void SetGlobalConstantBuffer(GraphicsBuffer buffer, int nameID, int offset, int size)
            => GlobalConstants(nameID, buffer?.Storage, offset, size);
        public void SetGlobalConstantBuffer(GraphicsBuffer buffer, string name, int offset, int size)
            => GlobalConstants(Shader.PropertyToID(name), buffer?.Storage, offset, size);
        /// <summary>On Direct3D 11 the sampler alone says whether a read compares.</summary>
        public void SetShadowSamplingMode(RenderTargetIdentifier shadowmap, ShadowSamplingMode mode) { }

        public void SetGlobalTexture(int nameID, RenderTargetIdentifier value) => SetGlobalTexture(nameID, value, RenderTextureSubElement.Default);
        public void SetGlobalTexture(string name, RenderTargetIdentifier value) => SetGlobalTexture(Shader.PropertyToID(name), value);
        public void SetGlobalTexture(string name, RenderTargetIdentifier value, RenderTextureSubElement element)
            => SetGlobalTexture(Shader.PropertyToID(name), value, element);

        public void SetGlobalTexture(int nameID, RenderTargetIdentifier value, RenderTextureSubElement element)
        {
            int target = AddTarget(value);
            ref Command c = ref Add(Op.GlobalTexture);
            (c.A, c.B, c.C) = (nameID, target, (int)element);
        }

        void GlobalBuffer(int id, BufferStorage buffer)
        {
            ref Command c = ref Add(Op.GlobalBuffer);
            (c.A, c.Object) = (id, buffer);
        }

        void GlobalConstants(int id, BufferStorage buffer, int offset, int size)
        {
            ref Command c = ref Add(Op.GlobalConstantBuffer);
            (c.A, c.B, c.C, c.Object) = (id, offset, size, buffer);
        }

        // ---- keywords

        public void EnableShaderKeyword(string keyword) => GlobalKeyword(keyword, true);
        public void DisableShaderKeyword(string keyword) => GlobalKeyword(keyword, false);
        public void EnableKeyword(in GlobalKeyword keyword) => GlobalKeyword(keyword.name, true);
        public void DisableKeyword(in GlobalKeyword keyword) => GlobalKeyword(keyword.name, false);
        public void SetKeyword(in GlobalKeyword keyword, bool value) => GlobalKeyword(keyword.name, value);
        public void EnableKeyword(Material material, in LocalKeyword keyword) => SetKeyword(material, keyword, true);
        public void DisableKeyword(Material material, in LocalKeyword keyword) => SetKeyword(material, keyword, false);

        public void SetKeyword(Material material, in LocalKeyword keyword, bool value)
        {
            if (!KeywordUnion.Belongs(keyword, NotNull(material, "material", "SetKeyword").shader.Keywords))
                return;
            ref Command c = ref Add(Op.MaterialKeyword);
            (c.Subject, c.Object, c.Flag) = (material, keyword.name, value);
        }

        void GlobalKeyword(string keyword, bool value)
        {
            ref Command c = ref Add(Op.GlobalKeyword);
            (c.Object, c.Flag) = (keyword, value);
        }
    }
}
