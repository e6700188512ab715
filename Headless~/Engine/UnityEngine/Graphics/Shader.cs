using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class Shader : Object
    {
        /// <summary>Values of SetGlobal*, seen by every program that finds none nearer.</summary>
        internal static readonly PropertyTable Globals = new PropertyTable();

        readonly ShaderSource source;
        readonly Dictionary<int, ShaderProperty> properties = new Dictionary<int, ShaderProperty>();
        internal readonly KeywordSpace Keywords;

        Shader(ShaderSource source)
        {
            this.source = source;
            name = source.Name;
            Keywords = new KeywordSpace(source.Name, source.Keywords);
            foreach (ShaderProperty property in source.Properties)
                properties[PropertyToID(property.Name)] = property;
        }

        internal static Shader Create(ShaderSource source) => new Shader(source);
        internal ShaderSource Source => source;

        /// <summary>"white", "black" ... as the property declares it; what it declares nothing for is gray.</summary>
        internal string DefaultTextureName(int id) =>
            properties.TryGetValue(id, out ShaderProperty property) && !string.IsNullOrEmpty(property.DefaultTexture)
            ? property.DefaultTexture : "gray";

        public static Shader Find(string name) => Player.Assets != null ? Player.Assets.FindShader(name) : BuiltinResources.FindShader?.Invoke(name);
        public static int PropertyToID(string name) => PropertyNames.ToId(name);

        bool soughtFallback;
        Shader fallback;

        /// <summary>A pass by its number; the one after the last is the ShadowCaster pass of the fallback.</summary>
        internal ShaderPassSource PassAt(int pass) => pass < source.Passes.Count ? source.Passes[pass] : FallbackCaster;

        /// <summary>Pass that casts the shadow if no pass of this shader does; null for none.</summary>
        internal ShaderPassSource FallbackCaster => Fallback is null ? null : Fallback.OwnCaster ?? Fallback.FallbackCaster;

        ShaderPassSource OwnCaster
        {
            get
            {
                foreach (ShaderPassSource pass in source.Passes)
                    if (pass.Tags.TryGetValue("LightMode", out string mode)
                        && string.Equals(mode, ShadowCasters.Mode, StringComparison.OrdinalIgnoreCase))
                        return pass;
                return null;
            }
        }

        Shader Fallback
        {
            get
            {
                if (soughtFallback)
                    return fallback;
                soughtFallback = true;
                if (source.Fallback.Length == 0)
                    return null;
                fallback = Find(source.Fallback);
                if (ReferenceEquals(fallback, this))
                    fallback = null;
                else if (fallback is null)
                    Debug.LogWarning($"Shader '{name}': fallback shader '{source.Fallback}' not found; without a ShadowCaster pass of " +
                        $"its own it casts no shadow and is not in the camera's depth texture");
                return fallback;
            }
        }

        public bool isSupported => source.Passes.Count > 0;
        public int renderQueue => source.RenderQueue;
        public int passCount => source.Passes.Count;
        public int subshaderCount => 1;
        public int maximumLOD { get; set; } = -1;
        public static int globalMaximumLOD { get; set; } = int.MaxValue;
        public static string globalRenderPipeline { get; set; } = "";
        public static void WarmupAllShaders() { }

        public int GetPassCountInSubshader(int subshaderIndex) => source.Passes.Count;
        public ShaderTagId FindPassTagValue(int passIndex, ShaderTagId tagName) =>
            source.Passes[passIndex].Tags.TryGetValue(tagName.name, out string value) ? new ShaderTagId(value) : ShaderTagId.none;

        // ---- properties

        public int GetPropertyCount() => source.Properties.Count;
        public string GetPropertyName(int propertyIndex) => source.Properties[propertyIndex].Name;
        public int GetPropertyNameId(int propertyIndex) => PropertyToID(source.Properties[propertyIndex].Name);
        public string GetPropertyDescription(int propertyIndex) => source.Properties[propertyIndex].Description;
        public string GetPropertyTextureDefaultName(int propertyIndex) => source.Properties[propertyIndex].DefaultTexture;
        public float GetPropertyDefaultFloatValue(int propertyIndex) => Default(propertyIndex, 0);
        public int GetPropertyDefaultIntValue(int propertyIndex) => (int)Default(propertyIndex, 0);
        public Vector4 GetPropertyDefaultVectorValue(int propertyIndex) =>
            new Vector4(Default(propertyIndex, 0), Default(propertyIndex, 1), Default(propertyIndex, 2), Default(propertyIndex, 3));

        public int FindPropertyIndex(string propertyName)
        {
            for (int i = 0; i < source.Properties.Count; i++)
                if (source.Properties[i].Name == propertyName)
                    return i;
            return -1;
        }

        public ShaderPropertyType GetPropertyType(int propertyIndex)
        {
            switch (source.Properties[propertyIndex].Kind)
            {
                case ShaderPropertyKind.Color: return ShaderPropertyType.Color;
                case ShaderPropertyKind.Vector: return ShaderPropertyType.Vector;
                case ShaderPropertyKind.Float: return ShaderPropertyType.Float;
                case ShaderPropertyKind.Range: return ShaderPropertyType.Range;
                case ShaderPropertyKind.Int: return ShaderPropertyType.Int;
                default: return ShaderPropertyType.Texture;
            }
        }

        float Default(int property, int component)
        {
            float[] values = source.Properties[property].Default;
            return component < values.Length ? values[component] : 0;
        }

        // ---- keywords

        public LocalKeywordSpace keywordSpace => new LocalKeywordSpace(Keywords);
        public static GlobalKeyword[] globalKeywords => GlobalKeywords.Known.ConvertAll(n => new GlobalKeyword(n)).ToArray();
        public static GlobalKeyword[] enabledGlobalKeywords => Array.ConvertAll(GlobalKeywords.Set.ToArray(), n => new GlobalKeyword(n));
        public static void EnableKeyword(string keyword) => SetGlobalKeyword(keyword, true);
        public static void DisableKeyword(string keyword) => SetGlobalKeyword(keyword, false);
        public static bool IsKeywordEnabled(string keyword) => GlobalKeywords.Set.Has(keyword);
        public static void EnableKeyword(in GlobalKeyword keyword) => SetGlobalKeyword(keyword.name, true);
        public static void DisableKeyword(in GlobalKeyword keyword) => SetGlobalKeyword(keyword.name, false);
        public static void SetKeyword(in GlobalKeyword keyword, bool value) => SetGlobalKeyword(keyword.name, value);
        public static bool IsKeywordEnabled(in GlobalKeyword keyword) => GlobalKeywords.Set.Has(keyword.name);

        internal static void SetGlobalKeyword(string keyword, bool value)
        {
            GlobalKeywords.Create(keyword);
            GlobalKeywords.Set.Set(keyword, value);
        }

        // ---- globals; SetGlobalInt stores a float, as Unity does

        public static void SetGlobalFloat(int nameID, float value) => Globals.SetFloat(nameID, value);
        public static void SetGlobalFloat(string name, float value) => SetGlobalFloat(PropertyToID(name), value);
        public static void SetGlobalInt(int nameID, int value) => Globals.SetFloat(nameID, value);
        public static void SetGlobalInt(string name, int value) => SetGlobalInt(PropertyToID(name), value);
        public static void SetGlobalInteger(int nameID, int value) => Globals.SetInt(nameID, value);
        public static void SetGlobalInteger(string name, int value) => SetGlobalInteger(PropertyToID(name), value);
        public static void SetGlobalVector(int nameID, Vector4 value) => Globals.SetVector(nameID, value);
        public static void SetGlobalVector(string name, Vector4 value) => SetGlobalVector(PropertyToID(name), value);
        public static void SetGlobalColor(int nameID, Color value) => Globals.SetColor(nameID, value);
        public static void SetGlobalColor(string name, Color value) => SetGlobalColor(PropertyToID(name), value);
        public static void SetGlobalMatrix(int nameID, Matrix4x4 value) => Globals.SetMatrix(nameID, value);
        public static void SetGlobalMatrix(string name, Matrix4x4 value) => SetGlobalMatrix(PropertyToID(name), value);
        public static void SetGlobalFloatArray(int nameID, float[] values)
            => Globals.SetArray(nameID, PropertyKind.Float, values, values?.Length ?? 0);
        public static void SetGlobalFloatArray(string name, float[] values) => SetGlobalFloatArray(PropertyToID(name), values);
        public static void SetGlobalFloatArray(int nameID, List<float> values) => Globals.SetArray(nameID, PropertyKind.Float, values);
        public static void SetGlobalFloatArray(string name, List<float> values) => SetGlobalFloatArray(PropertyToID(name), values);
        public static void SetGlobalVectorArray(int nameID, Vector4[] values)
            => Globals.SetArray(nameID, PropertyKind.Vector, values, values?.Length ?? 0);
        public static void SetGlobalVectorArray(string name, Vector4[] values) => SetGlobalVectorArray(PropertyToID(name), values);
        public static void SetGlobalVectorArray(int nameID, List<Vector4> values) => Globals.SetArray(nameID, PropertyKind.Vector, values);
        public static void SetGlobalVectorArray(string name, List<Vector4> values) => SetGlobalVectorArray(PropertyToID(name), values);
        public static void SetGlobalMatrixArray(int nameID, Matrix4x4[] values)
            => Globals.SetArray(nameID, PropertyKind.Matrix, values, values?.Length ?? 0);
        public static void SetGlobalMatrixArray(string name, Matrix4x4[] values) => SetGlobalMatrixArray(PropertyToID(name), values);
        public static void SetGlobalMatrixArray(int nameID, List<Matrix4x4> values) => Globals.SetArray(nameID, PropertyKind.Matrix, values);
        public static void SetGlobalMatrixArray(string name, List<Matrix4x4> values) => SetGlobalMatrixArray(PropertyToID(name), values);
        public static void SetGlobalTexture(int nameID, Texture value) => Globals.SetTexture(nameID, value);
        public static void SetGlobalTexture(string name, Texture value) => SetGlobalTexture(PropertyToID(name), value);
        public static void SetGlobalTexture(int nameID, RenderTexture value, RenderTextureSubElement element)
            => Globals.SetTexture(nameID, value, element);
        public static void SetGlobalTexture(string name, RenderTexture value, RenderTextureSubElement element)
            => SetGlobalTexture(PropertyToID(name), value, element);
        public static void SetGlobalBuffer(int nameID, ComputeBuffer value) => Globals.SetBuffer(nameID, value?.Storage);
        public static void SetGlobalBuffer(string name, ComputeBuffer value) => SetGlobalBuffer(PropertyToID(name), value);
        public static void SetGlobalBuffer(int nameID, GraphicsBuffer value) => Globals.SetBuffer(nameID, value?.Storage);
        public static void SetGlobalBuffer(string name, GraphicsBuffer value) => SetGlobalBuffer(PropertyToID(name), value);
        public static void SetGlobalConstantBuffer(int nameID, ComputeBuffer value, int offset, int size)
            => Globals.SetConstantBuffer(nameID, value?.Storage, offset, size);
        public static void SetGlobalConstantBuffer(string name, ComputeBuffer value, int offset, int size)
            => SetGlobalConstantBuffer(PropertyToID(name), value, offset, size);
        public static void SetGlobalConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size)
            => Globals.SetConstantBuffer(nameID, value?.Storage, offset, size);
        public static void SetGlobalConstantBuffer(string name, GraphicsBuffer value, int offset, int size)
            => SetGlobalConstantBuffer(PropertyToID(name), value, offset, size);

        public static float GetGlobalFloat(int nameID) => Globals.GetFloat(nameID);
        public static float GetGlobalFloat(string name) => GetGlobalFloat(PropertyToID(name));
        public static int GetGlobalInt(int nameID) => Globals.GetInt(nameID);
        public static int GetGlobalInt(string name) => GetGlobalInt(PropertyToID(name));
        public static int GetGlobalInteger(int nameID) => Globals.GetInt(nameID);
        public static int GetGlobalInteger(string name) => GetGlobalInteger(PropertyToID(name));
        public static Vector4 GetGlobalVector(int nameID) => Globals.GetVector(nameID);
        public static Vector4 GetGlobalVector(string name) => GetGlobalVector(PropertyToID(name));
        public static Color GetGlobalColor(int nameID) => Globals.GetColor(nameID);
        public static Color GetGlobalColor(string name) => GetGlobalColor(PropertyToID(name));
        public static Matrix4x4 GetGlobalMatrix(int nameID) => Globals.GetMatrix(nameID);
        public static Matrix4x4 GetGlobalMatrix(string name) => GetGlobalMatrix(PropertyToID(name));
        public static Texture GetGlobalTexture(int nameID) => Globals.GetTexture(nameID);
        public static Texture GetGlobalTexture(string name) => GetGlobalTexture(PropertyToID(name));
        public static float[] GetGlobalFloatArray(int nameID) => Globals.GetArray<float>(nameID);
        public static float[] GetGlobalFloatArray(string name) => GetGlobalFloatArray(PropertyToID(name));
        public static void GetGlobalFloatArray(int nameID, List<float> values) => Globals.GetArray(nameID, values);
        public static void GetGlobalFloatArray(string name, List<float> values) => GetGlobalFloatArray(PropertyToID(name), values);
        public static Vector4[] GetGlobalVectorArray(int nameID) => Globals.GetArray<Vector4>(nameID);
        public static Vector4[] GetGlobalVectorArray(string name) => GetGlobalVectorArray(PropertyToID(name));
        public static void GetGlobalVectorArray(int nameID, List<Vector4> values) => Globals.GetArray(nameID, values);
        public static void GetGlobalVectorArray(string name, List<Vector4> values) => GetGlobalVectorArray(PropertyToID(name), values);
        public static Matrix4x4[] GetGlobalMatrixArray(int nameID) => Globals.GetArray<Matrix4x4>(nameID);
        public static Matrix4x4[] GetGlobalMatrixArray(string name) => GetGlobalMatrixArray(PropertyToID(name));
        public static void GetGlobalMatrixArray(int nameID, List<Matrix4x4> values) => Globals.GetArray(nameID, values);
        public static void GetGlobalMatrixArray(string name, List<Matrix4x4> values) => GetGlobalMatrixArray(PropertyToID(name), values);
    }
}
