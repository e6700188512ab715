using System.Collections;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Foam that lies evenly on a flat black pool, which a camera sees from straight above.</summary>
    public class FoamWebTests
    {
        const int Pixels = 96;
        const float Spacing = 0.05f, Half = 0.15f;      // m; half the height of the picture
        const float TexelsPerSpacing = Pixels * Spacing / (2f * Half);
        const float Radius = 0.004f;        // m

        MeshScene scene;
        FluidFoam foam;

        [SetUp]
        public void Begin()
        {
            scene = MeshScene.FromAbove(Pixels, Spacing, Half);
            scene.Surface.Sun.intensity = 1f;
            scene.Surface.Sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.8f, -0.6f, 0f));
            foam = scene.Fluid.gameObject.AddComponent<FluidFoam>();
            foam.Radius = Radius;
            foam.Color = Color.white;
            FoamSettings settings = foam.Settings;
            (settings.amount, settings.budget) = (0f, 1 << 17);
            foam.Settings = settings;
        }

        [TearDown]
        public void End()
        {
            scene.Dispose();
            Time.captureDeltaTime = 0f;
        }

        // Foam that lies so densely that nothing is seen through it has a cover of 1.
        [UnityTest]
        public IEnumerator Covers_as_much_as_its_depth_says_in_lines_and_holes([Values(0.15f, 0.5f, 1.5f)] float depth)
        {
            yield return Put(8f, 0f);
            float white = Covers().Average();
            yield return Put(depth, 0f);
            float[] covers = Covers().Select(cover => cover / white).ToArray();
            float mean = covers.Average(), between = covers.Count(cover => cover > 0.3f && cover < 0.7f) / (float)covers.Length;
            float due = 1f - math.exp(-depth);
            float spread = math.sqrt(covers.Average(cover => (cover - mean) * (cover - mean)) / (due * (1f - due)));
            TestContext.Out.WriteLine($"covers {mean}, due {due}; spread {spread} of that of lines and holes; {between} is neither");
            Assert.That(mean, Is.EqualTo(due).Within(0.025f));
            Assert.That(spread, Is.GreaterThan(0.4f));
            Assert.That(between, Is.LessThan(0.4f));
        }

        [UnityTest]
        public IEnumerator Stays_where_it_is_when_the_camera_moves()
        {
            const int shift = 12;
            yield return Put(0.5f, 0f);
            float[] before = Centered(Covers());
            scene.Camera.transform.position -= new Vector3(shift / TexelsPerSpacing * Spacing, 0f, 0f);
            yield return WaterScene.Frames(1);
            float[] after = Centered(Covers());
            float moved = MeshScene.Likeness(before, after, shift), stayed = MeshScene.Likeness(before, after, 0);
            TestContext.Out.WriteLine($"alike where it was in the world: {moved}, on the picture: {stayed}");
            Assert.That(moved, Is.GreaterThan(0.97f));
            Assert.That(stayed, Is.LessThan(0.3f));
        }

        // In frames between two steps.
        [UnityTest]
        public IEnumerator Goes_with_the_flow()
        {
            const int shift = 4;
            yield return Put(0.5f, shift * 8f / TexelsPerSpacing);
            Time.captureDeltaTime = 1f / 480f;
            yield return WaterScene.Frames(1);
            float[] before = Centered(Covers());
            yield return WaterScene.Frames(1);
            float[] after = Centered(Covers());
            float carried = MeshScene.Likeness(before, after, shift), stayed = MeshScene.Likeness(before, after, 0);
            float against = MeshScene.Likeness(before, after, -shift);
            TestContext.Out.WriteLine($"alike where the flow has carried it: {carried}, where it was: {stayed}, against the flow: {against}");
            Assert.That(carried, Is.GreaterThan(0.95f));
            Assert.That(stayed, Is.LessThan(0.5f));
            Assert.That(against, Is.LessThan(0.3f));
        }

        [UnityTest]
        public IEnumerator Cells_smaller_than_some_texels_are_seen_as_their_mean()
        {
            foam.Radius = 3f / TexelsPerSpacing * Spacing / 4f;     // a cell of three texels
            yield return Put(0.5f, 0f);
            float[] covers = Covers();
            Assert.That(covers.Max() - covers.Min(), Is.LessThan(0.1f * covers.Average()));
        }

        // depth: optical, of all foam; displacement: of the water in the last substep, d.
        IEnumerator Put(float depth, float displacement)
        {
            scene.Put(p => -p.y, displacement: new Vector3(displacement, 0f, 0f));
            scene.Fluid.Restart();
            Time.captureDeltaTime = 1f / 60f;
            yield return WaterScene.Frames(3);
            Time.captureDeltaTime = 1f / 120f;      // halfway to the next step, in which foam without particles around would begin to fly
            yield return WaterScene.Frames(1);
            // On a lattice that is narrower than the patches, over more than the picture.
            float radius = foam.Radius, step = 0.5f * radius, width = 2.6f * Half;
            int across = (int)(width / step);
            foam.Opacity = depth * step * step / (math.PI * radius * radius);
            FoamStage.Plant(scene.Fluid.Solver.Foam, Enumerable.Range(0, across * across).Select(i =>
            {
                float3 at = new float3((i % across + 0.5f) * step - 0.5f * width + 0.5f, 0.5f, (i / across + 0.5f) * step - 0.5f * width + 0.5f);
                return FoamStage.Particle(at / Spacing, 0f, FoamKinds.Foam, 20f, 100f);
            }).ToArray());
            Time.captureDeltaTime = 1e-4f;
            yield return WaterScene.Frames(1);
        }

        float[] Covers() => scene.Pixels().Select(pixel => pixel.y).ToArray();

        static float[] Centered(float[] values)
        {
            float mean = values.Average();
            return values.Select(value => value - mean).ToArray();
        }
    }
}
