using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.TestTools;
using static Rill.Tests.WaterScene;

namespace Rill.Tests
{
    /// <summary>Size of the surface's textures, and when they are made: for what the fluid covers of the picture, and not again for each
    /// size.</summary>
    public class SurfaceTexturesTests
    {
        const int Size = 256;       // pixels
        const int BytesOfTexel = 60;        // nearest faces, twice, and their depth; three of rays; spray

        WaterScene scene;

        [SetUp]
        public void Make() => scene = new WaterScene(Size);

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        // Works like a pipeline with dynamic resolution: another size in each frame.
        [UnityTest, Category("LongRun")]
        public IEnumerator A_picture_whose_size_swings_makes_no_new_textures_and_shows_the_same([Values] bool refracts)
        {
            scene.Surface.Refraction = refracts;
            RenderTexture[] targets = { scene.Target, scene.NewTarget(200, 200), scene.NewTarget(144, 144), scene.NewTarget(234, 234) };
            yield return scene.Settle(10);
            float4[] steady = scene.Pixels();
            HashSet<int> before = null;
            for (int i = 0; i < 150; i++)
            {
                scene.Camera.targetTexture = targets[i % targets.Length];
                yield return null;
                if (i == 2 * targets.Length)
                    before = Textures().Select(texture => texture.GetInstanceID()).ToHashSet();
                if (i > 2 * targets.Length)
                    Assert.That(Textures().Select(texture => texture.GetInstanceID()), Is.EquivalentTo(before), $"frame {i}");
            }
            scene.Camera.targetTexture = scene.Target;
            yield return null;
            float4[] swung = scene.Pixels();
            float worst = steady.Select((pixel, i) => math.cmax(math.abs(pixel.xyz - swung[i].xyz))).Max();
            Assert.That(Textures().Select(texture => texture.GetInstanceID()), Is.EquivalentTo(before));
            Assert.That(worst, Is.LessThan(0.004f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator They_are_as_large_as_the_fluid_is_on_the_picture_and_go_when_it_is_not_on_it()
        {
            scene.Surface.Refraction = false;
            scene.Camera.orthographicSize = 2f;
            scene.Camera.transform.position += new Vector3(1f, 0f, 0.3f);
            yield return scene.Settle(4);
            long small = Bytes();
            Assert.That(small, Is.LessThan(BytesOfTexel * Size * Size / 5), "a quarter of the width, and room to spare");
            Vector3 aside = scene.Camera.transform.position;
            scene.Camera.orthographicSize = 0.3f;
            scene.Camera.transform.position = new Vector3(0f, 3f, 0f);
            yield return Frames(6);     // what was too small is kept for three
            Assert.That(Bytes(), Is.InRange(4 * small, BytesOfTexel * Size * Size), "all of the picture");
            scene.Camera.orthographicSize = 2f;
            scene.Camera.transform.position = aside;
            yield return Frames(260);
            Assert.That(Bytes(), Is.LessThanOrEqualTo(small), "after a while");
            scene.Camera.transform.position += 50f * Vector3.right;
            yield return Frames(6);
            Assert.That(Textures(), Is.Empty, "it looks away");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Waters_and_cameras_share_what_they_need_one_after_the_other()
        {
            GameObject copy = scene.Keep(Object.Instantiate(scene.Root));
            copy.transform.position = Vector3.right;
            scene.Camera.orthographicSize = 2f;
            scene.NewCamera(scene.NewTarget(2 * Size, Size), new Vector3(0f, 3f, 0f));
            scene.Root.SetActive(true);
            copy.SetActive(true);
            yield return Frames(6);
            Assert.That(Named("Rill.Water.RayFaces"), Is.EqualTo(4), "a fluid and a camera each");
            Assert.That(Named("Rill.Water.Faces"), Is.EqualTo(1));
            Assert.That(Named("Rill.Water.Scene"), Is.EqualTo(1));
            copy.SetActive(false);
            scene.Root.SetActive(false);
            yield return null;
            Assert.That(Textures(), Is.Empty);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_change_of_quality_is_seen_while_it_is_paused()
        {
            scene.AddFloor(1f);
            Look(scene.Camera, new Vector3(0.5f, 0.9f, -3f));
            yield return scene.Settle(10);
            float4[] medium = scene.Pixels();
            scene.Surface.Quality = SurfaceQuality.High;
            yield return Frames(2);
            Assert.That(scene.Fluid.Solver.Mesh.Cell, Is.EqualTo(0.5f));
            Assert.That(scene.Pixels(), Is.Not.EqualTo(medium));
            scene.Surface.Quality = SurfaceQuality.Medium;
            yield return Frames(2);
            Assert.That(scene.Fluid.Solver.Mesh.Cell, Is.EqualTo(0.75f));
        }

        [Test]
        public void A_size_grows_at_once_with_room_and_shrinks_when_a_second_has_not_needed_it()
        {
            ScreenSize size = default;
            Assert.That(size.Fit(500, 300, 1920, 1080), Is.True);
            Assert.That((size.Width, size.Height), Is.EqualTo((544, 320)));
            Assert.That(size.Fit(540, 200, 1920, 1080), Is.False, "within the room");
            Assert.That(size.Fit(600, 310, 1920, 1080), Is.True);
            Assert.That((size.Width, size.Height), Is.EqualTo((640, 320)));
            Assert.That(size.Fit(1900, 1070, 1920, 1080), Is.True);
            Assert.That((size.Width, size.Height), Is.EqualTo((1920, 1080)), "no room beyond the picture");
            for (int i = 0; i < 240; i++)
                Assert.That(size.Fit(i % 30 == 0 ? 1800 : 200, 1000, 1920, 1080), Is.False, "that swings");
            int made = Enumerable.Range(0, 240).Count(_ => size.Fit(200, 100, 1920, 1080));
            Assert.That(made, Is.InRange(1, 2));
            Assert.That((size.Width, size.Height), Is.EqualTo((224, 128)));
        }

        // 864 x 448: three quarters of it are 290,304 texels.
        [Test]
        public void A_size_shrinks_after_a_second_to_less_than_three_quarters_and_to_no_more()
        {
            ScreenSize size = default;
            size.Fit(800, 400, 1920, 1080);
            Assert.That((size.Width, size.Height), Is.EqualTo((864, 448)));
            for (int i = 0; i < 180; i++)
                Assert.That(size.Fit(720, 360, 1920, 1080), Is.False, "768 x 384 are 294,912");
            for (int i = 0; i < 59; i++)
                Assert.That(size.Fit(680, 360, 1920, 1080), Is.False, $"frame {i} of a second of 60");
            Assert.That(size.Fit(680, 360, 1920, 1080), Is.True, "736 x 384 are 282,624");
            Assert.That((size.Width, size.Height), Is.EqualTo((736, 384)));
        }

        static int Named(string name) => Textures().Count(texture => texture.name == name);

        static RenderTexture[] Textures() => Resources.FindObjectsOfTypeAll<RenderTexture>()
            .Where(texture => texture.name.StartsWith("Rill.Water") && !texture.name.Contains("Sun") && texture.IsCreated()).ToArray();

        // But for the copy of the scene's depth, which is of the whole picture.
        static long Bytes() => Textures().Where(texture => texture.name != "Rill.Water.Scene").Sum(texture => (long)texture.width * texture.height
            * (texture.graphicsFormat == GraphicsFormat.R32G32B32A32_SFloat ? 16 : texture.graphicsFormat == GraphicsFormat.R16G16B16A16_SFloat ? 8
            : 4));
    }
}
