using System.Linq;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Unity's queue of draws lasts until the next frame begins. A camera that draws several pictures in one, as scene views do while
    /// the game is paused, shows each as it is then, and its draws do not add up.</summary>
    public class QueuedDrawTests : PipelineSurfaceFixture
    {
        static readonly string[] Pipelines = { "", "Universal 14", "Universal 17", "Universal 17 by Execute", "HighDefinition 14",
            "HighDefinition 17" };

        void BuildFor(string name)
        {
            PipelineKind kind = PipelineKind.All.FirstOrDefault(one => name.StartsWith(one.Folder, System.StringComparison.Ordinal));
            Build(kind, kind == null ? null : name.Substring(kind.Folder.Length + 1));
            simulation.gameObject.AddComponent<DomainRenderer>();
            Play(3);
            simulation.Paused = true;
            Play(2);
        }

        Vector4[] Repaint()
        {
            camera.Render();
            return Pixels();
        }

        static int Unlike(Vector4[] a, Vector4[] b) => a.Where((pixel, i) => (pixel - b[i]).magnitude > 0.004f).Count();

        void Move(int step)
        {
            camera.transform.position = new Vector3(0.3f * step, 1, -4);
            camera.transform.LookAt(new Vector3(0, -0.3f, 0));
        }

        [TestCaseSource(nameof(Pipelines))]
        public void Pictures_of_a_camera_that_moves_while_paused_have_one_draw_and_no_ghost(string name)
        {
            BuildFor(name);
            int queued = DrawQueue.Draws.Count;
            var pictures = new Vector4[4][];
            for (int i = 0; i < pictures.Length; i++)
            {
                Move(i);
                pictures[i] = Repaint();
                Assert.That(DrawQueue.Draws.Count, Is.EqualTo(queued), $"picture {i}");
            }
            for (int i = 0; i < pictures.Length; i++)
            {
                Move(i);
                Play(1);
                Assert.That(Unlike(Pixels(), pictures[i]), Is.Zero, $"as in a frame of its own: {i}");
            }
            Assert.That(Unlike(pictures[3], pictures[0]), Is.GreaterThan(Width * Height / 50), "they are not the same");
            Assert.That(Errors, Is.Empty);
        }

        [TestCaseSource(nameof(Pipelines))]
        public void A_change_of_the_look_shows_at_once(string name)
        {
            BuildFor(name);
            Vector4[] water = Repaint();
            simulation.GetComponent<FluidSurface>().Preset = SurfacePreset.Milk;
            Vector4[] milk = Repaint();
            Play(1);
            Assert.That(Unlike(water, milk), Is.GreaterThan(Width * Height / 50));
            Assert.That(Unlike(Pixels(), milk), Is.Zero);
        }

        [TestCaseSource(nameof(Pipelines))]
        public void Where_the_camera_sees_the_water_no_more_nothing_is_left_of_the_picture_before(string name)
        {
            BuildFor(name);
            simulation.GetComponent<DomainRenderer>().enabled = false;
            void LookAtWater()
            {
                camera.transform.SetPositionAndRotation(new Vector3(0, 0, -2.2f), Quaternion.identity);
                camera.orthographic = false;
            }
            // From above on where the draw lies that shades, just before where the camera was: with the water beyond the picture's edge.
            void LookAside()
            {
                var down = new Vector3(0, -0.866f, 0.5f);
                camera.transform.SetPositionAndRotation(new Vector3(0, 0, -1.6f) - 3 * down, Quaternion.LookRotation(down));
                camera.orthographic = true;
                camera.orthographicSize = 0.1f;
            }
            LookAtWater();
            Play(1);
            Vector4[] water = Pixels();
            LookAside();
            Vector4[] aside = Repaint();
            LookAtWater();
            Assert.That(Unlike(Repaint(), water), Is.Zero, "back");
            simulation.gameObject.SetActive(false);
            LookAside();
            Play(1);
            Assert.That(Unlike(aside, Pixels()), Is.Zero, "as without water");
        }

        [TestCaseSource(nameof(Pipelines))]
        public void A_picture_of_another_size_in_the_same_frame_is_right_and_so_is_the_next(string name)
        {
            BuildFor(name);
            Vector4[] whole = Repaint();
            var small = new RenderTexture(target.descriptor) { width = Width / 2, height = Height / 2 };
            camera.targetTexture = small;
            Vector4[] half = Repaint(small);
            camera.targetTexture = target;
            Vector4[] again = Repaint();
            camera.targetTexture = small;
            Play(1);
            Assert.That(Unlike(half, Repaint(small)), Is.Zero);
            Assert.That(Unlike(again, whole), Is.Zero);
            Assert.That(Errors, Is.Empty);
            camera.targetTexture = target;
            small.Release();
        }

        Vector4[] Repaint(RenderTexture into)
        {
            camera.Render();
            UnityEngine.Rendering.AsyncGPUReadbackRequest request = UnityEngine.Rendering.AsyncGPUReadback.Request(into);
            request.WaitForCompletion();
            return request.GetData<Vector4>().ToArray();
        }
    }
}
