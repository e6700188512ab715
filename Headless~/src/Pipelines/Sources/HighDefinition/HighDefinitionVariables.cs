using System;
using UnityEngine.Headless;

namespace UnityEngine.Rendering.HighDefinition
{
    /// <summary>
    /// What HDRP tells shaders: the camera in one constant buffer, relative to its position; the light of the sky; the exposure. What HDRP does
    /// not set is not to be relied on: it is NaN here.
    /// </summary>
    /// <remarks>Names and order: ShaderVariablesGlobal.cs.hlsl of HDRP 14.0.8 and 17.0.3; what is relative: HDCamera.UpdateViewConstants.</remarks>
    internal sealed class HighDefinitionVariables : IDisposable
    {
        const int Bytes = 8192;

#if SRP_17
        const int Matrices = 12;
#else
        const int Matrices = 11;
#endif

        static readonly int globals = Shader.PropertyToID("ShaderVariablesGlobal"), sky = Shader.PropertyToID("_SkyTexture"), exposure = Shader.PropertyToID("_ExposureTexture");
        static readonly Matrix4x4 notSet = new Matrix4x4(Vector4.one * float.NaN, Vector4.one * float.NaN, Vector4.one * float.NaN, Vector4.one * float.NaN);

        readonly Vector4[] values = new Vector4[Bytes / 16];
        readonly GraphicsBuffer buffer = new GraphicsBuffer(GraphicsBuffer.Target.Constant, Bytes / 16, 16);
        readonly Texture2D exposureTexture = new Texture2D(1, 1, TextureFormat.RFloat, false, true) { name = "_ExposureTexture", hideFlags = HideFlags.HideAndDontSave };
        RenderTexture skyArray;

        public void SetCamera(Camera camera)
        {
            Matrix4x4 view = camera.worldToCameraMatrix, projection = GL.GetGPUProjectionMatrix(camera.projectionMatrix, renderIntoTexture: true);
            view.SetColumn(3, new Vector4(0, 0, 0, 1));
            Matrix4x4 both = projection * view;
            Array.Fill(values, Vector4.one * float.NaN);
            // View, of the camera, inverse; projection, inverse; both, of the camera, inverse; unjittered, in 17 its inverse; of the last frame, its inverse.
#if SRP_17
            Write(view, view, view.inverse, projection, projection.inverse, both, both, both.inverse, both, both.inverse, both, both.inverse);
#else
            Write(view, view, view.inverse, projection, projection.inverse, both, both, both.inverse, both, both, both.inverse);
#endif
            values[4 * Matrices] = values[4 * Matrices + 1] = camera.transform.position;
            buffer.SetData(values);
            Shader.SetGlobalConstantBuffer(globals, buffer, 0, Bytes);
        }

        void Write(params Matrix4x4[] matrices)
        {
            for (int i = 0; i < matrices.Length; i++)
                for (int column = 0; column < 4; column++)
                    values[4 * i + column] = matrices[i].GetColumn(column);
        }

        /// <summary>The sky's reflection as the first of an array of cubes, in the units of the color buffer over the exposure.</summary>
        public void SetLighting(float exposed)
        {
            BuiltinVariables.SetSun();
            EnvironmentLighting.Update();
            EnvironmentLighting.Bind();
            Texture cube = Shader.GetGlobalTexture("unity_SpecCube0");
            EnvironmentLighting.Unbind();
            if (skyArray == null || skyArray.width != cube.width || skyArray.graphicsFormat != cube.graphicsFormat || skyArray.mipmapCount != cube.mipmapCount)
            {
                Release();
                skyArray = new RenderTexture(new RenderTextureDescriptor(cube.width, cube.height, cube.graphicsFormat, Experimental.Rendering.GraphicsFormat.None, cube.mipmapCount)
                {
                    dimension = TextureDimension.CubeArray, volumeDepth = 6, useMipMap = cube.mipmapCount > 1, autoGenerateMips = false,
                })
                { name = "_SkyTexture", filterMode = FilterMode.Trilinear, hideFlags = HideFlags.HideAndDontSave };
                skyArray.Create();
            }
            Graphics.CopyTexture(cube, skyArray);
            Shader.SetGlobalTexture(sky, skyArray);
            exposureTexture.SetPixelData(new[] { exposed }, 0);
            exposureTexture.Apply(false);
            Shader.SetGlobalTexture(exposure, exposureTexture);
        }

        /// <summary>What the other pipelines set one by one is not there.</summary>
        public static void WithholdLoose()
        {
            BuiltinVariables.SetViewProjection(notSet, notSet);
            Shader.SetGlobalVector("_WorldSpaceCameraPos", notSet.GetColumn(0));
            Shader.SetGlobalVector("_ProjectionParams", notSet.GetColumn(0));
            Shader.SetGlobalVector("_WorldSpaceLightPos0", notSet.GetColumn(0));
            Shader.SetGlobalVector("_LightColor0", notSet.GetColumn(0));
        }

        void Release()
        {
            if (skyArray != null)
                Object.DestroyImmediate(skyArray, true);
            skyArray = null;
        }

        public void Dispose()
        {
            Release();
            Object.DestroyImmediate(exposureTexture, true);
            buffer.Dispose();
        }
    }
}
