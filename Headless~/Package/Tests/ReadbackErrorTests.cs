using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Effects of an error of the graphics device instead of a result.</summary>
    public class ReadbackErrorTests : GraphicsFixture
    {
        const float FrameTime = 1f / 60f;
        const int Arrival = 2;      // frames from a request to its result

        FluidSimulation fluid;

        static GameObject Make(Type part, Transform parent, Vector3 position, Action<Component> set = null)
        {
            var made = new GameObject(part.Name);
            made.SetActive(false);
            made.transform.SetParent(parent, false);
            made.transform.localPosition = position;
            Component component = made.AddComponent(part);
            set?.Invoke(component);
            made.SetActive(true);
            return made;
        }

        T Add<T>(Vector3 position, Action<T> set = null) where T : Component
            => Make(typeof(T), fluid.transform, position, component => set?.Invoke((T)component)).GetComponent<T>();

        // Water of half a meter in a box of a meter.
        void Fill(int statisticsInterval = 0)
        {
            var made = new GameObject("Pond");
            made.SetActive(false);
            fluid = made.AddComponent<FluidSimulation>();
            fluid.Configure(Vector3.one, 0.1f, 900);
            fluid.StatisticsInterval = statisticsInterval;
            Add<FluidVolume>(new Vector3(0f, -0.25f, 0f), water => water.Size = new Vector3(1f, 0.5f, 1f));
            made.SetActive(true);
        }

        static void Frames(int count)
        {
            for (int i = 0; i < count; i++)
                PlayerLoop.Frame(FrameTime);
        }

        static void Fail(params string[] buffers) => ReadbackQueue.Fails = source => buffers.Any(source.Contains);

        static void Expect(string text) => LogAssert.Expect(LogType.Error, new Regex("^Rill: FluidSimulation 'Pond' " + text));

        int TimesLogged(string text) => Logged.Count(entry => entry.Contains(text));

        List<string> Problems()
        {
            var problems = new List<string>();
            ((IHasProblems)fluid).ListProblems(problems);
            return problems;
        }

        [Test]
        public void A_lost_measurement_leaves_no_statistics_until_the_next_and_is_logged_once()
        {
            Fill(statisticsInterval: 1);
            Frames(6);
            Assert.That(fluid.TryGetStatistics(out _));
            Expect("did not get a measurement back: the graphics device gave an error .*no statistics until the next.*lower Capacity");
            Fail("Rill.Statistics.Results");
            Frames(6);
            Assert.That(fluid.TryGetStatistics(out _), Is.False, "an old one passes for new");
            Assert.That(Problems().Single(), Does.StartWith("did not get a measurement back"));
            var refusal = Assert.Throws<InvalidOperationException>(() => fluid.Results.Measurements.MeasureNow());
            Assert.That(refusal.Message, Does.Contain("'Pond'").And.Contain("did not get a measurement back"));

            ReadbackQueue.Fails = null;
            Frames(6);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.particles, Is.EqualTo(500));
            Assert.That(Problems(), Is.Empty);
            Fail("Rill.Statistics.Results");
            Frames(6);
            Assert.That(TimesLogged("did not get a measurement"), Is.EqualTo(1));
        }

        // Unity does not say whether a callback comes as its request is waited for or after.
        [Test]
        public void A_measurement_that_is_waited_for_is_the_same_where_callbacks_are_late([Values] bool callsBackLate)
        {
            Fill();
            FluidProbe probe = Add<FluidProbe>(new Vector3(0f, -0.25f, 0f));
            Frames(3);
            ReadbackQueue.CallsBackLate = callsBackLate;
            for (int i = 0; i < 3; i++)
            {
                Assert.That(fluid.Results.Measurements.MeasureNow().particles, Is.EqualTo(500));
                fluid.Advance(FrameTime);
                fluid.FlushQueries();
                Assert.That(probe.TryGetSample(out FluidProbeSample sample));
                Assert.That(sample.step, Is.EqualTo(fluid.StepCount));
                if (i == 1)
                    Frames(1);
            }
            fluid.enabled = false;
            Frames(3);
        }

        [Test]
        public void A_lost_answer_lets_samples_grow_old_and_tells_no_event()
        {
            Fill();
            FluidProbe probe = Add<FluidProbe>(Vector3.zero);
            int told = 0;
            FluidDetector detector = Add<FluidDetector>(new Vector3(0f, -0.25f, 0f), added =>
            {
                added.Size = new Vector3(0.6f, 0.3f, 0.6f);
                added.OnEnter += () => told++;
            });
            ReadbackQueue.Fails = _ => true;
            Expect("did not get an answer to probes and detectors back: .*whose age grows, and are asked again");
            Frames(5);
            Assert.That(probe.TryGetSample(out _), Is.False, "before the first");
            Assert.That(detector.TryGetSample(out _), Is.False);
            Assert.That(told, Is.Zero);

            ReadbackQueue.Fails = null;
            Frames(5);
            Assert.That(probe.TryGetSample(out FluidProbeSample first) && detector.TryGetSample(out _));
            Assert.That(told, Is.EqualTo(1));

            Fail("Rill.Queries.Results");
            Frames(4);
            Assert.That(probe.TryGetSample(out FluidProbeSample old));
            Assert.That((old.step, old.height), Is.EqualTo((first.step, first.height)));
            Assert.That(old.age, Is.EqualTo(first.age + 4 * FrameTime).Within(1e-4f));
            ReadbackQueue.Fails = null;
            Frames(4);
            Assert.That(probe.TryGetSample(out FluidProbeSample again));
            Assert.That(again.step, Is.EqualTo(first.step + 8));
            Assert.That(again.age, Is.EqualTo(first.age).Within(1e-4f));
            Assert.That(TimesLogged("did not get an answer"), Is.EqualTo(1));
        }

        [Test]
        public void A_batch_that_asks_once_asks_again_where_its_answer_was_lost()
        {
            Fill();
            using var batch = new FluidQueryBatch(fluid, 1) { Repeats = false };
            batch.SetPoints(new[] { Vector3.zero }, 0, 1);
            Fail("Rill.QueryBatch.Results");
            Expect("did not get an answer to a FluidQueryBatch back: .*asked again, once where it does not repeat");
            Frames(6);
            Assert.That(batch.IsPending && !batch.HasResult);
            ReadbackQueue.Fails = null;
            Frames(Arrival + 2);
            Assert.That(batch.IsPending, Is.False, "for ever");
            Assert.That(batch.TryGetSample(0, out FluidProbeSample first) && first.hasSurface);

            batch.SetPoint(0, new Vector3(0.2f, 0f, 0.2f));
            Fail("Rill.QueryBatch.Results");
            Frames(6);
            Assert.That(batch.IsPending);
            Assert.That(batch.TryGetSample(0, out FluidProbeSample old), "what was there before");
            Assert.That((old.step, old.position), Is.EqualTo((first.step, Vector3.zero)));
            ReadbackQueue.Fails = null;
            Frames(Arrival + 2);
            Assert.That(batch.IsPending, Is.False);
            Assert.That(batch.TryGetSample(0, out FluidProbeSample next) && next.position == new Vector3(0.2f, 0f, 0.2f));
            int asked = next.step;
            Frames(4);
            Assert.That(batch.TryGetSample(0, out next) && next.step == asked, "asked once, not for ever");
        }

        [Test]
        public void A_request_for_particles_ends_as_failed_and_can_be_made_again()
        {
            Fill();
            using var readback = new ParticleReadback();
            Frames(1);
            fluid.RequestParticles(readback);
            Frames(Arrival + 1);
            Assert.That((readback.Outcome, readback.Count), Is.EqualTo((ReadbackOutcome.Arrived, 500)));

            Fail("Rill.ParticleCopy");
            Expect("did not get the particles for a ParticleReadback back: .*Outcome is Failed: request them again");
            fluid.RequestParticles(readback);
            Frames(Arrival + 1);
            Assert.That((readback.Outcome, readback.IsPending, readback.HasData), Is.EqualTo((ReadbackOutcome.Failed, false, false)));
            Assert.That(Assert.Throws<InvalidOperationException>(() => readback.Positions.ToArray()).Message, Does.Contain("ended as Failed"));

            ReadbackQueue.Fails = null;
            Assert.That(fluid.RequestParticles(readback));
            Frames(Arrival + 1);
            Assert.That((readback.Outcome, readback.Count), Is.EqualTo((ReadbackOutcome.Arrived, 500)));
        }

        [Test]
        public void Lost_forces_are_logged_and_those_of_before_stay_until_the_next()
        {
            Fill();
            FluidCollider ball = Add<FluidCollider>(new Vector3(0f, -0.2f, 0f), added =>
            {
                added.transform.localScale = 0.3f * Vector3.one;
                added.MeasuresForce = true;
            });
            Frames(8);
            Assert.That(ball.TryGetForceOf(fluid, out FluidForce before));
            Fail("Rill.Colliders.Taken");
            Expect("did not get the forces on colliders back: .*keep those of before");
            Frames(8);
            Assert.That(ball.TryGetForceOf(fluid, out FluidForce kept) && kept.Step == before.Step);
            ReadbackQueue.Fails = null;
            Frames(8);
            Assert.That(ball.TryGetForceOf(fluid, out FluidForce next) && next.Step > before.Step + 8);
        }

        [Test]
        public void Lost_counts_are_logged_by_what_they_are_of_and_come_with_the_next()
        {
            Fill(statisticsInterval: 1);
            FluidEmitter tap = Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), emitter => emitter.Rate = 0.02f);
            FluidDrain drain = Add<FluidDrain>(new Vector3(0f, -0.4f, 0f));
            fluid.gameObject.AddComponent<FluidFoam>();
            var foam = fluid.GetComponent<FluidFoam>();
            Fail("Rill.Emitters.States", "Rill.Drains.States", "Rill.Foam.Counters", "Rill.RefusedOfScripts");
            Expect("did not get the number of particles of scripts that it refused back");
            Expect("did not get the counts of its foam back");
            Expect("did not get the counts of its emitters back");
            Expect("did not get the counts of its drains back");
            Frames(1);
            using (var many = new NativeArray<float3>(1000, Allocator.Persistent))
            using (var still = new NativeArray<float3>(1000, Allocator.Persistent))
                fluid.AddParticles(many, still);
            Frames(30);
            Assert.That((tap.Emitted, drain.Drained), Is.EqualTo((0, 0)));
            Assert.That(foam.TryGetStatistics(out _), Is.False);

            LogAssert.Expect(LogType.Warning, new Regex("'Pond' refused .* particles that scripts added"));     // asked for again
            ReadbackQueue.Fails = null;
            Frames(30);
            Assert.That(drain.Drained, Is.GreaterThan(0));
            Assert.That(foam.TryGetStatistics(out _));
            Assert.That(TimesLogged("did not get"), Is.EqualTo(4));
        }

        [Test]
        public void A_snapshot_ends_with_its_problem_and_a_recording_stops_by_name()
        {
            Fill();
            Frames(2);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            ReadbackQueue.Fails = _ => true;
            Frames(Arrival + 1);
            Assert.That((request.IsDone, request.Snapshot), Is.EqualTo((true, (FluidSnapshot)null)));
            Assert.That(request.Problem, Does.Contain("did not give the particles back. Ask again."));

            string file = Path.Combine(Path.GetTempPath(), $"rill-lost-{Guid.NewGuid():N}.rill");
            try
            {
                ReadbackQueue.Fails = null;
                FluidRecorder recorder = fluid.gameObject.AddComponent<FluidRecorder>();
                recorder.Record(file);
                Frames(5);
                ReadbackQueue.Fails = _ => true;
                LogAssert.Expect(LogType.Error, new Regex("FluidRecorder 'Pond' stopped to record: the GPU did not give a frame back"));
                Frames(5);
                Assert.That(recorder.IsRecording, Is.False);
                Assert.That(recorder.Problem, Does.Contain("Record again"));
                fluid.gameObject.SetActive(false);
                using var kept = new RecordingReader(File.OpenRead(file));
                Assert.That(kept.FrameCount, Is.GreaterThan(0), "what came before can be played");
            }
            finally
            {
                File.Delete(file);
            }
        }

        [Test]
        public void A_bake_whose_distances_are_lost_says_so()
        {
            var settings = MeshSdfSettings.Default;
            settings.resolution = 8;
            var mesh = new TriangleMesh("Tetrahedron", new[] { Vector3.zero, Vector3.right, Vector3.up, Vector3.forward },
                new[] { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 });
            ReadbackQueue.Fails = _ => true;
            var refusal = Assert.Throws<InvalidOperationException>(() => MeshSdfBaker.Bake(mesh, settings));
            Assert.That(refusal.Message, Does.Contain("'Tetrahedron' did not arrive from the GPU").And.Contain("Bake again"));
        }
    }
}
