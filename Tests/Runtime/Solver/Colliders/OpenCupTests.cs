using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Open cups of meshes that are shaken: what leaves them goes over the rim.</summary>
    [Category("LongRun")]
    public class OpenCupTests
    {
        const float Spacing = 0.05f;

        // A minute of each is in the report's extremes.
        const int Steps = 75;

        [Test]
        public void A_cup_that_is_shaken_gently_holds_all_its_water()
            => AssertNobodyGoesThrough(OpenCup.Solid(1f), 0.5f, DeepWater.On, OpenCup.Gently, 0f, 0f);

        [Test]
        public void A_thin_open_shell_that_is_shaken_gently_holds_all_its_water()
            => AssertNobodyGoesThrough(OpenCup.Shell(0.5f), 0.25f, DeepWater.Off, OpenCup.Gently, 0f, 0f);

        [Test]
        public void Water_that_is_thrown_out_of_a_cup_goes_over_its_rim()
            => AssertNobodyGoesThrough(OpenCup.Solid(1f), 0.5f, DeepWater.Off, OpenCup.Hard, 0.1f, 1f);

        [Test]
        public void Water_that_is_thrown_out_of_a_thin_shell_goes_over_its_rim()
            => AssertNobodyGoesThrough(OpenCup.Shell(0.5f), 0.25f, DeepWater.On, OpenCup.Hard, 0.1f, 1f);

        [Test]
        public void The_tracer_tells_a_way_through_the_wall_from_one_over_the_rim()
        {
            OpenCup cup = OpenCup.Solid(1f);
            var tracer = new OpenCup.Tracer(cup);
            RigidPose pose = OpenCup.Hard(0.7f);
            float4 At(float x, float y) => new float4(pose.position + math.mul(pose.rotation, new float3(x, y, 0f)), 0f);
            var ids = new uint[] { 5, 9, 2, 7 };
            // Over the rim; through the wall; through the floor; stays.
            tracer.Observe(ids, new[] { At(6f, 13f), At(6f, 13f), At(0f, 1f), At(0f, 2f) }, pose);
            Assert.That(tracer.Inside, Is.EqualTo(4));
            tracer.Observe(ids, new[] { At(7f, 14.6f), At(8.6f, 13f), At(0f, -1.5f), At(1f, 3f) }, pose);
            tracer.Observe(ids, new[] { At(9f, 13f), At(9f, 12f), At(0f, -2.5f), At(1f, 15f) }, pose);
            tracer.Observe(ids, new[] { At(9f, 11f), At(9f, 11f), At(0f, -3.5f), At(1f, 12f) }, pose);
            Assert.That(tracer.Through, Is.EqualTo(2));
            Assert.That(tracer.OverTheRim, Is.EqualTo(2), "one of which fell back");
            Assert.That(tracer.Inside, Is.EqualTo(1));
        }

        static void AssertNobodyGoesThrough(OpenCup cup, float voxel, DeepWater deepWater, System.Func<float, RigidPose> motion,
            float minOut, float maxOut)
        {
            SignedDistanceField field = cup.Bake(voxel);
            try
            {
                SolverSettings settings = SolverSettings.Default;
                settings.deepWater = deepWater;
                settings.iterations = 2;
                float3[] water = OpenCup.Water(motion(0f));
                using (var fluid = new TestFluid(OpenCup.Box * Spacing, Spacing, water.Length, settings))
                {
                    for (int i = 0; i < water.Length; i++)
                        water[i] *= Spacing;
                    fluid.Add(water);
                    var tracer = new OpenCup.Tracer(cup);
                    ColliderMotion collider = OpenCup.Obstacle(field, motion(0f));
                    for (int step = 0; step <= Steps; step++)
                    {
                        RigidPose pose = motion(step / 60f);
                        if (step > 0)
                        {
                            collider.start = collider.end;
                            collider.end = OpenCup.OfField(field, pose);
                            ColliderTests.Use(fluid, collider);
                            fluid.Step();
                        }
                        ParticleState state = fluid.Read();
                        tracer.Observe(state.ids, state.positions, pose);
                        Assert.That(tracer.Through, Is.Zero, $"through wall or floor after {step} steps");
                    }
                    TestContext.Out.WriteLine($"{tracer.OverTheRim} of {fluid.Added} over the rim, {tracer.Inside} inside");
                    fluid.MeasureWhole();
                    Assert.That(tracer.OverTheRim, Is.InRange(minOut * fluid.Added, maxOut * fluid.Added));
                    if (maxOut == 0f)
                        Assert.That(tracer.Inside, Is.EqualTo(fluid.Added));
                }
            }
            finally
            {
                Object.DestroyImmediate(field.Texture);
                Object.DestroyImmediate(field);
            }
        }
    }
}
