using System.Collections;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static Rill.Tests.WaterScene;

namespace Rill.Tests
{
    /// <summary>Several cameras, several waters, and cameras of other kinds: each shows its own.</summary>
    public class SurfaceCameraTests
    {
        const int Size = 64;        // pixels

        WaterScene scene;

        [SetUp]
        public void Make() => scene = new WaterScene(Size);

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        [UnityTest]
        public IEnumerator A_camera_that_leaves_out_its_layer_does_not_see_it()
        {
            scene.Root.SetActive(true);
            scene.Camera.cullingMask = ~(1 << scene.Root.layer);
            yield return Frames(4);
            Assert.That(scene.Mean(), Is.EqualTo(Color.white));
            Assert.That(Resources.FindObjectsOfTypeAll<RenderTexture>().Where(texture => texture.IsCreated()),
                Has.None.Property("name").StartsWith("Rill.Water"), "nothing is made for it");
            scene.Camera.cullingMask = ~0;
            yield return Frames(4);
            Assert.That(scene.Mean().r, Is.LessThan(0.5f));
        }

        [UnityTest]
        public IEnumerator Two_cameras_see_it_each_from_its_own_side()
        {
            RenderTexture other = scene.NewTarget(Size, Size);
            scene.NewCamera(other, new Vector3(0f, -0.2f, -3f));
            scene.Root.SetActive(true);
            yield return Frames(20);
            Color fromAbove = scene.Mean(), fromTheSide = Mean(other);
            // 0.6 m from above; a meter from the side, where it reaches up to the center of the picture and beyond.
            Assert.That(fromAbove.g, Is.EqualTo(0.9596f * Mathf.Pow(Left.y, Depth / 0.5f)).Within(0.02f));
            Assert.That(fromTheSide.g, Is.LessThan(fromAbove.g));
        }

