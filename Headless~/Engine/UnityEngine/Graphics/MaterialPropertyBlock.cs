using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class MaterialPropertyBlock
    {
        internal readonly PropertyTable Values = new PropertyTable();

        public bool isEmpty => Values.IsEmpty;
        public void Clear() => Values.Clear();

        // SetInt stores a float, as Unity does.

        public void SetFloat(int nameID, float value) => Values.SetFloat(nameID, value);
        public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);
        public void SetInt(int nameID, int value) => Values.SetFloat(nameID, value);
        public void SetInt(string name, int value) => SetInt(Shader.PropertyToID(name), value);
        public void SetInteger(int nameID, int value) => Values.SetInt(nameID, value);
        public void SetInteger(string name, int value) => SetInteger(Shader.PropertyToID(name), value);
        public void SetVector(int nameID, Vector4 value) => Values.SetVector(nameID, value);
        public void SetVector(string name, Vector4 value) => SetVector(Shader.PropertyToID(name), value);
        public void SetColor(int nameID, Color value) => Values.SetColor(nameID, value);
        public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);
        public void SetMatrix(int nameID, Matrix4x4 value) => Values.SetMatrix(nameID, value);
        public void SetMatrix(string name, Matrix4x4 value) => SetMatrix(Shader.PropertyToID(name), value);
        public void SetFloatArray(int nameID, float[] values) => Values.SetArray(nameID, PropertyKind.Float, values, values?.Length ?? 0);
        public void SetFloatArray(string name, float[] values) => SetFloatArray(Shader.PropertyToID(name), values);
        public void SetFloatArray(int nameID, List<float> values) => Values.SetArray(nameID, PropertyKind.Float, values);
        public void SetFloatArray(string name, List<float> values) => SetFloatArray(Shader.PropertyToID(name), values);
        public void SetVectorArray(int nameID, Vector4[] values) => Values.SetArray(nameID, PropertyKind.Vector, values, values?.Length ?? 0);
        public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(Shader.PropertyToID(name), values);
        public void SetVectorArray(int nameID, List<Vector4> values) => Values.SetArray(nameID, PropertyKind.Vector, values);
        public void SetVectorArray(string name, List<Vector4> values) => SetVectorArray(Shader.PropertyToID(name), values);
        public void SetMatrixArray(int nameID, Matrix4x4[] values) => Values.SetArray(nameID, PropertyKind.Matrix, values, values?.Length ?? 0);
        public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(Shader.PropertyToID(name), values);
        public void SetMatrixArray(int nameID, List<Matrix4x4> values) => Values.SetArray(nameID, PropertyKind.Matrix, values);
        public void SetMatrixArray(string name, List<Matrix4x4> values) => SetMatrixArray(Shader.PropertyToID(name), values);
        public void SetTexture(int nameID, Texture value) => Values.SetTexture(nameID, value);
        public void SetTexture(string name, Texture value) => SetTexture(Shader.PropertyToID(name), value);
        public void SetTexture(int nameID, RenderTexture value, RenderTextureSubElement element) => Values.SetTexture(nameID, value, element);
        public void SetTexture(string name, RenderTexture value, RenderTextureSubElement element)
            => SetTexture(Shader.PropertyToID(name), value, element);
        public void SetBuffer(int nameID, ComputeBuffer value) => Values.SetBuffer(nameID, value?.Storage);
        public void SetBuffer(string name, ComputeBuffer value) => SetBuffer(Shader.PropertyToID(name), value);
        public void SetBuffer(int nameID, GraphicsBuffer value) => Values.SetBuffer(nameID, value?.Storage);
        public void SetBuffer(string name, GraphicsBuffer value) => SetBuffer(Shader.PropertyToID(name), value);
        public void SetConstantBuffer(int nameID, ComputeBuffer value, int offset, int size)
            => Values.SetConstantBuffer(nameID, value?.Storage, offset, size);
        public void SetConstantBuffer(string name, ComputeBuffer value, int offset, int size)
            => SetConstantBuffer(Shader.PropertyToID(name), value, offset, size);
        public void SetConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size)
            => Values.SetConstantBuffer(nameID, value?.Storage, offset, size);
        public void SetConstantBuffer(string name, GraphicsBuffer value, int offset, int size)
            => SetConstantBuffer(Shader.PropertyToID(name), value, offset, size);

        public float GetFloat(int nameID) => Values.GetFloat(nameID);
        public float GetFloat(string name) => GetFloat(Shader.PropertyToID(name));
        public int GetInt(int nameID) => Values.GetInt(nameID);
        public int GetInt(string name) => GetInt(Shader.PropertyToID(name));
        public int GetInteger(int nameID) => Values.GetInt(nameID);
        public int GetInteger(string name) => GetInteger(Shader.PropertyToID(name));
        public Vector4 GetVector(int nameID) => Values.GetVector(nameID);
        public Vector4 GetVector(string name) => GetVector(Shader.PropertyToID(name));
        public Color GetColor(int nameID) => Values.GetColor(nameID);
        public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));
        public Matrix4x4 GetMatrix(int nameID) => Values.GetMatrix(nameID);
        public Matrix4x4 GetMatrix(string name) => GetMatrix(Shader.PropertyToID(name));
        public Texture GetTexture(int nameID) => Values.GetTexture(nameID);
        public Texture GetTexture(string name) => GetTexture(Shader.PropertyToID(name));
        public float[] GetFloatArray(int nameID) => Values.GetArray<float>(nameID);
        public float[] GetFloatArray(string name) => GetFloatArray(Shader.PropertyToID(name));
        public void GetFloatArray(int nameID, List<float> values) => Values.GetArray(nameID, values);
        public void GetFloatArray(string name, List<float> values) => GetFloatArray(Shader.PropertyToID(name), values);
        public Vector4[] GetVectorArray(int nameID) => Values.GetArray<Vector4>(nameID);
        public Vector4[] GetVectorArray(string name) => GetVectorArray(Shader.PropertyToID(name));
        public void GetVectorArray(int nameID, List<Vector4> values) => Values.GetArray(nameID, values);
        public void GetVectorArray(string name, List<Vector4> values) => GetVectorArray(Shader.PropertyToID(name), values);
        public Matrix4x4[] GetMatrixArray(int nameID) => Values.GetArray<Matrix4x4>(nameID);
        public Matrix4x4[] GetMatrixArray(string name) => GetMatrixArray(Shader.PropertyToID(name));
        public void GetMatrixArray(int nameID, List<Matrix4x4> values) => Values.GetArray(nameID, values);
        public void GetMatrixArray(string name, List<Matrix4x4> values) => GetMatrixArray(Shader.PropertyToID(name), values);

        public bool HasProperty(int nameID) => Values.Has(nameID);
        public bool HasProperty(string name) => HasProperty(Shader.PropertyToID(name));
        public bool HasFloat(int nameID) => Values.HasValue(nameID, PropertyKind.Float);
        public bool HasFloat(string name) => HasFloat(Shader.PropertyToID(name));
        public bool HasInt(int nameID) => Values.HasValue(nameID, PropertyKind.Float);
        public bool HasInt(string name) => HasInt(Shader.PropertyToID(name));
        public bool HasInteger(int nameID) => Values.HasValue(nameID, PropertyKind.Int);
        public bool HasInteger(string name) => HasInteger(Shader.PropertyToID(name));
        public bool HasVector(int nameID) => Values.HasValue(nameID, PropertyKind.Vector);
        public bool HasVector(string name) => HasVector(Shader.PropertyToID(name));
        public bool HasColor(int nameID) => Values.HasValue(nameID, PropertyKind.Vector);
        public bool HasColor(string name) => HasColor(Shader.PropertyToID(name));
        public bool HasMatrix(int nameID) => Values.HasValue(nameID, PropertyKind.Matrix);
        public bool HasMatrix(string name) => HasMatrix(Shader.PropertyToID(name));
        public bool HasTexture(int nameID) => Values.HasTexture(nameID);
        public bool HasTexture(string name) => HasTexture(Shader.PropertyToID(name));
        public bool HasBuffer(int nameID) => Values.HasBuffer(nameID);
        public bool HasBuffer(string name) => HasBuffer(Shader.PropertyToID(name));
        public bool HasConstantBuffer(int nameID) => Values.HasConstantBuffer(nameID);
        public bool HasConstantBuffer(string name) => HasConstantBuffer(Shader.PropertyToID(name));
    }
}
