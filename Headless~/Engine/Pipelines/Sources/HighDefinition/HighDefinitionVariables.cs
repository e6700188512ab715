using System;
using UnityEngine.Headless;

namespace UnityEngine.Rendering.HighDefinition
{
    /// <summary>
    /// Values that HDRP gives to shaders: the camera in one constant buffer, relative to its position, and two eyes in another, each relative to its
    /// own; the light of the sky; the exposure. What HDRP does
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

        static readonly int eyes = Shader.PropertyToID("ShaderVariablesXR"), globals = Shader.PropertyToID("ShaderVariablesGlobal"),
            sky = Shader.PropertyToID("_SkyTexture"), exposure = Shader.PropertyToID("_ExposureTexture");
        static readonly Matrix4x4 notSet = new Matrix4x4(Vector4.one * float.NaN, Vector4.one * float.NaN, Vector4.one * float.NaN,
            Vector4.one * float.NaN);

        static readonly Matrix4x4[] noEyes = { notSet, notSet };

        readonly Vector4[] values = new Vector4[Bytes / 16];
        readonly GraphicsBuffer buffer = new GraphicsBuffer(GraphicsBuffer.Target.Constant, Bytes / 16, 16),
            eyeBuffer = new GraphicsBuffer(GraphicsBuffer.Target.Constant, Bytes / 16, 16);
        readonly Texture2D exposureTexture = new Texture2D(1, 1, TextureFormat.RFloat, false, true) { name = "_ExposureTexture",
            hideFlags = HideFlags.HideAndDontSave };
        RenderTexture skyArray;

        public void SetCamera(HDCamera camera)
        {
            Array.Fill(values, Vector4.one * float.NaN);
            Matrix4x4[] main = MatricesOf(camera.main);
            for (int i = 0; i < main.Length; i++)
                Write(i, main[i]);
            values[4 * Matrices] = camera.main.position;
            values[4 * Matrices + 1] = camera.main.previousPosition;
            values[4 * Matrices + 2] = new Vector4(camera.actualWidth, camera.actualHeight, 1f / camera.actualWidth,
                1f / camera.actualHeight);      // _ScreenSize
            buffer.SetData(values);
            Shader.SetGlobalConstantBuffer(globals, buffer, 0, Bytes);

            // Each as an array of two; then three more matrices, and the positions.
            Array.Fill(values, Vector4.one * float.NaN);
            for (int eye = 0; eye < camera.xr.viewCount; eye++)
            {
                Matrix4x4[] ofEye = MatricesOf(camera.eyes[eye]);
                int count = 0;
                for (int i = 0; i < ofEye.Length; i++)
                    if (!isOfCamera[i])
                        Write(2 * count++ + eye, ofEye[i]);
                int positions = 4 * 2 * (count + 3);
                values[positions + eye] = camera.eyes[eye].position;
                values[positions + 2 + eye] = camera.eyes[eye].position - camera.main.position;
                values[positions + 4 + eye] = camera.eyes[eye].previousPosition;
            }
            eyeBuffer.SetData(values);
            Shader.SetGlobalConstantBuffer(eyes, eyeBuffer, 0, Bytes);
        }

        // Those below that eyes do not have.
        static readonly bool[] isOfCamera = { false, true, false, false, false, false, true, false, false, false, false, false };

        // View, of the camera, inverse; projection, inverse; both, of the camera, inverse; unjittered, in 17 its inverse; of the last
        // frame, its inverse.
        static Matrix4x4[] MatricesOf(ViewMatrices of) => new[]
        {
            of.view, of.view, of.view.inverse, of.projection, of.projection.inverse, of.both, of.both, of.both.inverse, of.steady,
#if SRP_17
            of.steady.inverse,
#endif
            of.previous, of.previous.inverse,
        };

        void Write(int index, in Matrix4x4 matrix)
        {
            for (int column = 0; column < 4; column++)
                values[4 * index + column] = matrix.GetColumn(column);
        }

        /// <summary>The sky's reflection as the first of an array of cubes, in the units of the color buffer over the exposure.</summary>
        public void SetLighting(float exposed)
        {
            BuiltinVariables.SetSun();
            EnvironmentLighting.Update();
            EnvironmentLighting.Bind();
            Texture cube = Shader.GetGlobalTexture("unity_SpecCube0");
            EnvironmentLighting.Unbind();
            if (skyArray == null || skyArray.width != cube.width || skyArray.graphicsFormat != cube.graphicsFormat
                || skyArray.mipmapCount != cube.mipmapCount)
            {
                Release();
                skyArray = new RenderTexture(new RenderTextureDescriptor(cube.width, cube.height, cube.graphicsFormat,
                    Experimental.Rendering.GraphicsFormat.None, cube.mipmapCount)
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

        /// <summary>Withholds what the other pipelines set one by one.</summary>
        public static void WithholdLoose()
        {
            BuiltinVariables.SetViewProjection(notSet, notSet);
            BuiltinVariables.SetStereo(noEyes, noEyes);
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
            eyeBuffer.Dispose();
        }
    }
}
