using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Fluids on devices of 256 threads, 16 KB of groupshared memory and 8 storage buffers.</summary>
    public class SmallDeviceTests
    {
        static readonly DeviceLimits Small = new DeviceLimits(8, 8, 256, 16384);

        static SourceScene Scene(DeviceLimits limits, DeepWater deepWater = DeepWater.Off)
        {
            var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 6000, deepWater);
            scene.Fluid.KeepStateOnDisable = false;
            scene.Fluid.enabled = false;
            scene.Fluid.Support.PretendedLimits = limits;
            scene.Fluid.enabled = true;
            return scene.Fill(0.2f);
        }

        static void AddJets(SourceScene scene)
        {
            for (int i = 0; i < 2; i++)
                scene.Add<FluidEmitter>(new Vector3(0.4f * i - 0.2f, 0.4f, 0f), Vector3.down, emitter =>
                {
                    emitter.Rate = 0.05f;
                    emitter.Speed = 4f;
                    emitter.Radius = 0.1f;
                    emitter.Spread = 10f;
                });
        }

        [Test]
        public void A_fluid_with_emitters_ends_in_the_same_bits_as_on_a_large_device()
        {
            using (SourceScene here = Scene(DeviceLimits.Current), there = Scene(Small))
            {
                foreach (SourceScene scene in new[] { here, there })
                {
                    AddJets(scene);
                    scene.Step(20);
                }
                ParticleState expected = here.Read(), actual = there.Read();
                Assert.That(expected.Count, Is.GreaterThan(1700), "the jets let nothing in");
                Assert.That(actual.ids, Is.EqualTo(expected.ids));
                for (int i = 0; i < expected.Count; i++)
                    Assert.That(math.all(math.asuint(actual.positions[i].xyz) == math.asuint(expected.positions[i].xyz)),
                        $"particle {i}: {actual.positions[i]} and {expected.positions[i]}");
            }
        }

        [Test]
        public void Deep_water_stands_as_high_as_on_a_large_device()
        {
            using (SourceScene here = Scene(DeviceLimits.Current, DeepWater.On), there = Scene(Small, DeepWater.On))
            {
                float3 expected = here.Step(30).Measure().centerOfMass, actual = there.Step(30).Measure().centerOfMass;
                Assert.That(actual.y, Is.EqualTo(expected.y).Within(0.02 * 0.05));
            }
        }

        [Test]
        public void What_it_is_too_small_for_is_said_by_the_inspector_as_long_as_it_is_wanted()
        {
            LogAssert.Expect(LogType.Error, new Regex("FluidSimulation 'Fluid' goes on without elasticity: kernel .* and this device has 8"));
            using (SourceScene scene = Scene(Small))
            {
                FluidMaterial material = scene.Fluid.Material;
                material.shearModulus = 100f;
                scene.Fluid.Material = material;
                scene.Step(2);
                Assert.That(Problems(scene), Has.Count.EqualTo(1).And.Some.StartsWith("goes on without elasticity: "));
                material.shearModulus = 0f;
                scene.Fluid.Material = material;
                scene.Step();
                Assert.That(Problems(scene), Is.Empty);
            }
        }

        [TestCase(7, 256, "takes 8 storage buffers, and this device has 7")]
        [TestCase(8, 128, "has groups of 256 threads, and this device's have at most 128")]
        public void A_device_that_cannot_run_the_fluid_itself_turns_it_off_by_name(int buffers, int threads, string says)
        {
            LogAssert.Expect(LogType.Error, new Regex("FluidSimulation 'Fluid' is off: kernel .* " + Regex.Escape(says)));
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 100))
            {
                scene.Fluid.KeepStateOnDisable = false;
                scene.Fluid.enabled = false;
                scene.Fluid.Support.PretendedLimits = new DeviceLimits(buffers, buffers, threads, 16384);
                scene.Fluid.enabled = true;
                Assert.That(scene.Fluid.IsRunning, Is.False);
            }
        }

        static List<string> Problems(SourceScene scene)
        {
            var problems = new List<string>();
            ((IHasProblems)scene.Fluid).ListProblems(problems);
            return problems;
        }
    }
}
