using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>The fluid's box, pass by pass: a tilted floor and its edges.</summary>
    public class DomainPassTests : RenderPassFixture
    {
        const int EdgeVertices = 24, FloorVertices = 6;
        static readonly Vector3 Size = new Vector3(3, 1.5f, 3);
        static readonly Vector3 Motion = new Vector3(0.15f, 0.05f, -0.1f);      // since the last frame, m
        Matrix4x4 box;

        [SetUp]
        public void MakeBox() => SetBox(Matrix4x4.TRS(Vector3.zero, Quaternion.Euler(-8, 25, 5), Size)
            * Matrix4x4.Translate(new Vector3(-0.5f, 0, -0.5f)));

        void SetBox(Matrix4x4 toWorld)
        {
            box = toWorld;
            block.SetMatrix("_BoxToWorld", box);
            block.SetMatrix("_LastBoxToWorld", Matrix4x4.Translate(-Motion) * box);
            block.SetVector("_BoxSize", Size);
            block.SetVector("_LineColor", Vector4.one);
            block.SetVector("_FloorColor", Vector4.one);
            block.SetFloat("_FloorTile", 0.25f);
        }

        [Test]
        public void The_depth_pass_holds_the_floors_depth()
        {
            Vector4[] depth = DrawBox("DepthOnly", "UniversalPipeline", floor: true);
            Matrix4x4 toClip = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true) * camera.worldToCameraMatrix;
            EachFloorPixel((i, point) =>
            {
                Vector4 clip = toClip * Point(point);
                Assert.That(depth[i].x, Is.EqualTo(clip.z / clip.w).Within(1e-5f), $"pixel {i % Width}, {i / Width}");
            });
        }

        [Test]
        public void The_normals_pass_holds_the_floors_normal()
        {
            Vector4[] normals = DrawBox("DepthNormals", "UniversalPipeline", floor: true);
            Vector3 up = box.MultiplyVector(Vector3.up).normalized;
            EachFloorPixel((i, point) => Assert.That(Vector3.Distance(normals[i], up), Is.LessThan(1e-4f), $"pixel {i % Width}, {i / Width}"));
        }

        [Test]
        public void Motion_vectors_are_the_boxs_own_motion_and_the_cameras([Values("", "UniversalPipeline")] string pipeline)
        {
            (Matrix4x4 now, Matrix4x4 last) = SetMotionMatrices(pipeline);
            Vector4[] motion = DrawBox("MotionVectors", pipeline, floor: true);
            EachFloorPixel((i, point) => AssertMotion(motion[i], now * Point(point), last * Point(point - Motion), pipeline,
                $"pixel {i % Width}, {i / Width}"));
        }

        [Test]
        public void The_passes_of_the_edges_cover_the_pixels_of_the_forward_pass()
        {
            Vector4[] forward = DrawBox("Forward", "UniversalPipeline", floor: false);
            Vector4[] depth = DrawBox("DepthOnly", "UniversalPipeline", floor: false),
                normals = DrawBox("DepthNormals", "UniversalPipeline", floor: false);
            int drawn = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                {
                    int i = y * Width + x;
                    bool edge = forward[i].w > 0;
                    drawn += edge ? 1 : 0;
                    Assert.That(depth[i].x > 0, Is.EqualTo(edge), $"depth of pixel {x}, {y}");
                    Vector3 toEye = -camera.ScreenPointToRay(new Vector3(x + 0.5f, y + 0.5f, 0)).direction;
                    if (edge)
                        Assert.That(Vector3.Distance(normals[i], toEye), Is.LessThan(0.02f), $"normal of pixel {x}, {y}: towards the eye");
                    else
                        Assert.That(normals[i], Is.EqualTo(Vector4.zero), $"normal of pixel {x}, {y}");
                }
            Assert.That(drawn, Is.GreaterThan(100));
        }

        [Test]
        public void The_floor_casts_a_shadow_only_if_it_is_asked_to([Values(ShadowCastingMode.On, ShadowCastingMode.Off)] ShadowCastingMode casts)
        {
            SetBox(Matrix4x4.Translate(new Vector3(-0.5f, 2, -0.5f)));      // 1 m across, 2 m over the plane
            block.SetFloat("_DrawFloor", 1);
            var draw = new RenderParams(MaterialOf("Domain.shader")) { worldBounds = new Bounds(new Vector3(0, 2, 0), Vector3.one * 3),
                matProps = block, shadowCastingMode = casts, receiveShadows = true };
            Graphics.RenderPrimitives(draw, MeshTopology.Triangles, FloorVertices);
            PlayerLoop.Frame(1f / 60);
            float beside = At(new Vector3(1.5f, 0, 0)).x;
            Assert.That(At(Vector3.zero).x, casts == ShadowCastingMode.On
                ? (NUnit.Framework.Constraints.IResolveConstraint)Is.LessThan(0.8f * beside) : Is.EqualTo(beside).Within(1e-3f));
        }

        [Test]
        public void The_floor_is_shaded_by_a_sphere_over_it()
        {
            SetBox(Matrix4x4.TRS(new Vector3(0, 0.1f, 0), Quaternion.identity, new Vector3(6, 1, 6))
                * Matrix4x4.Translate(new Vector3(-0.5f, 0, -0.5f)));
            block.SetFloat("_DrawFloor", 1);
            block.SetFloat("_FloorTile", 100);      // of one color
            var draw = new RenderParams(MaterialOf("Domain.shader")) { worldBounds = new Bounds(Vector3.zero, Vector3.one * 6),
            matProps = block, shadowCastingMode = ShadowCastingMode.Off, receiveShadows = true };
            Graphics.RenderPrimitives(draw, MeshTopology.Triangles, FloorVertices);
            DrawFrame();
            Assert.That(At(new Vector3(0, 0.1f, 0)).x, Is.LessThan(0.8f * At(new Vector3(1.5f, 0.1f, 0)).x));
        }

        [Test]
        public void A_new_box_casts_no_shadow_and_new_particles_do()
        {
            var fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            Assert.That(fluid.AddComponent<DomainRenderer>().CastShadows, Is.EqualTo(ShadowCastingMode.Off));
            Assert.That(fluid.AddComponent<ParticleRenderer>().CastShadows, Is.EqualTo(ShadowCastingMode.On));
        }

        Vector4[] DrawBox(string pass, string pipeline, bool floor)
        {
            Material material = MaterialOf("Domain.shader", pipeline);
            block.SetFloat("_DrawFloor", floor ? 1 : 0);
            return Draw(material, pass, (cmd, index) => cmd.DrawProcedural(Matrix4x4.identity, material, index, floor
                ? MeshTopology.Triangles : MeshTopology.Lines, floor ? FloorVertices : EdgeVertices, 1, block));
        }

        // Computes where the rays through the centers of the pixels meet the floor, by hand.
        void EachFloorPixel(System.Action<int, Vector3> assert)
        {
            Vector3 corner = box.MultiplyPoint3x4(Vector3.zero), up = box.MultiplyVector(Vector3.up).normalized;
            int hits = 0;
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                {
                    Ray ray = camera.ScreenPointToRay(new Vector3(x + 0.5f, y + 0.5f, 0));
                    Vector3 point = ray.origin + ray.direction * (Vector3.Dot(corner - ray.origin, up) / Vector3.Dot(ray.direction, up));
                    Vector3 at = box.inverse.MultiplyPoint3x4(point);
                    if (at.x < 0.03f || at.x > 0.97f || at.z < 0.03f || at.z > 0.97f)
                        continue;
                    hits++;
                    assert(y * Width + x, point);
                }
            Assert.That(hits, Is.GreaterThan(300));
        }
    }
}
