using UnityEngine.Headless;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>Values for light and size that URP gives to shaders (names: URP 17.1.0, ShaderLibrary/Input.hlsl; for 14 only the names are
    /// known).</summary>
    internal static class UniversalVariables
    {
        static readonly int
            mainLightPosition = Id("_MainLightPosition"), mainLightColor = Id("_MainLightColor"),
            builtInPosition = Id("_WorldSpaceLightPos0"), builtInColor = Id("_LightColor0"),
            scaledScreen = Id("_ScaledScreenParams"), screenSize = Id("_ScreenSize"),
            environment = Id("_GlossyEnvironmentCubeMap"), environmentHdr = Id("_GlossyEnvironmentCubeMap_HDR"),
                builtInCube = Id("unity_SpecCube0"), builtInHdr = Id("unity_SpecCube0_HDR"),
            environmentColor = Id("_GlossyEnvironmentColor");

        static readonly System.Action<QueuedDraw> probes = draw => ObjectProbes.Bind(draw, universal: true);

        static int Id(string name) => Shader.PropertyToID(name);

        /// <summary>SetPerCameraShaderVariables: these two follow the render scale, _ScreenParams does not.</summary>
        public static void SetSize(int width, int height)
        {
            Shader.SetGlobalVector(scaledScreen, new Vector4(width, height, 1 + 1f / width, 1 + 1f / height));
            Shader.SetGlobalVector(screenSize, new Vector4(width, height, 1f / width, 1f / height));
        }

        public static void SetLighting()
        {
            BuiltinVariables.SetSun();
            EnvironmentLighting.Update();
            BuiltinVariables.SetAmbient();
            Shader.SetGlobalVector(mainLightPosition, Shader.GetGlobalVector(builtInPosition));
            Shader.SetGlobalVector(mainLightColor, Shader.GetGlobalVector(builtInColor));
            // Used by the Built-in pipeline alone.
            Shader.SetGlobalVector(builtInPosition, Vector4.zero);
            Shader.SetGlobalVector(builtInColor, Vector4.zero);
            // SetupPerCameraShaderConstants: ReflectionProbe.defaultTexture, which is the sky's cube here.
            EnvironmentLighting.Bind();
            Shader.SetGlobalTexture(environment, Shader.GetGlobalTexture(builtInCube));
            Shader.SetGlobalVector(environmentHdr, Shader.GetGlobalVector(builtInHdr));
            EnvironmentLighting.Unbind();
            Shader.SetGlobalVector(environmentColor, Shader.GetGlobalVector("unity_AmbientSky"));
        }

        /// <summary>Draws what was culled, with the reflection that each draw has of its own.</summary>
        public static void DrawCulled(bool opaque, System.Func<string, bool> wanted, System.Func<QueuedDraw, bool> ofDraws = null)
        {
            EnvironmentLighting.Bind();
            FrameRenderer.DrawCulled(opaque, wanted, ofDraws, probes);
            ObjectProbes.Unbind();
            EnvironmentLighting.Unbind();
        }
    }
}