        [UnityTest]
        public IEnumerator A_camera_shows_the_same_beside_another_as_alone()
        {
            yield return scene.Settle(10);
            float4[] alone = scene.Pixels();
            RenderTexture other = scene.NewTarget(2 * Size, Size);
            scene.NewCamera(other, new Vector3(0f, -0.2f, -3f));
            yield return Frames(2);
            float4[] together = scene.Pixels(), asideTogether = Pixels(other);
            scene.Camera.enabled = false;
            yield return Frames(2);
            Assert.That(together, Is.EqualTo(alone));
            Assert.That(asideTogether, Is.EqualTo(Pixels(other)));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Of_two_waters_that_overlap_the_nearer_one_hides_the_other([Values(true, false)] bool nearerIsFirst)
        {
            // A copy of it, clear, half a meter aside and a meter up or down.
            GameObject copy = scene.Keep(Object.Instantiate(scene.Root));
            copy.transform.position = new Vector3(0.5f, nearerIsFirst ? -1f : 1f, 0f);
            copy.GetComponent<FluidSurface>().Look = Absorbing(1f, 0.5f);
            scene.Root.SetActive(true);
            copy.SetActive(true);
            yield return Frames(20);
            float left = scene.Mean(4, 28, 16, 48).g, right = scene.Mean(36, 60, 16, 48).g;
            TestContext.Out.WriteLine($"{left:0.000} of one, {right:0.000} of both");
            float dark = 0.9596f * Mathf.Pow(Left.y, Depth / 0.5f);
            Assert.That(left, Is.EqualTo(dark).Within(0.02f), "one alone");
            Assert.That(right, nearerIsFirst ? Is.EqualTo(dark).Within(0.02f) : Is.GreaterThan(0.9f),
                "the nearer one before the opaque scene, without the other");
        }

        [UnityTest]
        public IEnumerator The_shadow_is_copied_for_cameras_that_see_it_alone()
        {
            Light sun = scene.AddSun();
            sun.type = LightType.Directional;
            sun.shadows = LightShadows.Hard;
            sun.enabled = true;
            yield return scene.Settle(4);
            CommandBuffer copy = sun.GetCommandBuffers(LightEvent.AfterShadowMap)[0];
            Assert.That(copy.sizeInBytes, Is.GreaterThan(0));
            scene.Camera.transform.position += 50f * Vector3.right;
            yield return Frames(1);
            Assert.That(copy.sizeInBytes, Is.Zero);
            scene.Camera.transform.position -= 50f * Vector3.right;
            yield return Frames(1);
            Assert.That(copy.sizeInBytes, Is.GreaterThan(0));
        }

        // From an angle, over a floor of two colors: what is refracted is looked up beside where it is seen.
        void LookAcross(Camera camera)
        {
            scene.AddFloor(1f);
            GameObject floor = scene.NewSolid(PrimitiveType.Quad, new float3(0.1f, 0.6f, 0.3f));
            floor.transform.rotation = Quaternion.LookRotation(Vector3.down);
            floor.transform.position = new Vector3(-0.55f, -0.5f, 0.1f);
            camera.orthographicSize = 0.6f;
            Look(camera, new Vector3(0.5f, 0.9f, -3f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator In_a_part_of_the_screen_it_looks_as_on_the_whole()
        {
            LookAcross(scene.Camera);
            RenderTexture second = scene.NewTarget(Size, Size), screen = scene.NewTarget(2 * Size, Size);
            Camera other = scene.NewCamera(second, new Vector3(0f, 3f, 0f));
            yield return scene.Settle(10);
            float4[][] whole = { Pixels(second), scene.Pixels() };
            // Two players beside each other.
            other.targetTexture = scene.Camera.targetTexture = screen;
            other.rect = new Rect(0f, 0f, 0.5f, 1f);
            scene.Camera.rect = new Rect(0.5f, 0f, 0.5f, 1f);
            yield return Frames(3);
            float4[] both = Pixels(screen);
            for (int half = 0; half < 2; half++)
            {
                float most = whole[half].Select((pixel,
                    i) => math.cmax(math.abs(pixel.xyz - both[i / Size * 2 * Size + half * Size + i % Size].xyz))).Max();
                Assert.That(whole[half].Count(pixel => pixel.y < 0.5f), Is.GreaterThan(Size * Size / 4), "water");
                Assert.That(most, Is.LessThan(0.004f), half == 0 ? "the left one" : "the right one");
            }
            scene.Root.SetActive(false);
            yield return null;
            Assert.That(scene.Camera.forceIntoRenderTexture, Is.False, "the camera is as it was");
        }

        // A near plane through a point of the world, which leaves what lies along the normal; as the cameras of planar mirrors have it.
        static void SetNearPlane(Camera camera, Vector3 point, Vector3 normal)
        {
            camera.ResetProjectionMatrix();
            Matrix4x4 toCamera = camera.worldToCameraMatrix;
            Vector4 plane = toCamera.MultiplyVector(normal.normalized);
            plane.w = -Vector3.Dot(toCamera.MultiplyPoint3x4(point), plane);
            camera.projectionMatrix = camera.CalculateObliqueMatrix(plane);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_tilted_near_plane_before_all_that_is_seen_changes_nothing([Values] bool perspective, [Values] bool refracts)
        {
            LookAcross(scene.Camera);
            // In the water: how much of that is before it is a matter of its depth.
            Transform post = scene.NewPrimitive(PrimitiveType.Cube, scene.Keep(new Material(Shader.Find("Rill/Solid")))).transform;
            post.position = new Vector3(0f, -0.2f, -0.25f);
            post.localScale = new Vector3(0.4f, 0.8f, 0.1f);
            scene.Surface.Refraction = refracts;
            scene.Camera.orthographic = !perspective;
            scene.Camera.fieldOfView = 25f;
            yield return scene.Settle(10);
            float4[] straight = scene.Pixels();
            foreach (Vector3 tilt in new[] { Vector3.right, Vector3.up, new Vector3(-0.6f, 0.4f, 0f) })
            {
                Transform eye = scene.Camera.transform;
                SetNearPlane(scene.Camera, eye.position + 1.8f * eye.forward, eye.forward + 0.5f * (eye.rotation * tilt));
                yield return Frames(2);
                float[] differences = scene.Pixels().Select((pixel, i) => math.cmax(math.abs(pixel.xyz - straight[i].xyz))).ToArray();
                TestContext.Out.WriteLine($"{differences.Max():0.0000} at most, {differences.Count(one => one > 0.004f)} pixels");
                // If a bent ray only just passes the post, or only just leaves the picture, rounding decides.
                Assert.That(differences.Count(one => one > 0.004f), Is.LessThanOrEqualTo(refracts ? Size * Size / 25 : 0), $"{tilt}");
            }
            Assert.That(straight.Count(pixel => pixel.y < 0.5f), Is.GreaterThan(Size * Size / 4), "water");
        }

        [UnityTest]
        public IEnumerator What_a_tilted_near_plane_cuts_off_is_not_drawn_and_the_rest_is_as_before()
        {
            scene.AddFloor(1f);
            yield return scene.Settle(10);
            float4[] whole = scene.Pixels();
            // Through the center of the picture where the water's surface is, and steep: of the left half nothing is left.
            SetNearPlane(scene.Camera, new Vector3(0f, Depth - 0.5f, 0f), new Vector3(1f, -0.1f, 0f));
            yield return Frames(2);
            float4[] half = scene.Pixels();
            for (int y = 0; y < Size; y++)
                for (int x = 0; x < Size; x++)
                {
                    float4 expected = x < Size / 2 ? new float4(1f) : whole[y * Size + x];
                    if (x < Size / 2 - 8 || x > Size / 2 + 12)      // but for the particles that it cuts
                        Assert.That(math.cmax(math.abs(half[y * Size + x].xyz - expected.xyz)), Is.LessThan(0.02f), $"({x}, {y})");
                }
        }
    }
}
