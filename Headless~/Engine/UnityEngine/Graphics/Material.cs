using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public class Material : Object
    {
        internal readonly PropertyTable Values = new PropertyTable();
        readonly KeywordSet keywords = new KeywordSet();
        readonly HashSet<string> disabledPasses = new HashSet<string>();
        readonly Dictionary<string, string> overrideTags = new Dictionary<string, string>();
        Shader currentShader;
        int queueOverride = -1;
        Program[] programs = Array.Empty<Program>();

        struct Program
        {
            public ProgramLayout Vertex, Fragment;
            public int KeywordVersion, GlobalVersion;
            public bool Ready;
        }

        public Material(Shader shader)
        {
            if (shader == null)
                throw new ArgumentNullException(nameof(shader),
                    "A material needs a shader; Shader.Find gives null for a name that the project does not have.");
            this.shader = shader;
            name = shader.name;
        }

        public Material(Material source)
        {
            if (source == null)
                throw new ArgumentNullException(nameof(source));
            shader = source.shader;
            name = source.name;
            CopyPropertiesFromMaterial(source);
        }

        public Shader shader
        {
            get => currentShader;
            set
            {
                currentShader = value;
                // the last is the fallback's ShadowCaster
                programs = value == null ? Array.Empty<Program>() : new Program[(value.passCount + 1) * Instances.Modes];
                if (value != null)
                    AddDefaults();
            }
        }

        // Values already set stay when the shader changes, as in Unity.
        void AddDefaults()
        {
            foreach (ShaderProperty property in currentShader.Source.Properties)
            {
                int id = Shader.PropertyToID(property.Name);
                float[] d = property.Default;
                switch (property.Kind)
                {
                    case ShaderPropertyKind.Float:
                    case ShaderPropertyKind.Range:
                        if (!Values.Has(id))
                            Values.SetFloat(id, d.Length > 0 ? d[0] : 0);
                        break;
                    case ShaderPropertyKind.Int:
                        if (!Values.Has(id))
                            Values.SetInt(id, d.Length > 0 ? (int)d[0] : 0);
                        break;
                    case ShaderPropertyKind.Color:
                        if (!Values.Has(id))
                            Values.SetColor(id, d.Length > 3 ? new Color(d[0], d[1], d[2], d[3]) : Color.white);
                        break;
                    case ShaderPropertyKind.Vector:
                        if (!Values.Has(id))
                            Values.SetVector(id, d.Length > 3 ? new Vector4(d[0], d[1], d[2], d[3]) : Vector4.zero);
                        break;
                    default:
                        int scaleOffset = Shader.PropertyToID(property.Name + "_ST");
                        if (!Values.Has(scaleOffset))
                            Values.SetVector(scaleOffset, new Vector4(1, 1, 0, 0));
                        break;
                }
            }
        }

        // ---- passes

        public int passCount => currentShader.passCount;
        public string GetPassName(int pass) => currentShader.Source.Passes[pass].Name ?? "";

        public int FindPass(string passName)
        {
            for (int i = 0; i < passCount; i++)
                if (string.Equals(GetPassName(i), passName, StringComparison.OrdinalIgnoreCase))
                    return i;
            return -1;
        }

        public void SetShaderPassEnabled(string passName, bool enabled)
        {
            if (enabled)
                disabledPasses.Remove(passName);
            else
                disabledPasses.Add(passName);
        }

        public bool GetShaderPassEnabled(string passName) => !disabledPasses.Contains(passName);

        public string GetTag(string tag, bool searchFallbacks) => GetTag(tag, searchFallbacks, "");
        public string GetTag(string tag, bool searchFallbacks, string defaultValue)
        {
            if (overrideTags.TryGetValue(tag, out string value))
                return value;
            return passCount > 0 && currentShader.Source.Passes[0].Tags.TryGetValue(tag, out value) ? value : defaultValue;
        }

        public void SetOverrideTag(string tag, string val) => overrideTags[tag] = val;

        /// <summary>Makes a pass current for Graphics.DrawMeshNow and DrawProceduralNow.</summary>
        public bool SetPass(int pass)
        {
            if (pass < 0 || pass >= passCount)
            {
                GpuError.Report($"SetPass({pass}) on material '{name}': its shader '{currentShader.name}' has {passCount} passes.",
                    $"Trying to access pass {pass}, but material '{name}' subshader (0) has only {passCount} valid passes.");
                return false;
            }
            RenderState.CurrentMaterial = this;
            RenderState.CurrentPass = pass;
            return true;
        }

        /// <summary>The pass's programs for the keywords now enabled; false when they do not compile (reported once).</summary>
        internal bool Programs(int pass, Instancing instancing, out ProgramLayout vertex, out ProgramLayout fragment)
        {
            ref Program program = ref programs[pass * Instances.Modes + (int)instancing];
            if (!program.Ready || program.KeywordVersion != keywords.Version || program.GlobalVersion != GlobalKeywords.Set.Version)
            {
                program = new Program { Ready = true, KeywordVersion = keywords.Version, GlobalVersion = GlobalKeywords.Set.Version };
                try
                {
                    ICollection<string> enabled = KeywordUnion.Of(keywords, GlobalKeywords.Set, Instances.Keyword(instancing));
                    program.Vertex = ProgramLayout.Of(currentShader.PassAt(pass).Compile(ShaderStage.Vertex, enabled));
                    program.Fragment = ProgramLayout.Of(currentShader.PassAt(pass).Compile(ShaderStage.Fragment, enabled));
                }
                catch (ShaderCompileException error) when (!Player.Strict)
                {
                    Debug.LogError($"Shader error in '{currentShader.name}': {error.Message}");
                    program.Vertex = program.Fragment = null;
                }
            }
            vertex = program.Vertex;
            fragment = program.Fragment;
            return vertex != null && fragment != null;
        }

        // ---- state

        public int renderQueue { get => queueOverride >= 0 ? queueOverride : currentShader.renderQueue; set => queueOverride = value; }
        public bool enableInstancing { get; set; }
        public bool doubleSidedGI { get; set; }
        public MaterialGlobalIlluminationFlags globalIlluminationFlags { get; set; }
        public Color color { get => GetColor(mainColor); set => SetColor(mainColor, value); }
        public Texture mainTexture { get => GetTexture(mainTex); set => SetTexture(mainTex, value); }
        public Vector2 mainTextureOffset { get => GetTextureOffset(mainTex); set => SetTextureOffset(mainTex, value); }
        public Vector2 mainTextureScale { get => GetTextureScale(mainTex); set => SetTextureScale(mainTex, value); }

        static readonly int mainColor = Shader.PropertyToID("_Color"), mainTex = Shader.PropertyToID("_MainTex");

        static int ScaleOffsetId(int nameID) => Shader.PropertyToID(PropertyNames.ToName(nameID) + "_ST");
        Vector4 ScaleOffset(int nameID) => Values.TryGet(ScaleOffsetId(nameID), out PropertyValue _)
            ? Values.GetVector(ScaleOffsetId(nameID)) : new Vector4(1, 1, 0, 0);

        public Vector2 GetTextureOffset(int nameID) => new Vector2(ScaleOffset(nameID).z, ScaleOffset(nameID).w);
        public Vector2 GetTextureOffset(string name) => GetTextureOffset(Shader.PropertyToID(name));
        public Vector2 GetTextureScale(int nameID) => new Vector2(ScaleOffset(nameID).x, ScaleOffset(nameID).y);
        public Vector2 GetTextureScale(string name) => GetTextureScale(Shader.PropertyToID(name));
        public void SetTextureOffset(string name, Vector2 value) => SetTextureOffset(Shader.PropertyToID(name), value);
        public void SetTextureScale(string name, Vector2 value) => SetTextureScale(Shader.PropertyToID(name), value);

        public void SetTextureOffset(int nameID, Vector2 value)
        {
            Vector4 st = ScaleOffset(nameID);
            Values.SetVector(ScaleOffsetId(nameID), new Vector4(st.x, st.y, value.x, value.y));
        }

        public void SetTextureScale(int nameID, Vector2 value)
        {
            Vector4 st = ScaleOffset(nameID);
            Values.SetVector(ScaleOffsetId(nameID), new Vector4(value.x, value.y, st.z, st.w));
        }

        public void CopyPropertiesFromMaterial(Material mat)
        {
            if (mat == null)
                throw new ArgumentNullException(nameof(mat));
            Values.CopyFrom(mat.Values);
            keywords.Replace(mat.keywords.ToArray());
            queueOverride = mat.queueOverride;
            enableInstancing = mat.enableInstancing;
            disabledPasses.Clear();
            foreach (string pass in mat.disabledPasses)
                disabledPasses.Add(pass);
        }

        public string[] GetTexturePropertyNames()
        {
            var names = new List<string>();
            foreach (ShaderProperty property in currentShader.Source.Properties)
                if (property.Kind >= ShaderPropertyKind.Texture2D)
                    names.Add(property.Name);
            return names.ToArray();
        }

        // ---- keywords

        public string[] shaderKeywords { get => keywords.ToArray(); set => keywords.Replace(value ?? Array.Empty<string>()); }
        public LocalKeyword[] enabledKeywords
        {
            get => KeywordUnion.Local(currentShader.Keywords, keywords);
            set => keywords.Replace(Array.ConvertAll(value ?? Array.Empty<LocalKeyword>(), k => k.name));
        }

        public void EnableKeyword(string keyword) => keywords.Set(keyword, true);
        public void DisableKeyword(string keyword) => keywords.Set(keyword, false);
        public bool IsKeywordEnabled(string keyword) => keywords.Has(keyword);
        public void EnableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, true);
        public void DisableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, false);
        public bool IsKeywordEnabled(in LocalKeyword keyword) => keywords.Has(keyword.name);
        public void SetKeyword(in LocalKeyword keyword, bool value)
        {
            if (KeywordUnion.Belongs(keyword, currentShader.Keywords))
                keywords.Set(keyword.name, value);
        }

        // ---- values; SetInt stores a float, as Unity does

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
        public void SetColorArray(int nameID, Color[] values) => Values.SetArray(nameID, PropertyKind.Vector, Linear(values), values?.Length ?? 0);
        public void SetColorArray(string name, Color[] values) => SetColorArray(Shader.PropertyToID(name), values);
        public void SetColorArray(int nameID, List<Color> values)
            => Values.SetArray(nameID, PropertyKind.Vector, Linear(values?.ToArray()), values?.Count ?? 0);
        public void SetColorArray(string name, List<Color> values) => SetColorArray(Shader.PropertyToID(name), values);
        public Color[] GetColorArray(int nameID) => Gamma(Values.GetArray<Vector4>(nameID));
        public Color[] GetColorArray(string name) => GetColorArray(Shader.PropertyToID(name));

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

        static Vector4[] Linear(Color[] colors) =>
            colors == null ? null : Array.ConvertAll(colors, c => Player.LinearColorSpace ? (Vector4)c.linear : (Vector4)c);

        static Color[] Gamma(Vector4[] stored) =>
            stored == null ? null : Array.ConvertAll(stored, v => Player.LinearColorSpace ? ((Color)v).gamma : (Color)v);
    }
}
