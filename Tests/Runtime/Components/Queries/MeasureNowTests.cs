using System;
using NUnit.Framework;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Probes, detectors and batches that wait.</summary>
    public class MeasureNowTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void A_probe_and_a_detector_tell_of_the_water_as_it_stands_without_a_frame()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            {
                scene.Run(2);
                FluidProbe probe = scene.Add<FluidProbe>(new Vector3(0f, -0.15f, 0f), Vector3.forward, _ => { });
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, -0.2f, 0f), Vector3.forward, d => d.Size = 0.1f * Vector3.one);
                Assert.That(probe.Latest.valid || detector.Latest.valid, Is.False, "nothing was asked yet");
                FluidProbeSample water = probe.MeasureNow();
                Assert.That((water.valid, water.hasSurface, water.step), Is.EqualTo((true, true, scene.Fluid.StepCount)));
                Assert.That(water.height, Is.EqualTo(0f).Within(Spacing));
                Assert.That(detector.Latest.fill, Is.EqualTo(1f).Within(0.05f), "all of the fluid are measured at once");

                detector.transform.position = new Vector3(0f, 0.2f, 0f);
                probe.transform.position = new Vector3(0.1f, -0.2f, 0.1f);
                Assert.That(detector.MeasureNow().volume, Is.Zero, "where it is now");
                Assert.That(probe.Latest.position, Is.EqualTo(new Vector3(0.1f, -0.2f, 0.1f)));

                scene.Fluid.RemoveInside(FluidShape.Box(Vector3.zero, 2f * Vector3.one));
                Assert.That(probe.MeasureNow().hasSurface, Is.False, "what a script has removed is gone");
            }
        }

        [Test]
        public void It_may_be_called_any_number_of_times_in_a_frame()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            {
                scene.Run(1);
                FluidProbe probe = scene.Add<FluidProbe>(new Vector3(0f, -0.15f, 0f), Vector3.forward, _ => { });
                for (int i = 0; i < 12; i++)
                {
                    probe.transform.position = new Vector3(0.02f * i, -0.15f, 0f);
                    Assert.That(probe.MeasureNow().position.x, Is.EqualTo(0.02f * i).Within(1e-6f));
                }
                scene.Run(3);
                Assert.That(probe.Flushed().step, Is.EqualTo(scene.Fluid.StepCount));
            }
        }

        [Test]
        public void A_batch_has_the_answers_to_what_was_set_last()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            using (var batch = new FluidQueryBatch(scene.Fluid, points: 2, rays: 1))
            {
                scene.Run(1);
                batch.SetPoints(new[] { new Vector3(0f, -0.15f, 0f), new Vector3(0f, 0.2f, 0f) }, 0, 2);
                batch.RayCount = 1;
                batch.SetRay(0, new FluidRay(new Vector3(0f, 0.25f, 0f), Vector3.down));
                batch.MeasureNow();
                Assert.That(batch.IsPending, Is.False);
                Assert.That(batch.TryGetSample(0, out FluidProbeSample water) && water.density > 0.9f);
                Assert.That(batch.TryGetSample(1, out FluidProbeSample air) && air.density < 0.1f);
                Assert.That(batch.TryGetHit(0, out FluidRayHit hit) && hit.hit);
                Assert.That(hit.point.y, Is.EqualTo(0f).Within(Spacing));
            }
        }

        [Test]
        public void A_fluid_that_is_off_gives_a_sample_that_is_not_valid()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            {
                scene.Run(1);
                FluidProbe probe = scene.Add<FluidProbe>(new Vector3(0f, -0.15f, 0f), Vector3.forward, _ => { });
                scene.Fluid.enabled = false;
                Assert.That(probe.MeasureNow().valid, Is.False);
            }
        }

        // By the result that is pending: the fluid has other buffers then.
        [Test]
        public void A_listener_may_make_the_fluid_begin_again()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            {
                FluidSimulation fluid = scene.Fluid;
                fluid.KeepStateOnDisable = false;
                FluidDetector detector = scene.Add<FluidDetector>(new Vector3(0f, 0.2f, 0f), Vector3.forward, d => d.Size = 0.1f * Vector3.one);
                scene.Step();
                Assert.That(detector.MeasureNow().volume, Is.Zero);
                detector.transform.position = new Vector3(0f, -0.2f, 0f);
                scene.Step();
                bool began = false;
                detector.OnEnter += () =>
                {
                    if (began)
                        return;
                    began = true;
                    fluid.enabled = false;
                    fluid.enabled = true;
                };
                fluid.MeasureQueriesNow();
                Assert.That(began);
                Assert.That(detector.Latest.fill, Is.EqualTo(1f).Within(0.05f), "of the water that it began with");
            }
        }

        [Test]
        public void In_a_pass_of_a_step_it_says_when_to_call_it()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 2000).Fill(0.3f))
            {
                Exception thrown = null;
                scene.Fluid.BeforeStep += (commands, particles) =>
                {
                    try
                    {
                        scene.Fluid.MeasureQueriesNow();
                    }
                    catch (InvalidOperationException problem)
                    {
                        thrown = problem;
                    }
                };
                scene.Run(1);
                Assert.That(thrown?.Message, Does.Contain("BeforeStep"));
            }
        }
    }
}
