using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>
    /// The light of the sky: its reflection as a cube (unity_SpecCube0), the rougher the smaller its mips, and its ambient light as
    /// harmonics. Made once, as Unity bakes it with a scene, and again when DynamicGI.UpdateEnvironment asks for it.
    /// </summary>
    internal static class EnvironmentLighting
    {
        const string FilterShader = "Hidden/Headless/FilterReflection";
        const int RoughnessSteps = 6;       // UNITY_SPECCUBE_LOD_STEPS
        const float Near = 0.1f, Far = 100;

        static readonly int
            cubeId = Shader.PropertyToID("unity_SpecCube0"), decodeId = Shader.PropertyToID("unity_SpecCube0_HDR"),
            sourceId = Shader.PropertyToID("_Source"),
            faceId = Shader.PropertyToID("_Face"), sizeId = Shader.PropertyToID("_Size"), roughnessId = Shader.PropertyToID("_Roughness"),
                samplesId = Shader.PropertyToID("_Samples"),
            cameraPosition = Shader.PropertyToID("_WorldSpaceCameraPos");

        // Axes to the right, downwards and outwards on each face, in the order of CubemapFace.
        static readonly Vector3[]
            right = { Vector3.back, Vector3.forward, Vector3.right, Vector3.right, Vector3.right, Vector3.left },
            down = { Vector3.down, Vector3.down, Vector3.forward, Vector3.back, Vector3.down, Vector3.down },
            outwards = { Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back };

        static RenderTexture sky, reflection;
        static Material filter;
        static bool isCurrent;

        /// <summary>Light of the sky: nine coefficients of what a white surface reflects of it, a color each; null without a sky.</summary>
        public static Vector3[] Harmonics { get; private set; }

        /// <summary>It is made again before the next camera draws.</summary>
        public static void Invalidate() => isCurrent = false;

        /// <summary>Leaves the target and the matrices to be set again; the sun's variables are set.</summary>
        public static void Update()
        {
            if (isCurrent)
                return;
            isCurrent = true;
            Harmonics = null;
            Release();
            if (RenderSettings.skybox == null || !(BuiltinResources.FindShader?.Invoke(FilterShader) is Shader shader))
                return;
            filter = filter != null ? filter : new Material(shader) { hideFlags = HideFlags.HideAndDontSave };
            int size = Mathf.Clamp(RenderSettings.defaultReflectionResolution, 16, 2048);
            sky = Cube("Sky", size, 1);
            reflection = Cube("Sky reflection", size, 1 + (int)Math.Floor(Math.Log(size, 2)));
            DrawSky(size);
            Harmonics = Project(size);
            Filter(size);
            Object.DestroyImmediate(sky, true);
            sky = null;
        }

        /// <summary>For the draws of a camera; in between, unity_SpecCube0 belongs to none.</summary>
        public static void Bind()
        {
            Shader.Globals.SetTexture(cubeId, DefaultCube);
            Shader.Globals.SetVector(decodeId, DefaultDecode);
        }

        public static Texture DefaultCube
        {
            get
            {
                Texture texture = RenderSettings.defaultReflectionMode == DefaultReflectionMode.Custom ? RenderSettings.customReflectionTexture
                    : reflection;
                return texture == null ? BuiltinTextures.Named("black", DeviceTextureDimension.Cube) : texture;
            }
        }

        // Stored as it is: only the intensity is to be applied.
        public static Vector4 DefaultDecode => new Vector4(RenderSettings.reflectionIntensity, 1, 0, 0);

        public static void Unbind() => Shader.Globals.SetTexture(cubeId, null);

        static RenderTexture Cube(string name, int size, int mips)
        {
            var cube = new RenderTexture(new RenderTextureDescriptor(size, size, GraphicsFormat.R16G16B16A16_SFloat, GraphicsFormat.None, mips)
            {
                dimension = TextureDimension.Cube, useMipMap = mips > 1, autoGenerateMips = false,
            })
            {
                name = name, filterMode = FilterMode.Trilinear, IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave,
            };
            cube.Create();
            return cube;
        }

        static void DrawSky(int size)
        {
            bool culling = RenderState.InvertCulling;
            RenderState.InvertCulling = true;       // a face is seen from within, as a mirror image of a camera's picture
            Shader.Globals.SetVector(cameraPosition, Vector4.zero);
            for (int face = 0; face < 6; face++)
            {
                RenderState.SetTarget(sky, 0, face);
                RenderState.Clear(false, true, Color.black, 1);
                Matrix4x4 view = Matrix4x4.identity;
                view.SetRow(0, right[face]);
                view.SetRow(1, down[face]);
                view.SetRow(2, -outwards[face]);
                BuiltinVariables.SetViewProjection(view, Matrix4x4.Perspective(90, 1, Near, Far));
                Sky.Draw(Vector3.zero, Far);
            }
            RenderState.InvertCulling = culling;
        }

        static void Filter(int size)
        {
            for (int mip = 0; mip < reflection.mipmapCount; mip++)
            {
                // Perceptual roughness of a mip: mip / steps = r (1.7 - 0.7 r).
                float step = Math.Min(1, (float)mip / RoughnessSteps), perceptual = (1.7f - Mathf.Sqrt(1.7f * 1.7f - 2.8f * step)) / 1.4f;
                filter.SetTexture(sourceId, sky);
                filter.SetFloat(sizeId, Math.Max(1, size >> mip));
                filter.SetFloat(roughnessId, perceptual * perceptual);
                filter.SetFloat(samplesId, mip == 0 ? 1 : Math.Min(1024, 16 << 2 * mip));
                for (int face = 0; face < 6; face++)
                {
                    filter.SetFloat(faceId, face);
                    RenderState.SetTarget(reflection, mip, face);
                    Drawing.DrawPass(new DrawCall { Call = "sky reflection", Material = filter, Matrix = Matrix4x4.identity,
                        Topology = MeshTopology.Triangles, Count = 3, Instances = 1 }, 0);
                }
            }
        }

        // Radiance by solid angle, then smoothed by the cosine: a sky of one color gives that color.
        static Vector3[] Project(int size)
        {
            Gpu.ClosePass();
            var sums = new Vector3[9];
            var basis = new float[9];
            float weights = 0;
            for (int face = 0; face < 6; face++)
            {
                byte[] texels = Gpu.Device.ReadTexture(sky.GetDevice(RenderTextureSubElement.Color), 0, face);
                for (int y = 0; y < size; y++)
                    for (int x = 0; x < size; x++)
                    {
                        float s = (x + 0.5f) / size * 2 - 1, t = (y + 0.5f) / size * 2 - 1;
                        Vector3 d = outwards[face] + s * right[face] + t * down[face];
                        float square = d.sqrMagnitude, weight = 1 / (square * Mathf.Sqrt(square));
                        Evaluate(d / Mathf.Sqrt(square), basis);
                        int at = (y * size + x) * 8;
                        var radiance = new Vector3(Half(texels, at), Half(texels, at + 2), Half(texels, at + 4)) * weight;
                        weights += weight;
                        for (int i = 0; i < 9; i++)
                            sums[i] += radiance * basis[i];
                    }
            }
            float scale = 4 * Mathf.PI / weights;
            for (int i = 0; i < 9; i++)
                sums[i] *= scale * (i == 0 ? 1 : i < 4 ? 2f / 3 : 1f / 4);
            return sums;
        }

        static float Half(byte[] texels, int at) => Mathf.HalfToFloat((ushort)(texels[at] | texels[at + 1] << 8));

        /// <summary>The real harmonics, in the order of bands: 1; y, z, x; xy, yz, zz, zx, xx - yy.</summary>
        static void Evaluate(Vector3 d, float[] basis)
        {
            basis[0] = 0.282095f;
            (basis[1], basis[2], basis[3]) = (0.488603f * d.y, 0.488603f * d.z, 0.488603f * d.x);
            (basis[4], basis[5], basis[6]) = (1.092548f * d.x * d.y, 1.092548f * d.y * d.z, 0.315392f * (3 * d.z * d.z - 1));
            (basis[7], basis[8]) = (1.092548f * d.z * d.x, 0.546274f * (d.x * d.x - d.y * d.y));
        }

        /// <summary>One color's harmonics as shaders take them: unity_SHA, unity_SHB and unity_SHC's component.</summary>
        public static void ShaderHarmonics(int color, float intensity, out Vector4 a, out Vector4 b, out float c)
        {
            float At(int i) => Harmonics[i][color] * intensity;
            a = new Vector4(0.488603f * At(3), 0.488603f * At(1), 0.488603f * At(2), 0.282095f * At(0) - 0.315392f * At(6));
            b = new Vector4(1.092548f * At(4), 1.092548f * At(5), 3 * 0.315392f * At(6), 1.092548f * At(7));
            c = 0.546274f * At(8);
        }

        static void Release()
        {
            foreach (RenderTexture texture in new[] { sky, reflection })
                if (texture is object)
                    Object.DestroyImmediate(texture, true);
            sky = reflection = null;
        }

        public static void Reset()
        {
            Release();
            if (filter is object)
                Object.DestroyImmediate(filter, true);
            filter = null;
            Harmonics = null;
            isCurrent = false;
        }
    }
}
