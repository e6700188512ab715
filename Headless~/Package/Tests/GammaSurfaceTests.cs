using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>In projects in gamma space the water follows the same formulas, in the numbers of the colors. FluidSurfaceTests has them
    /// in linear space.</summary>
    public class GammaSurfaceTests : PipelineSurfaceFixture
    {
        const float Depth = 0.6f, Bottom = -0.5f;
        const int Size = 64;

        bool linearBefore;
        RenderTexture picture;
        FluidSurface surface;

        [SetUp]
        public void Make()
        {
            linearBefore = Player.LinearColorSpace;
            Player.LinearColorSpace = false;
            Build(null, null);
            foreach (MeshRenderer floor in Object.FindObjectsOfType<MeshRenderer>())
                Object.DestroyImmediate(floor.gameObject);
            Object.DestroyImmediate(Object.FindObjectOfType<Light>().gameObject);

            GameObject fluid = simulation.gameObject;
            fluid.SetActive(false);
            simulation.Configure(Vector3.one, 0.05f, 8000);
            Object.DestroyImmediate(fluid.GetComponent<FluidVolume>());
            FluidVolume volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(fluid.transform, false);
            volume.transform.localPosition = new Vector3(0f, Bottom + 0.5f * Depth, 0f);
            volume.Size = new Vector3(1f, Depth, 1f);
            surface = fluid.GetComponent<FluidSurface>();
            surface.ReflectionStrength = 0f;
            SurfaceLook look = SurfaceLook.Water;
            look.scatteringDepth = 0f;
            look.roughness = 0f;
            look.colorAtDepth = Color.white;
            look.colorDepth = 0.5f;
            surface.Look = look;

            picture = new RenderTexture(Size, Size, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            camera.targetTexture = picture;
            camera.orthographic = true;
            camera.orthographicSize = 0.3f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.white;
            camera.allowHDR = true;
        }

        [TearDown]
        public void Release()
        {
            camera.targetTexture = null;
            picture.Release();
            Player.LinearColorSpace = linearBefore;
        }

        [Test]
        public void Light_is_absorbed_on_its_way_through()
        {
            SurfaceLook dark = surface.Look;
            dark.colorAtDepth = new Color(0.2f, 0.5f, 0.8f);
            surface.Look = dark;
            Look(new Vector3(0f, 3f, 0f), Vector3.zero, Vector3.forward);
            Vector4 seen = Mean(16, 48, 16, 48);
            for (int channel = 0; channel < 3; channel++)
            {
                float expected = 0.9596f * Mathf.Pow(dark.colorAtDepth[channel], Depth / 0.5f);
                TestContext.WriteLine($"seen {seen[channel]:0.0000}, Beer and Lambert {expected:0.0000}");
                Assert.That(seen[channel], Is.EqualTo(expected).Within(0.03f * expected));
            }
        }

        [Test]
        public void It_mirrors_as_much_as_Fresnels_equations_say([Values(0f, 50f, 65f)] float degrees)
        {
            // Opaque: nothing is seen but what its surface mirrors.
            SurfaceLook opaque = surface.Look;
            (opaque.colorAtDepth, opaque.colorDepth) = (Color.black, 0.02f);
            surface.Look = opaque;
            var white = new Cubemap(2, TextureFormat.RGBAHalf, false);
            for (CubemapFace face = CubemapFace.PositiveX; face <= CubemapFace.NegativeZ; face++)
                white.SetPixels(new[] { Color.white, Color.white, Color.white, Color.white }, face);
            white.Apply();
            surface.Reflection = white;
            surface.ReflectionStrength = 1f;
            camera.backgroundColor = Color.black;
            camera.orthographicSize = 0.1f;
            var top = new Vector3(0f, Bottom + Depth, 0f);
            Look(top + Quaternion.Euler(-degrees, 0f, 0f) * (3f * Vector3.up), top, Vector3.forward);
            float seen = Mean(16, 48, 16, 48).y, expected = Fresnel(degrees);
            surface.Reflection = null;
            Object.DestroyImmediate(white);
            TestContext.WriteLine($"seen {seen:0.00000}, Fresnel {expected:0.00000}");
            Assert.That(seen, Is.EqualTo(expected).Within(0.03f * expected));
        }

        [Test]
        public void The_floor_is_seen_as_far_aside_as_Snell_bends_it()
        {
            const float entry = -0.25f;
            const int rows = 7;
            float slope = Mathf.Tan(Mathf.Asin(Mathf.Sqrt(0.5f) / surface.Look.refractionIndex)), edge = entry + Depth * slope;
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Quad);
            floor.transform.rotation = Quaternion.LookRotation(Vector3.down);
            floor.transform.position = new Vector3(0f, Bottom, edge + 2f);
            floor.transform.localScale = new Vector3(4f, 4f, 1f);
            var material = new Material(Shader.Find("Unlit/Color")) { color = Color.black };
            floor.GetComponent<MeshRenderer>().sharedMaterial = material;
            Look(new Vector3(0f, Bottom + Depth + 2f, entry - 2f), new Vector3(0f, Bottom + Depth, entry), Vector3.up);
            int center = Size / 2;
            float white = Mean(24, 40, center - rows - 2, center - rows).y, black = Mean(24, 40, center + rows, center + rows + 2).y;
            float found = (Mean(24, 40, center - rows, center + rows).y - black) / (white - black);
            float pixel = 2f * camera.orthographicSize / Size, along = (found - 0.5f) * 2f * rows * pixel * Mathf.Sqrt(2f);      // on the water, m
            Object.DestroyImmediate(material);
            TestContext.WriteLine($"{along / (Depth * (1f - slope)):0.000} of the offset too far");
            Assert.That(white - black, Is.GreaterThan(0.8f));
            Assert.That(along, Is.EqualTo(0f).Within(0.03f * Depth * (1f - slope)));
        }

        // Reflectance of water for light without polarization.
        static float Fresnel(float degrees)
        {
            float cosine = Mathf.Cos(degrees * Mathf.Deg2Rad), within = Mathf.Sqrt(1f - (1f - cosine * cosine) / (1.333f * 1.333f));
            float across = (cosine - 1.333f * within) / (cosine + 1.333f * within), along = (1.333f * cosine - within) / (1.333f * cosine + within);
            return 0.5f * (across * across + along * along);
        }

        void Look(Vector3 from, Vector3 at, Vector3 up)
        {
            camera.transform.position = from;
            camera.transform.LookAt(at, up);
            simulation.gameObject.SetActive(true);
            Play(20);
            Assert.That(Errors, Is.Empty);
        }

        Vector4 Mean(int left, int right, int bottom, int top)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(picture);
            request.WaitForCompletion();
            var pixels = request.GetData<Vector4>();
            Vector4 sum = Vector4.zero;
            for (int y = bottom; y < top; y++)
                for (int x = left; x < right; x++)
                    sum += pixels[y * Size + x];
            return sum / ((right - left) * (top - bottom));
        }
    }
}
