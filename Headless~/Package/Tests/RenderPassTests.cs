using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The package's own shaders, pass by pass: one sphere of radius 0.5 over a floor, in the light of a sun overhead.</summary>
    public class RenderPassTests : RenderPassFixture
    {
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
            Assert.That(At(Center).z, Is.EqualTo(At(new Vector3(2, 0, 0)).z).Within(1e-3f), "the floor behind the sphere");
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
            // Faces away from the sun are dark by themselves: only faces towards it are compared.
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
                    Vector4 clip = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true) * camera.worldToCameraMatrix
                        * Point(Center + normal * Radius);
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

        // ---- motion vectors, of the pipelines that name their matrices differently

        [Test]
        public void Motion_vectors_are_the_spheres_own_motion_and_the_cameras([Values("", "UniversalPipeline")] string pipeline)
        {
            Vector3 before = Center - new Vector3(0.2f, 0.1f, 0);
            Positions(Center, before);
            block.SetVector("_FrameLag", new Vector4(0, 0, -1, -1f / 60));       // one substep back is where it was drawn last
            (Matrix4x4 now, Matrix4x4 last) = SetMotionMatrices(pipeline);
            Material material = MaterialOf("Particles.shader", pipeline);
            Vector4[] motion = DrawPass(material, "MotionVectors");
            int hits = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                    if (Hit(x, y, out Vector3 normal))
                    {
                        hits++;
                        Vector3 point = Center + normal * Radius;
                        AssertMotion(motion[y * Width + x], now * Point(point), last * Point(point - (Center - before)), pipeline, $"pixel {x}, {y}");
                    }
            Assert.That(hits, Is.GreaterThan(100));

            SetMotion(pipeline, false);
            Assert.That(DrawPass(material, "MotionVectors"), Is.All.EqualTo(Vector4.zero));
        }

        // ---- two eyes

        [Test]
        public void Each_eye_of_a_single_pass_sees_what_a_camera_there_sees([Values("Particles.shader", "Solid.shader")] string file,
            [Values("", "UniversalPipeline")] string pipeline)
        {
            Material material = MaterialOf(file, pipeline);
            Mesh mesh = file == "Solid.shader" ? floor.GetComponent<MeshFilter>().sharedMesh : null;
            Shader.SetGlobalVector("_MainLightPosition", new Vector4(0, 1, 0, 0));
            Shader.SetGlobalVector("_MainLightColor", Vector4.one);
            Shader.SetGlobalVector("_WorldSpaceLightPos0", new Vector4(0, 1, 0, 0));
            Shader.SetGlobalVector("_LightColor0", Vector4.one);
            Matrix4x4[] views = { Matrix4x4.Translate(new Vector3(0.2f, 0, 0)) * camera.worldToCameraMatrix,
                Matrix4x4.Translate(new Vector3(-0.2f, 0, 0)) * camera.worldToCameraMatrix };

            var eyes = new RenderTexture(new RenderTextureDescriptor(Width, Height, target.graphicsFormat,
                target.depthStencilFormat) { dimension = TextureDimension.Tex2DArray, volumeDepth = 2 });
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

        [Test]
        public void Where_one_eye_is_drawn_a_second_instance_adds_nothing([Values("Particles.shader", "Domain.shader",
            "Solid.shader")] string file, [Values("", "UniversalPipeline")] string pipeline)
        {
            // Drawn twice, it is twice as bright, in every pass.
            Material material = MaterialOf(file, pipeline, text => Regex.Replace(text, "ColorMask \\w+|Blend \\[.*", "")
                .Replace("ZTest LEqual", "ZTest Always Blend One One"));
            SetMotionMatrices(pipeline);
            Shader.SetGlobalMatrix(pipeline == "" ? "_PreviousM" : "unity_MatrixPreviousM", Matrix4x4.identity);
            block.SetMatrix("_BoxToWorld", Matrix4x4.Scale(Vector3.one * 2));
            block.SetMatrix("_LastBoxToWorld", Matrix4x4.Scale(Vector3.one * 2));
            block.SetVector("_FloorColor", Vector4.one);
            block.SetFloat("_DrawFloor", 1);
            Mesh mesh = file == "Solid.shader" ? floor.GetComponent<MeshFilter>().sharedMesh : null;
            Vector4[] DrawInstances(int pass, int count)
            {
                UnityEngine.Headless.RenderState.InstanceMultiplier = count;
                try
                {
                    return Draw(material, material.GetPassName(pass), (cmd, index) =>
                    {
                        if (mesh != null)
                            cmd.DrawMesh(mesh, Matrix4x4.identity, material, 0, index);
                        else
                            cmd.DrawProcedural(Matrix4x4.identity, material, index, MeshTopology.Triangles, 6, 1, block);
                    });
                }
                finally
                {
                    UnityEngine.Headless.RenderState.InstanceMultiplier = 1;
                }
            }

            Assert.That(material.passCount, Is.EqualTo(pipeline == "" ? 3 : 5));
            for (int pass = 0; pass < material.passCount; pass++)
            {
                Vector4[] one = DrawInstances(pass, 1);
                Assert.That(one, Has.Some.Not.EqualTo(Vector4.zero), material.GetPassName(pass));
                Assert.That(DrawInstances(pass, 2), Is.EqualTo(one), material.GetPassName(pass));
            }
        }
    }
}
