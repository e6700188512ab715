using System;
using System.IO;
using System.Text;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Reference
{
    /// <summary>The scene's sky as Cycles takes it: drawn by the host around the camera, stored by latitude and longitude, linear.</summary>
    static class SkyPicture
    {
        const int Face = 256, Width = 1024, Height = 512;

        // Directions of the six cameras: forward and up.
        static readonly (Vector3 Forward, Vector3 Up)[] faces =
        {
            (Vector3.right, Vector3.up), (Vector3.left, Vector3.up), (Vector3.up, Vector3.back), (Vector3.down, Vector3.forward),
            (Vector3.forward, Vector3.up), (Vector3.back, Vector3.up),
        };

        /// <summary>Draws it without the sun's disk, which is a light there. The camera is put back.</summary>
        /// <param name="file">A Radiance .hdr file.</param>
        public static void Write(Camera like, string file)
        {
            var pixels = new Color[faces.Length][];
            var target = new RenderTexture(Face, Face, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            Camera camera = new GameObject("Sky Camera").AddComponent<Camera>();
            (camera.cullingMask, camera.fieldOfView, camera.targetTexture, camera.enabled) = (0, 90f, target, false);
            (camera.clearFlags, camera.backgroundColor, camera.farClipPlane) = (like.clearFlags, like.backgroundColor, 1000f);
            Material sky = RenderSettings.skybox;
            Material plain = sky == null ? null : new Material(sky);
            plain?.SetFloat("_SunDisk", 0f);
            RenderSettings.skybox = plain;
            try
            {
                for (int i = 0; i < faces.Length; i++)
                {
                    camera.transform.rotation = Quaternion.LookRotation(faces[i].Forward, faces[i].Up);
                    camera.Render();
                    UnityEngine.Rendering.AsyncGPUReadbackRequest request = UnityEngine.Rendering.AsyncGPUReadback.Request(target);
                    request.WaitForCompletion();
                    pixels[i] = request.GetData<Color>().ToArray();
                }
            }
            finally
            {
                RenderSettings.skybox = sky;
                UnityEngine.Object.DestroyImmediate(plain);
                UnityEngine.Object.DestroyImmediate(camera.gameObject);
                target.Release();
                UnityEngine.Object.DestroyImmediate(target);
            }
            WriteRadiance(file, Width, Height, (x, y) => Seen(pixels, DirectionOf(x, y)));
        }

        // Looks up like Cycles: across, 1/2 - atan2(y, x) / 2 pi of Blender's axes, whose y is Unity's z.
        internal static Vector3 DirectionOf(int x, int y)
        {
            double longitude = Math.PI * (1.0 - 2.0 * (x + 0.5) / Width), latitude = Math.PI * (0.5 - (y + 0.5) / Height);
            return new Vector3((float)(Math.Cos(longitude) * Math.Cos(latitude)), (float)Math.Sin(latitude),
                (float)(Math.Sin(longitude) * Math.Cos(latitude)));
        }

        static Color Seen(Color[][] pixels, Vector3 direction)
        {
            for (int i = 0; i < faces.Length; i++)
            {
                float ahead = Vector3.Dot(direction, faces[i].Forward);
                Vector3 right = Vector3.Cross(faces[i].Up, faces[i].Forward);
                float x = Vector3.Dot(direction, right) / ahead, y = Vector3.Dot(direction, faces[i].Up) / ahead;
                if (ahead > 0f && Math.Abs(x) <= 1.0001f && Math.Abs(y) <= 1.0001f)
                    return pixels[i][Texel(y) * Face + Texel(x)];
            }
            throw new InvalidOperationException($"no face of the sky holds {direction}");
        }

        static int Texel(float at) => Math.Clamp((int)((at * 0.5f + 0.5f) * Face), 0, Face - 1);

        // Ward's shared exponent, not packed; the top row first.
        static void WriteRadiance(string file, int width, int height, Func<int, int, Color> colorAt)
        {
            using var stream = File.Create(file);
            stream.Write(Encoding.ASCII.GetBytes($"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n"));
            var texel = new byte[4];
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                {
                    Color color = colorAt(x, y);
                    float most = Math.Max(color.r, Math.Max(color.g, color.b));
                    Array.Clear(texel);
                    if (most > 1e-32f)
                    {
                        int exponent = Math.ILogB(most) + 1;
                        double scale = Math.ScaleB(256.0, -exponent);
                        (texel[0], texel[1], texel[2], texel[3]) = ((byte)(Math.Max(color.r, 0f) * scale), (byte)(Math.Max(color.g, 0f) * scale),
                            (byte)(Math.Max(color.b, 0f) * scale), (byte)(exponent + 128));
                    }
                    stream.Write(texel);
                }
        }
    }
}
