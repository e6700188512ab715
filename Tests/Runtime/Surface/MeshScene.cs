using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Water of a known shape in a box around the origin, drawn by the water's own shader; the camera sees what a test adds.</summary>
    sealed class MeshScene : IDisposable
    {
        public readonly Camera Camera;
        public readonly RenderTexture Target;
        public readonly FluidSimulation Fluid;
        public readonly FluidSurface Surface;

        readonly List<Object> kept = new List<Object>();
        readonly float spacing;
        readonly Vector3 size;
        ShapeMesh mesh;

        /// <param name="pixels">Width and height of the picture.</param>
        /// <param name="box">m.</param>
        /// <param name="spacing">m.</param>
        /// <param name="around">What is mirrored and lies beyond the scene, linear.</param>
        public MeshScene(int pixels, Vector3 box, float spacing, float around)
        {
            this.spacing = spacing;
            size = box / spacing;
            Target = new RenderTexture(pixels, pixels, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            Camera = Keep(new GameObject("Camera")).AddComponent<Camera>();
            Camera.nearClipPlane = 0.1f;
            Camera.farClipPlane = 100f;
            Camera.allowHDR = true;
            Camera.clearFlags = CameraClearFlags.SolidColor;
            Camera.backgroundColor = Encoded(around);
            Camera.targetTexture = Target;

            GameObject root = Keep(new GameObject("Fluid"));
            root.SetActive(false);
            Fluid = root.AddComponent<FluidSimulation>();
            Fluid.Configure(box, spacing, 64);
            Fluid.StatisticsInterval = 0;
            Surface = root.AddComponent<FluidSurface>();
            Surface.CastShadows = ShadowCastingMode.Off;
            Surface.Look = Clear;
            Surface.Ripples = 0f;
            Surface.Reflection = Around(around);
            Light sun = Keep(new GameObject("Sun")).AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.intensity = 0f;
            sun.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            Surface.Sun = sun;
        }

        /// <summary>Makes a scene for a pool whose floor is not seen, by a camera straight above without perspective.</summary>
        /// <param name="half">Half the height of the picture, m.</param>
        public static MeshScene FromAbove(int pixels, float spacing, float half)
        {
            var scene = new MeshScene(pixels, Vector3.one, spacing, 0f);
            scene.Camera.orthographic = true;
            scene.Camera.orthographicSize = half;
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, 0.4f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
            SurfaceLook look = WaterScene.Absorbing(1e-4f, 0.01f);
            look.roughness = 0f;
            scene.Surface.Look = look;
            scene.Surface.Caustics = false;
            return scene;
        }

        /// <summary>Returns the correlation of two square pictures with a mean of 0, where the second is so many pixels to the right.</summary>
        public static float Likeness(float[] before, float[] after, int shift)
        {
            int width = (int)math.round(math.sqrt(before.Length));
            float both = 0f, squares = 0f, others = 0f;
            for (int i = 0; i < before.Length; i++)
            {
                int x = i % width + shift;
                if (x < 0 || x >= width)
                    continue;
                float a = before[i], b = after[i + shift];
                both += a * b;
                squares += a * a;
                others += b * b;
            }
            return both / math.sqrt(squares * others);
        }

        public static SurfaceLook Clear
        {
            get
            {
                SurfaceLook look = SurfaceLook.Water;
                look.colorAtDepth = Color.white;
                look.scatteringDepth = 0f;
                look.roughness = 0f;
                return look;
            }
        }

        /// <summary>Puts water there instead of the old, from the next frame on.</summary>
        /// <param name="shape">Of a point of the world, m: the distance to the surface, m, above 0 in water.</param>
        /// <param name="displacement">Of all of it in the last substep, d.</param>
        /// <param name="lag">Substeps.</param>
        public void Put(Func<float3, float> shape, float cell = 0.75f, Vector3 displacement = default, float lag = 0f)
        {
            float3 low = -0.5f * size;
            Surface.Mesh = null;
            mesh?.Dispose();
            mesh = new ShapeMesh(size, p => shape((p + low) * spacing) / spacing, cell, displacement);
            Surface.Mesh = mesh.Frame(Matrix4x4.Scale(Vector3.one * spacing) * Matrix4x4.Translate(low), spacing, lag);
            Fluid.gameObject.SetActive(true);
        }

        /// <summary>A part of the opaque scene, unlit, in the depth texture as well.</summary>
        public GameObject Add(PrimitiveType type, float3 color, Vector3 position, Quaternion rotation, Vector3 scale)
        {
            GameObject part = Keep(GameObject.CreatePrimitive(type));
            part.transform.SetPositionAndRotation(position, rotation);
            part.transform.localScale = scale;
            part.GetComponent<MeshRenderer>().sharedMaterial = Unlit(color);
            return part;
        }

        /// <summary>Squares in two colors in a plane that is seen from the left-handed side of its axes, with a corner at its origin.</summary>
        public void AddBoard(Vector3 origin, Vector3 right, Vector3 up, float square, int half, float3 even, float3 odd)
        {
            for (int parity = 0; parity < 2; parity++)
            {
                var corners = new List<Vector3>();
                var triangles = new List<int>();
                for (int y = -half; y < half; y++)
                    for (int x = -half; x < half; x++)
                    {
                        if ((x + y & 1) != parity)
                            continue;
                        int first = corners.Count;
                        for (int i = 0; i < 4; i++)
                            corners.Add(origin + (x + (i & 1)) * square * right + (y + (i >> 1)) * square * up);
                        triangles.AddRange(new[] { first, first + 2, first + 3, first, first + 3, first + 1 });
                    }
                var board = Keep(new Mesh());
                board.indexFormat = IndexFormat.UInt32;
                board.SetVertices(corners);
                board.SetTriangles(triangles, 0);
                board.RecalculateNormals();
                GameObject part = Keep(new GameObject("Board"));
                part.AddComponent<MeshFilter>().sharedMesh = board;
                part.AddComponent<MeshRenderer>().sharedMaterial = Unlit(parity == 0 ? even : odd);
            }
        }

        /// <summary>Linear, row by row from the bottom; each the mean of a square of so many pixels.</summary>
        public float3[] Pixels(int square = 1)
        {
            float4[] pixels = WaterScene.Pixels(Target);
            int across = Target.width / square;
            var means = new float3[across * across];
            for (int i = 0; i < across * square * across * square; i++)
                means[i / (across * square) / square * across + i % (across * square) / square] +=
                    pixels[i / (across * square) * Target.width + i % (across * square)].xyz / (square * square);
            return means;
        }

        /// <summary>Converts to what a screen shows (IEC 61966-2-1).</summary>
        public static double Srgb(double linear)
        {
            double value = Math.Min(Math.Max(linear, 0.0), 1.0);
            return value <= 0.0031308 ? 12.92 * value : 1.055 * Math.Pow(value, 1.0 / 2.4) - 0.055;
        }

        /// <summary>Writes a square picture to look at, where the environment names a folder for them.</summary>
        /// <param name="pixels">Linear, row by row from the bottom.</param>
        public static void Save(string name, float3[] pixels)
        {
            string folder = Environment.GetEnvironmentVariable("RILL_PICTURES");
            if (string.IsNullOrEmpty(folder))
                return;
            int width = (int)math.round(math.sqrt(pixels.Length));
            var bytes = new List<byte>(Encoding.ASCII.GetBytes(Invariant($"P6 {width} {width} 255\n")));       // a PPM has its rows from the top
            for (int i = 0; i < pixels.Length; i++)
            {
                float3 pixel = pixels[(width - 1 - i / width) * width + i % width];
                for (int channel = 0; channel < 3; channel++)
                    bytes.Add((byte)Math.Round(255.0 * Srgb(pixel[channel])));
            }
            File.WriteAllBytes(Path.Combine(folder, name + ".ppm"), bytes.ToArray());
        }

        public void Dispose()
        {
            Surface.Mesh = null;
            foreach (Object one in kept)
                Object.DestroyImmediate(one);
            mesh?.Dispose();
            Target.Release();
        }

        public T Keep<T>(T one) where T : Object
        {
            kept.Add(one);
            return one;
        }

        static Color Encoded(float linear) => WaterScene.Encoded(linear);

        Material Unlit(float3 linear)
        {
            Material material = Keep(new Material(Shader.Find("Rill/Solid")));
            material.SetColor("_Color", WaterScene.Encoded(linear));
            material.SetColor("_Ambient", Color.white);
            return material;
        }

        // Cube map with one value on all sides.
        Cubemap Around(float linear)
        {
            var cube = Keep(new Cubemap(4, TextureFormat.RGBAHalf, false));
            var face = new Color[16];
            for (int i = 0; i < face.Length; i++)
                face[i] = new Color(linear, linear, linear, 1f);
            for (int i = 0; i < 6; i++)
                cube.SetPixels(face, (CubemapFace)i);
            cube.Apply();
            return cube;
        }
    }
}
