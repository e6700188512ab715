using System.Collections.Generic;
using System.IO;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The package's own shaders, pass by pass: one sphere of radius 0.5 over a floor, in the light of a sun overhead.</summary>
    public class RenderPassTests : GraphicsFixture
    {
        const int Width = 96, Height = 64;
        const float Radius = 0.5f;
        static readonly Vector3 Center = new Vector3(0, 1, 0), Corner = Vector3.one * 32;     // the origin of the world in the domain

        readonly List<GraphicsBuffer> buffers = new List<GraphicsBuffer>();
        MaterialPropertyBlock block;
        RenderTexture target;
        Camera camera;
        Light sun;
        MeshRenderer floor;

        [SetUp]
        public void Make()
        {
            block = new MaterialPropertyBlock();
            Positions(Center, Center);
            block.SetFloat("_ParticleRadius", Radius);
            block.SetFloat("_ParticleSpacing", 1);
            block.SetMatrix("_DomainToWorld", Matrix4x4.Translate(-Corner));
            block.SetMatrix("_LastDomainToWorld", Matrix4x4.Translate(-Corner));
            block.SetVector("_DrawnDomainSize", new Vector4(100, 100, 100, 0));
            foreach (string color in new[] { "_SlowColor", "_MiddleColor", "_FastColor" })
                block.SetVector(color, new Vector4(0, 0, 1, 1));
            block.SetVector("_AmbientColor", new Vector4(0.2f, 0.2f, 0.2f, 1));
            block.SetFloat("_ReceiveShadows", 1);

            target = new RenderTexture(Width, Height, UnityEngine.Experimental.Rendering.GraphicsFormat.R32G32B32A32_SFloat, UnityEngine.Experimental.Rendering.GraphicsFormat.D32_SFloat);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0, 3, -6);
            camera.transform.LookAt(new Vector3(0, 0.5f, 0));
            camera.fieldOfView = 40;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.targetTexture = target;

            sun = new GameObject("Sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.transform.rotation = Quaternion.Euler(90, 0, 0);
            sun.shadows = LightShadows.Hard;

            GameObject plane = GameObject.CreatePrimitive(PrimitiveType.Plane);
            floor = plane.GetComponent<MeshRenderer>();
            floor.sharedMaterial = MaterialOf("Solid.shader");
        }

        [TearDown]
        public void Release()
        {
            buffers.ForEach(b => b.Release());
            buffers.Clear();
            target.Release();
        }

        // ---- Built-in

        [Test]
        public void A_sphere_shades_the_floor_below_it_and_nothing_else()
        {
            DrawFrame();
            Assert.That(At(new Vector3(0, 0, 0)).x, Is.LessThan(0.8f * At(new Vector3(2, 0, 0)).x), "below");
            Assert.That(At(new Vector3(0.9f, 0, 0)).x, Is.EqualTo(At(new Vector3(2, 0, 0)).x).Within(1e-3f), "beside");
        }

        [Test]
        public void What_casts_no_shadow_leaves_the_floor_lit()
        {
            DrawFrame(casts: ShadowCastingMode.Off);
            Assert.That(At(Vector3.zero).x, Is.EqualTo(At(new Vector3(2, 0, 0)).x).Within(1e-3f));
        }

        [Test]
        public void A_light_without_shadows_leaves_the_floor_lit()
        {
            sun.shadows = LightShadows.None;
            DrawFrame();
            Assert.That(At(Vector3.zero).x, Is.EqualTo(At(new Vector3(2, 0, 0)).x).Within(1e-3f));
        }

        [Test]
        public void What_casts_shadows_only_is_not_seen()
        {
            DrawFrame(casts: ShadowCastingMode.ShadowsOnly);
            Assert.That(At(Center).z, Is.LessThan(0.9f), "the floor behind the sphere is not blue");
            Assert.That(At(Vector3.zero).x, Is.LessThan(0.8f * At(new Vector3(2, 0, 0)).x));
        }

        [Test]
        public void A_sphere_is_shaded_by_what_stands_over_it_unless_it_receives_none()
        {
            Vector3 top = Center + new Vector3(0, 0.99f * Radius, -0.1f);
            float lit = ShadedTop(top, roof: false, receives: true), shaded = ShadedTop(top, roof: true, receives: true);
            Assert.That(shaded, Is.LessThan(0.6f * lit));
            Assert.That(ShadedTop(top, roof: true, receives: false), Is.EqualTo(lit).Within(1e-3f));
        }

        float ShadedTop(Vector3 top, bool roof, bool receives)
        {
            GameObject over = GameObject.CreatePrimitive(PrimitiveType.Cube);
            over.GetComponent<MeshRenderer>().sharedMaterial = floor.sharedMaterial;
            over.transform.position = roof ? new Vector3(0, 4, 0) : new Vector3(20, 4, 0);
            over.GetComponent<MeshRenderer>().shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            block.SetFloat("_ReceiveShadows", receives ? 1 : 0);
            DrawFrame();
            Object.DestroyImmediate(over);
            return At(top).z;
        }

        [Test]
        public void A_sphere_in_the_open_does_not_shade_itself()
        {
            sun.transform.rotation = Quaternion.Euler(40, 20, 0);
            DrawFrame();
            Vector4[] shadowed = Pixels();
            sun.shadows = LightShadows.None;
            DrawFrame();
            Vector4[] open = Pixels();
            // What faces away from the sun is dark in the shadow's own right: only what faces it is compared.
            int facing = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                    if (Hit(x, y, out Vector3 normal) && Vector3.Dot(normal, -sun.transform.forward) > 0.4f)
                    {
                        facing++;
                        Assert.That(shadowed[y * Width + x].z, Is.EqualTo(open[y * Width + x].z).Within(0.02f), $"pixel {x}, {y}");
                    }
            Assert.That(facing, Is.GreaterThan(30));
        }

        // ---- URP's passes, drawn as URP draws them

        [Test]
        public void Depth_passes_of_Urp_hold_the_depth_of_the_forward_pass()
        {
            Material material = MaterialOf("Particles.shader", "UniversalPipeline");
            Vector4[] only = DrawPass(material, "DepthOnly");
            int hits = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                {
                    bool hit = Hit(x, y, out Vector3 normal);
                    Vector4 clip = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true) * camera.worldToCameraMatrix * Point(Center + normal * Radius);
                    if (hit)
                        Assert.That(only[y * Width + x].x, Is.EqualTo(clip.z / clip.w).Within(1e-5f), $"pixel {x}, {y}");
                    else if (only[y * Width + x].x != 0)
                        Assert.That(Grazes(x, y), $"pixel {x}, {y}");
                    hits += hit ? 1 : 0;
                }
            Assert.That(hits, Is.GreaterThan(100));
        }

        [Test]
        public void The_normals_pass_of_Urp_holds_the_spheres_normals()
        {
            Vector4[] normals = DrawPass(MaterialOf("Particles.shader", "UniversalPipeline"), "DepthNormals");
            int hits = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                    if (Hit(x, y, out Vector3 normal))
                    {
                        hits++;
                        Vector4 drawn = normals[y * Width + x];
                        Assert.That(Vector3.Distance(new Vector3(drawn.x, drawn.y, drawn.z), normal), Is.LessThan(2e-2f), $"pixel {x}, {y}");
                    }
            Assert.That(hits, Is.GreaterThan(100));
        }

        [Test]
        public void Motion_vectors_of_Urp_are_the_spheres_own_motion_and_the_cameras()
        {
            Vector3 before = Center - new Vector3(0.2f, 0.1f, 0);
            Positions(Center, before);
            block.SetVector("_FrameLag", new Vector4(0, 0, -1, -1f / 60));       // one substep back is where it was drawn last
            Matrix4x4 projection = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true);
            Matrix4x4 now = projection * camera.worldToCameraMatrix, last = projection * (camera.worldToCameraMatrix * Matrix4x4.Translate(new Vector3(0.3f, 0, 0)));
            Shader.SetGlobalMatrix("_NonJitteredViewProjMatrix", now);
            Shader.SetGlobalMatrix("_PrevViewProjMatrix", last);
            Shader.SetGlobalVector("unity_MotionVectorsParams", new Vector4(0, 1, 0, 0));
            Material material = MaterialOf("Particles.shader", "UniversalPipeline");
            Vector4[] motion = DrawPass(material, "MotionVectors");
            int hits = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                    if (Hit(x, y, out Vector3 normal))
                    {
                        hits++;
                        Vector3 point = Center + normal * Radius;
                        Vector4 a = now * Point(point), b = last * Point(point - (Center - before));
                        Assert.That(motion[y * Width + x].x, Is.EqualTo((a.x / a.w - b.x / b.w) / 2).Within(1e-4f), $"pixel {x}, {y}");
                        Assert.That(motion[y * Width + x].y, Is.EqualTo(-(a.y / a.w - b.y / b.w) / 2).Within(1e-4f), $"pixel {x}, {y}");
                    }
            Assert.That(hits, Is.GreaterThan(100));

            Shader.SetGlobalVector("unity_MotionVectorsParams", Vector4.zero);       // no motion
            Assert.That(DrawPass(material, "MotionVectors"), Is.All.EqualTo(Vector4.zero));
        }

        [Test]
        public void Urps_shadow_map_shades_the_floor_by_either_keyword([Values("_MAIN_LIGHT_SHADOWS", "_MAIN_LIGHT_SHADOWS_CASCADE")] string keyword)
        {
            // From above, 8 m across, 10 m deep; the pass draws as from any view.
            Matrix4x4 view = Matrix4x4.Scale(new Vector3(1, 1, -1)) * Matrix4x4.TRS(new Vector3(0, 5, 0), Quaternion.Euler(90, 0, 0), Vector3.one).inverse;
            Matrix4x4 projection = Matrix4x4.Ortho(-4, 4, -4, 4, 0, 10);
            var map = new RenderTexture(256, 256, UnityEngine.Experimental.Rendering.GraphicsFormat.None, UnityEngine.Experimental.Rendering.GraphicsFormat.D32_SFloat);
            Material spheres = MaterialOf("Particles.shader", "UniversalPipeline");
            Shader.SetGlobalVector("_ShadowBias", new Vector4(-0.02f, -0.02f, 0, 0));
            using (var cmd = new CommandBuffer())
            {
                cmd.SetRenderTarget(map);
                cmd.ClearRenderTarget(true, false, Color.clear);
                cmd.SetViewProjectionMatrices(view, projection);
                cmd.DrawProcedural(Matrix4x4.identity, spheres, spheres.FindPass("ShadowCaster"), MeshTopology.Triangles, 6, 2, block);
                Graphics.ExecuteCommandBuffer(cmd);
            }

            Matrix4x4 toShadow = Matrix4x4.Translate(new Vector3(0.5f, 0.5f, 0)) * Matrix4x4.Scale(new Vector3(0.5f, 0.5f, 1)) * GL.GetGPUProjectionMatrix(projection, false) * view;
            Shader.SetGlobalMatrixArray("_MainLightWorldToShadow", new[] { toShadow, Matrix4x4.zero, Matrix4x4.zero, Matrix4x4.zero, Matrix4x4.zero });
            Shader.SetGlobalVector("_CascadeShadowSplitSpheres0", new Vector4(0, 0, 0, 10));
            Shader.SetGlobalVector("_CascadeShadowSplitSphereRadii", new Vector4(100, 0, 0, 0));
            Shader.SetGlobalVector("_MainLightShadowParams", new Vector4(1, 0, 0, 0));
            Shader.SetGlobalTexture("_MainLightShadowmapTexture", map, RenderTextureSubElement.Depth);
            Shader.SetGlobalVector("_MainLightPosition", new Vector4(0, 1, 0, 0));
            Shader.SetGlobalVector("_MainLightColor", Vector4.one);
            Material material = MaterialOf("Solid.shader", "UniversalPipeline");
            Shader.EnableKeyword(keyword);
            Vector4[] shaded = DrawPass(material, "Forward", floor.GetComponent<MeshFilter>().sharedMesh);
            Shader.DisableKeyword(keyword);
            Vector4[] lit = DrawPass(material, "Forward", floor.GetComponent<MeshFilter>().sharedMesh);
            map.Release();

            Assert.That(shaded[Index(Vector3.zero)].x, Is.LessThan(0.8f * lit[Index(Vector3.zero)].x), "below");
            Assert.That(shaded[Index(new Vector3(0.6f, 0, 0))].x, Is.EqualTo(lit[Index(new Vector3(0.6f, 0, 0))].x).Within(1e-3f), "beside");
        }

        // ---- two eyes

        [Test]
        public void Each_eye_of_a_single_pass_sees_what_a_camera_there_sees([Values("Particles.shader", "Solid.shader")] string file, [Values("", "UniversalPipeline")] string pipeline)
        {
            Material material = MaterialOf(file, pipeline);
            Mesh mesh = file == "Solid.shader" ? floor.GetComponent<MeshFilter>().sharedMesh : null;
            Shader.SetGlobalVector("_MainLightPosition", new Vector4(0, 1, 0, 0));
            Shader.SetGlobalVector("_MainLightColor", Vector4.one);
            Shader.SetGlobalVector("_WorldSpaceLightPos0", new Vector4(0, 1, 0, 0));
            Shader.SetGlobalVector("_LightColor0", Vector4.one);
            Matrix4x4[] views = { Matrix4x4.Translate(new Vector3(0.2f, 0, 0)) * camera.worldToCameraMatrix, Matrix4x4.Translate(new Vector3(-0.2f, 0, 0)) * camera.worldToCameraMatrix };

            var eyes = new RenderTexture(new RenderTextureDescriptor(Width, Height, target.graphicsFormat, target.depthStencilFormat) { dimension = TextureDimension.Tex2DArray, volumeDepth = 2 });
            BuiltinVariables.SetStereo(views, new[] { camera.projectionMatrix, camera.projectionMatrix });
            Shader.EnableKeyword("STEREO_INSTANCING_ON");
            using (var cmd = new CommandBuffer())
            {
                cmd.SetRenderTarget(eyes, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices);
                cmd.ClearRenderTarget(true, true, Color.clear);
                int pass = material.FindPass("Forward");
                if (mesh != null)
                    cmd.DrawMesh(mesh, Matrix4x4.identity, material, 0, pass);
                else
                    cmd.DrawProcedural(Matrix4x4.identity, material, pass, MeshTopology.Triangles, 6, 1, block);
                UnityEngine.Headless.RenderState.InstanceMultiplier = 2;
                Graphics.ExecuteCommandBuffer(cmd);
                UnityEngine.Headless.RenderState.InstanceMultiplier = 1;
            }
            Shader.DisableKeyword("STEREO_INSTANCING_ON");
            for (int eye = 0; eye < 2; eye++)
            {
                var request = AsyncGPUReadback.Request(eyes, 0, 0, Width, 0, Height, eye, 1);
                request.WaitForCompletion();
                Vector4[] seen = request.GetData<Vector4>().ToArray();
                camera.worldToCameraMatrix = views[eye];
                camera.transform.position = views[eye].inverse.MultiplyPoint3x4(Vector3.zero);
                Vector4[] alone = DrawPass(material, "Forward", mesh);
                int drawn = 0;
                for (int i = 0; i < seen.Length; i++)
                {
                    drawn += alone[i].w > 0 ? 1 : 0;
                    Assert.That((seen[i] - alone[i]).magnitude, Is.LessThan(2e-3f), $"eye {eye}, pixel {i % Width}, {i / Width}");
                }
                Assert.That(drawn, Is.GreaterThan(100));
            }
            eyes.Release();
        }

        // ---- helpers

        static Vector4 Point(Vector3 p) => new Vector4(p.x, p.y, p.z, 1);

        internal static Material MaterialOf(string file, string pipeline = "")
        {
            string path = Path.Combine(TestFolder.Path, "..", "..", "Shaders", file);
            return new Material(Shader.Create(ShaderImporter.ImportShader(path, "Shaders/" + file, name => name.Contains("universal") && pipeline.Length > 0 ? path : null, new ShaderCache(), pipeline)));
        }

        void Positions(Vector3 now, Vector3 start)
        {
            Set("_Positions", new[] { Point(now + Corner) });
            Set("_StartPositions", new[] { Point(start + Corner) });
            Set("_Velocities", new[] { new Vector4(0, 0, 0, 1) });
            Set("_Counters", new uint[] { 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1 });
        }

        void Set<T>(string name, T[] data) where T : struct
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, data.Length, System.Runtime.InteropServices.Marshal.SizeOf<T>());
            buffer.SetData(data);
            buffers.Add(buffer);
            block.SetBuffer(name, buffer);
        }

        void DrawFrame(ShadowCastingMode casts = ShadowCastingMode.On)
        {
            var draw = new RenderParams(MaterialOf("Particles.shader"))
            {
                worldBounds = new Bounds(Center, Vector3.one * 2), matProps = block, shadowCastingMode = casts, receiveShadows = true,
            };
            Graphics.RenderPrimitives(draw, MeshTopology.Triangles, 6);
            PlayerLoop.Frame(1f / 60);
        }

        Vector4[] DrawPass(Material material, string pass, Mesh mesh = null)
        {
            Assert.That(material.FindPass(pass), Is.GreaterThanOrEqualTo(0), pass);
            BuiltinVariables.SetCamera(camera, Width, Height);
            using var cmd = new CommandBuffer();
            cmd.SetRenderTarget(target);
            cmd.ClearRenderTarget(true, true, Color.clear);
            if (mesh != null)
                cmd.DrawMesh(mesh, Matrix4x4.identity, material, 0, material.FindPass(pass));
            else
                cmd.DrawProcedural(Matrix4x4.identity, material, material.FindPass(pass), MeshTopology.Triangles, 6, 2, block);
            Graphics.ExecuteCommandBuffer(cmd);
            return Pixels();
        }

        Vector4[] Pixels()
        {
            var request = AsyncGPUReadback.Request(target);
            request.WaitForCompletion();
            return request.GetData<Vector4>().ToArray();
        }

        int Index(Vector3 world)
        {
            Vector3 at = camera.WorldToScreenPoint(world);
            return (int)at.y * Width + (int)at.x;
        }

        Vector4 At(Vector3 world) => Pixels()[Index(world)];

        // Where the ray through the middle of a pixel meets the sphere, by hand.
        bool Hit(int x, int y, out Vector3 normal)
        {
            float missing = Missing(x, y, out Ray ray, out float along);
            normal = missing > 0 ? (ray.origin + ray.direction * (along - Mathf.Sqrt(missing)) - Center) / Radius : Vector3.zero;
            return missing > 0.05f * Radius * Radius;
        }

        bool Grazes(int x, int y) => Mathf.Abs(Missing(x, y, out _, out _)) < 0.2f * Radius * Radius;

        float Missing(int x, int y, out Ray ray, out float along)
        {
            ray = camera.ScreenPointToRay(new Vector3(x + 0.5f, y + 0.5f, 0));
            along = Vector3.Dot(Center - ray.origin, ray.direction);
            Vector3 offset = Center - ray.origin - ray.direction * along;
            return Radius * Radius - offset.sqrMagnitude;
        }
    }
}
