using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Pictures of 64 x 32 pixels, looked at from the top left; the triangle covers the lower left half of its square.</summary>
    public class GraphicsDrawTests : GraphicsFixture
    {
        static readonly Bounds everywhere = new Bounds(Vector3.zero, Vector3.one * 1000);
        static readonly Color32 clear = new Color32(0, 0, 255, 255);

        // Orthographic from the origin along +z: 32 x 16 world units, two pixels each.
        static Camera NewCamera()
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.orthographic = true;
            camera.orthographicSize = 8;
            camera.nearClipPlane = 1;
            camera.farClipPlane = 11;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = new Color(0, 0, 1, 1);
            return camera;
        }

        static Material NewMaterial(Color color, float depth = 5)
        {
            var material = new Material(DrawShader("Triangle"));
            material.SetColor("_Color", color);
            material.SetFloat("_Depth", depth);
            return material;
        }

        // Scaled through a global would hide mistakes: the picture is small enough for a triangle of 2 x 2 units, 4 x 4 pixels at the center.
        static Color32 Pixel(int x, int y, RenderTexture target = null)
        {
            byte[] picture = Screenshot.ReadRgba(target);
            int at = (y * 64 + x) * 4;
            return new Color32(picture[at], picture[at + 1], picture[at + 2], picture[at + 3]);
        }

        // The four pixels of the center: the triangle's corners are at (30, 18), (30, 14) and (34, 18) from the top left.
        const int Left = 30, Right = 33, Top = 14, Bottom = 17;

        [Test]
        public void A_triangle_is_drawn_upright()
        {
            NewCamera();
            Graphics.RenderPrimitives(new RenderParams(NewMaterial(Color.red)) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)), "left bottom");
            Assert.That(Pixel(Left, Top + 1), Is.EqualTo(new Color32(255, 0, 0, 255)), "left, near the top");
            Assert.That(Pixel(Right, Top), Is.EqualTo(clear), "right top");
            Assert.That(Pixel(0, 0), Is.EqualTo(clear));
            Assert.That(Pixel(Left - 1, Bottom), Is.EqualTo(clear), "left of it");
            Assert.That(Pixel(Left, Bottom + 1), Is.EqualTo(clear), "below it");

            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(clear), "a draw lasts one frame");
        }

        [Test]
        public void Front_faces_are_clockwise_as_the_picture_is_seen([Values(0, 1, 2)] int cull)
        {
            NewCamera();
            Material material = NewMaterial(Color.red);
            material.SetFloat("_Cull", cull);
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(cull == 1 ? clear : new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void A_face_seen_from_behind_knows_it()
        {
            NewCamera();
            Material material = NewMaterial(Color.red);
            material.SetFloat("_Cull", 0);
            GL.invertCulling = true;
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            GL.invertCulling = false;
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(0, 0, 255, 255)));
        }

        [Test]
        public void What_is_nearer_hides_what_is_farther_in_either_order([Values(0, 1)] int order)
        {
            NewCamera();
            Material near = NewMaterial(Color.red, 2), far = NewMaterial(Color.green, 9);
            foreach (Material material in order == 0 ? new[] { near, far } : new[] { far, near })
                Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void Property_block_beats_material_beats_global()
        {
            NewCamera();
            Material material = NewMaterial(Color.white);
            material.SetVector("_Tint", new Vector4(0, 1, 0, 1));
            Shader.SetGlobalVector("_Tint", new Vector4(0, 0, 1, 1));
            Shader.SetGlobalVector("_GlobalTint", new Vector4(0, 0, 1, 0));
            var block = new MaterialPropertyBlock();
            block.SetVector("_Tint", new Vector4(1, 0, 0, 1));

            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(0, 255, 255, 255)), "material, and the global that only the globals have");

            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere, matProps = block }, MeshTopology.Triangles, 3);
            block.SetVector("_Tint", Vector4.zero);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 255, 255)), "the block as it was at the call");
        }

        [Test]
        public void Colors_are_linear_in_shaders_and_srgb_on_the_screen()
        {
            NewCamera();
            Graphics.RenderPrimitives(new RenderParams(NewMaterial(new Color(0.5f, 0.25f, 0.75f, 1))) { worldBounds = everywhere },
                MeshTopology.Triangles, 3);
            Frame();
            Color32 pixel = Pixel(Left, Bottom);
            Assert.That(pixel.r, Is.EqualTo(128).Within(1));
            Assert.That(pixel.g, Is.EqualTo(64).Within(1));
            Assert.That(pixel.b, Is.EqualTo(191).Within(1));
        }

        [Test]
        public void Keywords_of_a_material_choose_its_variant()
        {
            NewCamera();
            Material material = NewMaterial(Color.red);
            material.EnableKeyword("HALF_RED");
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom).r, Is.EqualTo(188).Within(1), "half of linear red");
        }

        [Test]
        public void Textures_have_their_first_row_at_the_bottom()
        {
            NewCamera();
            var texture = new Texture2D(1, 2, TextureFormat.RGBA32, false) { filterMode = FilterMode.Point, wrapMode = TextureWrapMode.Clamp };
            texture.SetPixels32(new[] { new Color32(255, 0, 0, 255), new Color32(0, 255, 0, 255) });
            texture.Apply();
            Material material = NewMaterial(Color.white);
            material.mainTexture = texture;
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)));
            Assert.That(Pixel(Left, Top + 1), Is.EqualTo(new Color32(0, 255, 0, 255)));
            UnityEngine.Object.DestroyImmediate(texture);
        }

        [Test]
        public void A_draw_outside_of_the_frustum_is_culled_by_its_bounds_whatever_it_draws()
        {
            NewCamera();
            Graphics.RenderPrimitives(new RenderParams(NewMaterial(Color.red)) { worldBounds = new Bounds(new Vector3(0, 0, -50),
                Vector3.one) }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(clear));
        }

        [Test]
        public void Layers_and_cameras_choose_what_is_seen()
        {
            Camera camera = NewCamera();
            camera.cullingMask = 1 << 3;
            Camera other = NewCamera();
            other.enabled = false;
            Material material = NewMaterial(Color.red);
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere, layer = 2 }, MeshTopology.Triangles, 3);
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere, layer = 3, camera = other }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(clear));
            Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = everywhere, layer = 3 }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void Indirect_arguments_written_on_the_gpu_say_how_many_instances_are_drawn()
        {
            NewCamera();
            ComputeShader shader = Compute("Work");
            int write = shader.FindKernel("WriteArguments");
            using (var arguments = new GraphicsBuffer(GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.IndirectArguments, 4, 4))
            {
                shader.SetBuffer(write, "_Arguments", arguments);
                shader.SetInt("_GroupsX", 3);
                shader.SetInt("_GroupsY", 2);
                shader.SetInt("_GroupsZ", 0);
                shader.SetInt("_GroupsW", 0);
                shader.Dispatch(write, 1, 1, 1);
                Graphics.RenderPrimitivesIndirect(new RenderParams(NewMaterial(Color.red)) { worldBounds = everywhere },
                    MeshTopology.Triangles, arguments);
                Frame();
            }
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)), "instance 0");
            Assert.That(Pixel(Left + 4, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)), "instance 1, two units to the right");
            Assert.That(Pixel(Left + 8, Bottom), Is.EqualTo(clear), "no instance 2");
        }

        [Test]
        public void Indices_choose_the_vertices()
        {
            NewCamera();
            using (var indices = new GraphicsBuffer(GraphicsBuffer.Target.Index, 6, 2))
            {
                indices.SetData(new ushort[] { 9, 9, 9, 0, 1, 2 });
                Graphics.RenderPrimitivesIndexed(new RenderParams(NewMaterial(Color.red)) { worldBounds = everywhere },
                    MeshTopology.Triangles, indices, 3, 3);
                Frame();
            }
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void A_command_buffer_draws_into_a_render_texture_at_its_camera_event()
        {
            Camera camera = NewCamera();
            var target = new RenderTexture(64, 32, 16, RenderTextureFormat.ARGB32);
            using (var cmd = new CommandBuffer())
            {
                cmd.SetRenderTarget(target);
                cmd.ClearRenderTarget(true, true, Color.green);
                cmd.DrawProcedural(Matrix4x4.Translate(new Vector3(0, 2, 0)), NewMaterial(Color.red), 0, MeshTopology.Triangles, 3);
                camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, cmd);
                Frame();
                Assert.That(Pixel(Left, Bottom - 4, target), Is.EqualTo(new Color32(255, 0, 0, 255)), "two units up");
                Assert.That(Pixel(Left, Bottom, target), Is.EqualTo(new Color32(0, 255, 0, 255)));
                Assert.That(Pixel(Left, Bottom), Is.EqualTo(clear), "the camera's own picture is left alone");
                camera.RemoveCommandBuffer(CameraEvent.AfterForwardOpaque, cmd);
            }
            UnityEngine.Object.DestroyImmediate(target);
        }

        [Test]
        public void Matrices_of_a_command_buffer_take_the_place_of_a_camera()
        {
            var target = new RenderTexture(64, 32, 16, RenderTextureFormat.ARGB32);
            using (var cmd = new CommandBuffer())
            {
                cmd.SetRenderTarget(target);
                cmd.ClearRenderTarget(true, true, Color.clear);
                cmd.SetViewProjectionMatrices(Matrix4x4.Scale(new Vector3(1, 1, -1)), Matrix4x4.Ortho(-16, 16, -8, 8, 1, 11));
                cmd.SetViewport(new Rect(0, 0, 32, 16));
                cmd.DrawProcedural(Matrix4x4.identity, NewMaterial(Color.red), 0, MeshTopology.Triangles, 3);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            Assert.That(Pixel(15, 24, target), Is.EqualTo(new Color32(255, 0, 0, 255)), "a viewport's origin is the lower left");
            Assert.That(Pixel(Left, Bottom, target).a, Is.Zero);
            UnityEngine.Object.DestroyImmediate(target);
        }

        [Test]
        public void A_mesh_is_drawn_with_its_attributes_by_renderers_and_by_calls([Values(0, 1)] int renderer)
        {
            NewCamera();
            var mesh = new Mesh
            {
                vertices = new[] { new Vector3(-1, -1, 5), new Vector3(-1, 1, 5), new Vector3(1, 1, 5), new Vector3(1, -1, 5) },
                colors = new[] { Color.red, Color.red, Color.red, Color.red },
                uv = new[] { Vector2.one, Vector2.one, Vector2.one, Vector2.one },
                triangles = new[] { 0, 1, 2, 0, 2, 3 },
            };
            var material = new Material(DrawShader("Mesh"));
            if (renderer == 1)
            {
                var go = new GameObject("Quad");
                go.AddComponent<MeshFilter>().sharedMesh = mesh;
                go.AddComponent<MeshRenderer>().sharedMaterial = material;
                go.transform.position = new Vector3(4, 0, 0);
            }
            else
                Graphics.DrawMesh(mesh, Matrix4x4.Translate(new Vector3(4, 0, 0)), material, 0);
            Assert.That(mesh.bounds, Is.EqualTo(new Bounds(new Vector3(0, 0, 5), new Vector3(2, 2, 0))));
            Frame();
            Assert.That(Pixel(Left + 8, Bottom), Is.EqualTo(new Color32(255, 0, 255, 255)));
            Assert.That(Pixel(Right + 8, Top), Is.EqualTo(new Color32(255, 0, 255, 255)));
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(clear));
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Quads_are_drawn_as_two_triangles()
        {
            NewCamera();
            // Vertices 0, 1, 2 of the shader are the triangle; 3 falls on 0, so that the second triangle is empty.
            Graphics.RenderPrimitives(new RenderParams(NewMaterial(Color.red)) { worldBounds = everywhere }, MeshTopology.Quads, 4);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void Cameras_draw_in_order_of_depth_and_keep_what_they_are_told_to_keep()
        {
            Camera second = NewCamera(), first = NewCamera();
            second.depth = 1;
            second.clearFlags = CameraClearFlags.Depth;
            first.backgroundColor = Color.green;
            Frame();
            Assert.That(Pixel(0, 0), Is.EqualTo(new Color32(0, 255, 0, 255)));
            Assert.That(Camera.allCameras, Is.EqualTo(new[] { first, second }));
        }

        [Test]
        public void Points_of_the_world_the_viewport_and_the_screen_agree()
        {
            Camera camera = NewCamera();
            camera.orthographic = false;
            camera.transform.position = new Vector3(1, 2, 3);
            camera.transform.rotation = Quaternion.Euler(10, 20, 30);
            Vector3 ahead = camera.transform.position + camera.transform.forward * 7;
            Vector3 screen = camera.WorldToScreenPoint(ahead);
            Assert.That(Vector3.Distance(screen, new Vector3(32, 16, 7)), Is.LessThan(1e-3f));
            Vector3 point = camera.ScreenToWorldPoint(new Vector3(50, 5, 4));
            Assert.That(Vector3.Distance(camera.WorldToScreenPoint(point), new Vector3(50, 5, 4)), Is.LessThan(1e-3f));
            Ray ray = camera.ScreenPointToRay(new Vector3(50, 5, 0));
            Assert.That(Vector3.Cross((point - ray.origin).normalized, ray.direction).magnitude, Is.LessThan(1e-3f));
        }

        [Test]
        public void The_projection_for_the_gpu_has_reversed_depth_and_is_flipped_for_textures()
        {
            Matrix4x4 projection = Matrix4x4.Perspective(60, 1, 0.5f, 100);
            Matrix4x4 gpu = GL.GetGPUProjectionMatrix(projection, true);
            Vector4 near = gpu * new Vector4(0, 0, -0.5f, 1), far = gpu * new Vector4(0, 0, -100, 1), up = gpu * new Vector4(0, 1, -1, 1);
            Assert.That(near.z / near.w, Is.EqualTo(1).Within(1e-5f));
            Assert.That(far.z / far.w, Is.EqualTo(0).Within(1e-5f));
            Assert.That(up.y, Is.Negative);
            Assert.That((GL.GetGPUProjectionMatrix(projection, false) * new Vector4(0, 1, -1, 1)).y, Is.Positive);
        }

        [Test]
        public void A_png_begins_with_its_signature_and_holds_the_pixels()
        {
            var texture = new Texture2D(3, 2, TextureFormat.RGBA32, false);
            byte[] png = texture.EncodeToPNG();
            Assert.That(png[0], Is.EqualTo(0x89));
            Assert.That(System.Text.Encoding.ASCII.GetString(png, 1, 3), Is.EqualTo("PNG"));
            Assert.That(png[19], Is.EqualTo(3));
            Assert.That(png[23], Is.EqualTo(2));
            UnityEngine.Object.DestroyImmediate(texture);
        }

        [Test]
        public void A_blit_copies_between_textures_of_one_shape()
        {
            RenderTexture source = RenderTexture.GetTemporary(64, 32, 0, RenderTextureFormat.ARGB32),
                target = RenderTexture.GetTemporary(64, 32, 0, RenderTextureFormat.ARGB32);
            RenderTexture.active = source;
            GL.Clear(true, true, Color.red);
            Graphics.Blit(source, target);
            RenderTexture.active = null;
            Assert.That(Pixel(5, 5, target), Is.EqualTo(new Color32(255, 0, 0, 255)));
            RenderTexture.ReleaseTemporary(source);
            RenderTexture.ReleaseTemporary(target);
        }
    
        sealed class SwapRedAndGreen : MonoBehaviour
        {
            public static Material Material;
            void OnRenderImage(RenderTexture source, RenderTexture destination) => Graphics.Blit(source, destination, Material);
        }

        [Test]
        public void An_image_effect_beside_the_camera_has_the_last_word()
        {
            Camera camera = NewCamera();
            SwapRedAndGreen.Material = new Material(DrawShader("Swap"));
            camera.gameObject.AddComponent<SwapRedAndGreen>();
            Graphics.RenderPrimitives(new RenderParams(NewMaterial(Color.red)) { worldBounds = everywhere }, MeshTopology.Triangles, 3);
            Frame();
            Assert.That(Pixel(Left, Bottom), Is.EqualTo(new Color32(0, 255, 0, 255)));
            Assert.That(Pixel(Left, Top - 1), Is.EqualTo(clear), "the picture is not turned over");
        }

        [TestCase(PrimitiveType.Cube, 1)]
        [TestCase(PrimitiveType.Sphere, 0.5236)]
        [TestCase(PrimitiveType.Capsule, 1.309)]
        [TestCase(PrimitiveType.Cylinder, 1.5708)]
        public void Built_in_solids_are_closed_and_face_outwards(PrimitiveType type, double volume)
        {
            Mesh mesh = BuiltinMeshes.Of(type);
            Vector3[] v = mesh.vertices, n = mesh.normals;
            int[] t = mesh.triangles;
            double sum = 0;
            for (int i = 0; i < t.Length; i += 3)
            {
                Vector3 face = Vector3.Cross(v[t[i + 1]] - v[t[i]], v[t[i + 2]] - v[t[i]]);
                Assert.That(Vector3.Dot(face, n[t[i]]), Is.Positive,
                    "clockwise for those who look at it, so its cross product points along the normal");
                sum += Vector3.Dot(v[t[i]], Vector3.Cross(v[t[i + 1]], v[t[i + 2]])) / 6;
            }
            Assert.That(sum, Is.EqualTo(volume).Within(2).Percent);
        }

        [Test]
        public void A_primitive_is_an_object_with_a_mesh_of_unitys_size()
        {
            GameObject plane = GameObject.CreatePrimitive(PrimitiveType.Plane);
            Assert.That(plane.GetComponent<MeshFilter>().sharedMesh.bounds.size, Is.EqualTo(new Vector3(10, 0, 10)));
            Assert.That(plane.GetComponent<MeshRenderer>().bounds.extents.x, Is.EqualTo(5));
            Assert.That(Resources.GetBuiltinResource<Mesh>("Sphere.fbx").bounds.size.y, Is.EqualTo(1).Within(1e-5f));
        }
    }
}
