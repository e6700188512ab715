using System.Collections;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Still water in a box around the origin, drawn by a <see cref="FluidSurface"/> that mirrors nothing, under a
    /// camera that looks straight down. It is off until a test turns it on.</summary>
    sealed class WaterScene
    {
        public const float Spacing = 0.05f, Depth = 0.6f;       // m
        public static readonly float3 Left = new float3(0.2f, 0.5f, 0.8f);      // of white light after 0.5 m, linear

        public readonly GameObject Root = new GameObject("Fluid");
        public readonly FluidSimulation Fluid;
        public readonly FluidSurface Surface;
        public readonly Camera Camera;
        public readonly RenderTexture Target;

        readonly List<Object> kept = new List<Object>();
        readonly List<RenderTexture> targets = new List<RenderTexture>();
        readonly (bool, FogMode, Color, float, float, float) fogBefore = (RenderSettings.fog, RenderSettings.fogMode, RenderSettings.fogColor,
            RenderSettings.fogDensity, RenderSettings.fogStartDistance, RenderSettings.fogEndDistance);

        /// <param name="pixels">Width and height of the picture.</param>
        public WaterScene(int pixels) : this(pixels, Vector3.one, Depth, 8000) { }

        /// <param name="pixels">Width and height of the picture.</param>
        /// <param name="box">m.</param>
        /// <param name="depth">Of the water above the floor of the box, m.</param>
        public WaterScene(int pixels, Vector3 box, float depth, int capacity)
        {
            Target = NewTarget(pixels, pixels);
            Camera = NewCamera(Target, new Vector3(0f, 3f, 0f));

            Keep(Root).SetActive(false);
            Fluid = Root.AddComponent<FluidSimulation>();
            Fluid.Configure(box, Spacing, capacity);
            Fluid.StatisticsInterval = 0;
            FluidVolume volume = NewChild<FluidVolume>("Water");
            volume.transform.localPosition = new Vector3(0f, 0.5f * (depth - box.y), 0f);
            volume.Size = new Vector3(box.x, depth, box.z);
            Surface = Root.AddComponent<FluidSurface>();
            Surface.ReflectionStrength = 0f;
            Surface.Ripples = 0f;
            Surface.Look = Absorbing(Left, 0.5f);
        }

        /// <summary>A look that absorbs and does not scatter.</summary>
        /// <param name="left">Of white light, linear.</param>
        /// <param name="depth">After that much water, m.</param>
        public static SurfaceLook Absorbing(float3 left, float depth)
        {
            SurfaceLook look = SurfaceLook.Water;
            look.scatteringDepth = 0f;
            look.colorAtDepth = Encoded(left);
            look.colorDepth = depth;
            return look;
        }

        /// <summary>Encodes a color for a field: fields are in sRGB, and the project calculates in linear or in gamma space.</summary>
        public static Color Encoded(float3 linear)
        {
            var color = new Color(linear.x, linear.y, linear.z);
            return QualitySettings.activeColorSpace == ColorSpace.Linear ? color.gamma : color;
        }

        /// <summary>Lights the surface alone, at a height of 0.6; off for all else.</summary>
        public Light AddSun()
        {
            Light sun = NewChild<Light>("Sun");
            sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.8f, -0.6f, 0f));
            sun.enabled = false;
            return Surface.Sun = sun;
        }

        /// <summary>Gives the particles phases; the fluid has to have tags.</summary>
        /// <param name="phaseOf">By the position, m from the lowest corner of the box, and the particle's index.</param>
        public void SetPhases(System.Func<float3, int, int> phaseOf)
        {
            PbfSolver solver = Fluid.Solver;
            var positions = new float4[solver.Positions.count];
            solver.Positions.GetData(positions);
            var tags = new uint[solver.Tags.count];
            for (int i = 0; i < tags.Length; i++)
                tags[i] = (uint)phaseOf(positions[i].xyz * Spacing, i) << 24;
            solver.Tags.SetData(tags);
        }

        /// <summary>On an object beside the water, as part of the fluid.</summary>
        public T NewChild<T>(string name) where T : Component
        {
            var child = new GameObject(name);
            child.transform.SetParent(Root.transform, false);
            return child.AddComponent<T>();
        }

        public RenderTexture NewTarget(int width, int height)
        {
            var target = new RenderTexture(width, height, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            targets.Add(target);
            return target;
        }

        /// <summary>Without perspective, before white.</summary>
        public Camera NewCamera(RenderTexture target, Vector3 from)
        {
            var camera = Keep(new GameObject("Camera")).AddComponent<Camera>();
            Look(camera, from);
            camera.orthographic = true;
            camera.orthographicSize = 0.3f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.white;
            camera.allowHDR = true;
            camera.targetTexture = target;
            return camera;
        }

        /// <summary>At the origin.</summary>
        public static void Look(Camera camera, Vector3 from)
        {
            camera.transform.position = from;
            camera.transform.LookAt(Vector3.zero, from.y > 1f ? Vector3.forward : Vector3.up);
        }

        /// <param name="color">Linear; without light and in no depth texture.</param>
        public GameObject NewUnlit(PrimitiveType type, float3 color)
        {
            var material = Keep(new Material(Shader.Find("Unlit/Color")));
            material.color = Encoded(color);
            return NewPrimitive(type, material);
        }

        /// <param name="color">Linear; without light, and in depth textures.</param>
        public GameObject NewSolid(PrimitiveType type, float3 color)
        {
            var material = Keep(new Material(Shader.Find("Rill/Solid")));
            material.SetColor("_Color", Encoded(color));
            material.SetColor("_Ambient", Color.white);
            return NewPrimitive(type, material);
        }

        /// <summary>Adds a floor under the box, without light: rays that are bent a little end on it, and not far beyond the picture.</summary>
        public void AddFloor(float3 color)
        {
            GameObject floor = NewSolid(PrimitiveType.Quad, color);
            floor.transform.rotation = Quaternion.LookRotation(Vector3.down);
            floor.transform.position = new Vector3(0f, -0.52f, 0f);
            floor.transform.localScale = new Vector3(8f, 8f, 1f);
        }

        public GameObject NewPrimitive(PrimitiveType type, Material material)
        {
            GameObject primitive = Keep(GameObject.CreatePrimitive(type));
            primitive.GetComponent<MeshRenderer>().sharedMaterial = material;
            return primitive;
        }

        /// <summary>Is destroyed with the scene.</summary>
        public T Keep<T>(T one) where T : Object
        {
            kept.Add(one);
            return one;
        }

        /// <summary>Plays the water and then stops it, so that all pictures from here on are of the same water.</summary>
        public IEnumerator Settle(int frames = 20)
        {
            Time.captureDeltaTime = 1f / 60f;
            Root.SetActive(true);
            yield return Frames(frames);
            Fluid.Paused = true;
            yield return Frames(2);
        }

        public static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }

        /// <summary>Row by row from the bottom.</summary>
        public float4[] Pixels() => Pixels(Target);

        /// <summary>Row by row from the bottom.</summary>
        public static float4[] Pixels(RenderTexture texture)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            return request.GetData<float4>().ToArray();
        }

        /// <summary>The pixel that far right of and above the center of the picture, m.</summary>
        public float3 At(float right, float up = 0f)
        {
            int x = (int)((right / Camera.orthographicSize * 0.5f + 0.5f) * Target.width),
                y = (int)((up / Camera.orthographicSize * 0.5f + 0.5f) * Target.height);
            return Pixels()[y * Target.width + x].xyz;
        }

        /// <summary>Mean of the center of the picture, a quarter of it.</summary>
        public Color Mean() => Mean(Target);

        public Color Mean(int left, int right, int bottom, int top) => Mean(Target, left, right, bottom, top);

        public static Color Mean(RenderTexture texture)
            => Mean(texture, texture.width / 4, 3 * texture.width / 4, texture.height / 4, 3 * texture.height / 4);

        public static Color Mean(RenderTexture texture, int left, int right, int bottom, int top)
        {
            float4[] pixels = Pixels(texture);
            float4 sum = 0f;
            for (int y = bottom; y < top; y++)
                for (int x = left; x < right; x++)
                    sum += pixels[y * texture.width + x];
            sum /= (right - left) * (top - bottom);
            return new Color(sum.x, sum.y, sum.z, 1f);
        }

        /// <summary>Leaves nothing behind.</summary>
        public IEnumerator End()
        {
            (RenderSettings.fog, RenderSettings.fogMode, RenderSettings.fogColor, RenderSettings.fogDensity, RenderSettings.fogStartDistance,
                RenderSettings.fogEndDistance) = fogBefore;
            Time.captureDeltaTime = 0f;
            foreach (Object one in kept)
                Object.Destroy(one);
            yield return null;
            foreach (RenderTexture target in targets)
                target.Release();
        }
    }
}
