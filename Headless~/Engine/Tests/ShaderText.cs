using System.Collections.Generic;
using System.IO;
using Host.Shaders;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Shaders and kernels from text that stands in a test, and what they compute.</summary>
    public abstract class ShaderTextFixture : GraphicsFixture
    {
        static readonly Dictionary<string, ShaderSource> shaders = new Dictionary<string, ShaderSource>();
        static readonly Dictionary<string, ComputeShaderSource> kernels = new Dictionary<string, ComputeShaderSource>();

        /// <summary>Sees 16 units in height around the origin, on blue.</summary>
        protected static Camera NewCamera()
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.orthographic = true;
            camera.orthographicSize = 8;
            camera.transform.position = new Vector3(0, 0, -5);
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.blue;
            return camera;
        }

        protected static Shader ShaderOf(string text)
        {
            if (!shaders.TryGetValue(text, out ShaderSource source))
                shaders.Add(text, source = Import(text, file => ShaderImporter.ImportShader(file, "Test.shader", _ => null, new ShaderCache())));
            return Shader.Create(source);
        }

        protected static ComputeShader ComputeOf(string text)
        {
            if (!kernels.TryGetValue(text, out ComputeShaderSource source))
                kernels.Add(text, source = Import(text, file => ShaderImporter.ImportCompute(file, "Test.compute", _ => null, new ShaderCache())));
            return ComputeShader.Create(source);
        }

        static T Import<T>(string text, System.Func<string, T> import)
        {
            string file = Path.GetTempFileName();
            File.WriteAllText(file, text);
            T source = import(file);
            File.Delete(file);
            return source;
        }

        /// <summary>A pass of an image effect over UnityCG.cginc's vert_img; the code declares "frag".</summary>
        protected static string Effect(string code, string properties = "_MainTex (\"Texture\", 2D) = \"white\" {}") =>
            $"Shader \"Hidden/Test\" {{ Properties {{ {properties} }} SubShader {{ Cull Off ZWrite Off ZTest Always Pass " +
            $"{{\nCGPROGRAM\n#pragma vertex vert_img\n#pragma fragment frag\n#include \"UnityCG.cginc\"\n{code}\nENDCG\n}} }} }}";

        /// <summary>Value of an expression of float4 in a fragment program, at the center of a picture of one pixel.</summary>
        protected static Vector4 Value(string expression, string declarations = "", Texture source = null)
        {
            var material = new Material(ShaderOf(Effect($"{declarations}\nfloat4 frag(v2f_img i) : SV_Target {{ return {expression}; }}")));
            var target = new RenderTexture(1, 1, 0, RenderTextureFormat.ARGBFloat);
            Graphics.Blit(source, target, material);
            Vector4 value = Read(target)[0];
            Object.DestroyImmediate(target);
            return value;
        }

        /// <summary>Texels of a render texture as they are stored, from the bottom row up.</summary>
        protected static Vector4[] Read(RenderTexture target)
        {
            RenderTexture before = RenderTexture.active;
            RenderTexture.active = target;
            var copy = new Texture2D(target.width, target.height, TextureFormat.RGBAFloat, false, true);
            copy.ReadPixels(new Rect(0, 0, target.width, target.height), 0, 0);
            RenderTexture.active = before;
            Vector4[] texels = System.Array.ConvertAll(copy.GetPixels(), c => (Vector4)c);
            Object.DestroyImmediate(copy);
            return texels;
        }

        protected static Color32 Pixel(int x, int y, RenderTexture target = null)
        {
            int width = target != null ? target.width : Player.ScreenWidth;
            byte[] picture = Screenshot.ReadRgba(target);
            int at = (y * width + x) * 4;
            return new Color32(picture[at], picture[at + 1], picture[at + 2], picture[at + 3]);
        }
    }
}
