using System;
using System.Collections.Generic;
using System.IO;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>One sphere of the package's shaders, of radius 0.5 over a floor, in the light of a sun overhead.</summary>
    public abstract class RenderPassFixture : GraphicsFixture
    {
        protected const int Width = 96, Height = 64;
        protected const float Radius = 0.5f;
        protected static readonly Vector3 Center = new Vector3(0, 1, 0), Corner = Vector3.one * 32;     // the origin of the world in the domain

        readonly List<GraphicsBuffer> buffers = new List<GraphicsBuffer>();
        protected MaterialPropertyBlock block;
        protected RenderTexture target;
        protected Camera camera;
        protected Light sun;
        protected MeshRenderer floor;

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

            target = new RenderTexture(Width, Height, UnityEngine.Experimental.Rendering.GraphicsFormat.R32G32B32A32_SFloat,
                UnityEngine.Experimental.Rendering.GraphicsFormat.D32_SFloat);
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

        protected static Vector4 Point(Vector3 p) => new Vector4(p.x, p.y, p.z, 1);

        /// <param name="edit">Changes the text of the .shader file first; null = as it is.</param>
        internal static Material MaterialOf(string file, string pipeline = "", Func<string, string> edit = null)
        {
            string folder = Path.Combine(PackageFolder.Path, "Shaders", "Rendering"), path = Path.Combine(folder, file), edited = null;
            string Resolve(string name) => name.Contains(pipeline == "HDRenderPipeline" ? "high-definition" : "universal")
                ? pipeline.Length > 0 ? path : null : edit != null && name.EndsWith(".hlsl") ? Path.Combine(folder, name) : null;
            if (edit != null)
            {
                edited = Path.Combine(Directory.CreateTempSubdirectory("rill-shader").FullName, file);
                File.WriteAllText(edited, edit(File.ReadAllText(path)));
            }
            try
            {
                return new Material(Shader.Create(ShaderImporter.ImportShader(edited ?? path, "Shaders/Rendering/" + file, Resolve,
                    new ShaderCache(), pipeline)));
            }
            finally
            {
                if (edited != null)
                    Directory.Delete(Path.GetDirectoryName(edited), true);
            }
        }

        protected void Positions(Vector3 now, Vector3 start)
        {
            Set("_Positions", new[] { Point(now + Corner) });
            Set("_StartPositions", new[] { Point(start + Corner) });
            Set("_Velocities", new[] { new Vector4(0, 0, 0, 1) });
            Set("_Counters", new uint[] { 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1 });
        }

        protected void Set<T>(string name, T[] data) where T : struct
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, data.Length, System.Runtime.InteropServices.Marshal.SizeOf<T>());
            buffer.SetData(data);
            buffers.Add(buffer);
            block.SetBuffer(name, buffer);
        }

        protected void DrawFrame(ShadowCastingMode casts = ShadowCastingMode.On)
        {
            var draw = new RenderParams(MaterialOf("Particles.shader"))
            {
                worldBounds = new Bounds(Center, Vector3.one * 2), matProps = block, shadowCastingMode = casts, receiveShadows = true,
            };
            Graphics.RenderPrimitives(draw, MeshTopology.Triangles, 6);
            PlayerLoop.Frame(1f / 60);
        }

        /// <summary>Draws a mesh, or the sphere without one.</summary>
        protected Vector4[] DrawPass(Material material, string pass, Mesh mesh = null) =>
            Draw(material, pass, (cmd, index) =>
            {
                if (mesh != null)
                    cmd.DrawMesh(mesh, Matrix4x4.identity, material, 0, index);
                else
                    cmd.DrawProcedural(Matrix4x4.identity, material, index, MeshTopology.Triangles, 6, 2, block);
            });

        protected Vector4[] Draw(Material material, string pass, Action<CommandBuffer, int> draw)
        {
            Assert.That(material.FindPass(pass), Is.GreaterThanOrEqualTo(0), pass);
            BuiltinVariables.SetCamera(camera, Width, Height);
            using var cmd = new CommandBuffer();
            cmd.SetRenderTarget(target);
            cmd.ClearRenderTarget(true, true, Color.clear);
            draw(cmd, material.FindPass(pass));
            Graphics.ExecuteCommandBuffer(cmd);
            return Pixels();
        }

        protected Vector4[] Pixels()
        {
            var request = AsyncGPUReadback.Request(target);
            request.WaitForCompletion();
            return request.GetData<Vector4>().ToArray();
        }

        protected int Index(Vector3 world)
        {
            Vector3 at = camera.WorldToScreenPoint(world);
            return (int)at.y * Width + (int)at.x;
        }

        protected Vector4 At(Vector3 world) => Pixels()[Index(world)];

        /// <summary>A camera that came from the side: this frame's matrix and the last one's, also as the pipeline names them.</summary>
        protected (Matrix4x4 Now, Matrix4x4 Last) SetMotionMatrices(string pipeline)
        {
            Matrix4x4 projection = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true);
            Matrix4x4 now = projection * camera.worldToCameraMatrix,
                last = projection * (camera.worldToCameraMatrix * Matrix4x4.Translate(new Vector3(0.3f, 0, 0)));
            Shader.SetGlobalMatrix(pipeline == "" ? "_NonJitteredVP" : "_NonJitteredViewProjMatrix", now);
            Shader.SetGlobalMatrix(pipeline == "" ? "_PreviousVP" : "_PrevViewProjMatrix", last);
            SetMotion(pipeline, true);
            return (now, last);
        }

        protected static void SetMotion(string pipeline, bool isOn)
        {
            if (pipeline == "")
                Shader.SetGlobalInt("_ForceNoMotion", isOn ? 0 : 1);
            else
                Shader.SetGlobalVector("unity_MotionVectorsParams", new Vector4(0, isOn ? 1 : 0, 0, 0));
        }

        protected static void AssertMotion(Vector4 drawn, Vector4 now, Vector4 last, string pipeline, string where)
        {
            Assert.That(drawn.x, Is.EqualTo((now.x / now.w - last.x / last.w) / 2).Within(1e-4f), where);
            Assert.That(drawn.y, Is.EqualTo(-(now.y / now.w - last.y / last.w) / 2).Within(1e-4f), where);
            Assert.That(drawn.w, Is.EqualTo(pipeline == "" ? 1 : 0), where);
        }

        // Computes where the ray through the center of a pixel meets the sphere, by hand.
        protected bool Hit(int x, int y, out Vector3 normal)
        {
            float missing = Missing(x, y, out Ray ray, out float along);
            normal = missing > 0 ? (ray.origin + ray.direction * (along - Mathf.Sqrt(missing)) - Center) / Radius : Vector3.zero;
            return missing > 0.05f * Radius * Radius;
        }

        protected bool Grazes(int x, int y) => Mathf.Abs(Missing(x, y, out _, out _)) < 0.2f * Radius * Radius;

        float Missing(int x, int y, out Ray ray, out float along)
        {
            ray = camera.ScreenPointToRay(new Vector3(x + 0.5f, y + 0.5f, 0));
            along = Vector3.Dot(Center - ray.origin, ray.direction);
            Vector3 offset = Center - ray.origin - ray.direction * along;
            return Radius * Radius - offset.sqrMagnitude;
        }
    }
}
