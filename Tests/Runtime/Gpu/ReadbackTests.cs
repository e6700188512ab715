using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Data that is read back without waiting, also when its owner has gone meanwhile.</summary>
    public class ReadbackTests
    {
        [TearDown]
        public void PlayOn() => PendingReadbacks.Begin();

        [Test]
        public void Switching_a_fluid_off_waits_for_no_request()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 2000).Fill(0.2f))
            {
                GraphicsBuffer others = GpuTest.Upload("Others", new uint[4]);
                AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(others);
                scene.Fluid.StatisticsInterval = 1;
                scene.Step();
                Assert.That(scene.Fluid.Solver.StatisticsPending);

                scene.Fluid.KeepStateOnDisable = false;
                scene.Fluid.enabled = false;
                Assert.That(request.done, Is.False, "somebody else's");
                Assert.That(PendingReadbacks.Count, Is.EqualTo(1), "its own");
                request.WaitForCompletion();
                others.Release();
            }
        }

        [UnityTest]
        public IEnumerator A_buffer_on_its_way_is_released_when_it_has_come()
        {
            GraphicsBuffer buffer = GpuTest.Upload("Buffer", new uint[4]);
            var readback = new Readback(buffer);
            readback.Arrived = () => Assert.Fail("its owner is gone");
            readback.Request();
            readback.Dispose();
            readback.Dispose();
            Assert.That(buffer.IsValid(), "while it is pending");
            for (int frame = 0; frame < 30 && PendingReadbacks.Count > 0; frame++)
                yield return null;
            Assert.That(buffer.IsValid(), Is.False, "when it has come");
            Assert.That(PendingReadbacks.Count, Is.Zero);
        }

        [Test]
        public void A_buffer_of_which_nothing_is_on_its_way_is_released_at_once()
        {
            int others = PendingReadbacks.Count;        // of tests before
            GraphicsBuffer buffer = GpuTest.Upload("Buffer", new uint[4]);
            new Readback(buffer).Dispose();
            Assert.That(buffer.IsValid(), Is.False);
            Assert.That(PendingReadbacks.Count, Is.EqualTo(others));
        }

        [Test]
        public void As_play_ends_its_own_requests_are_waited_for_and_no_others()
        {
            GraphicsBuffer others = GpuTest.Upload("Others", new uint[4]), before = GpuTest.Upload("Before", new uint[4]),
                after = GpuTest.Upload("After", new uint[4]);
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(others);
            Leave(before);
            PendingReadbacks.End();
            Assert.That(before.IsValid(), Is.False);
            Leave(after);
            Assert.That(after.IsValid(), Is.False, "nothing comes back any more");
            Assert.That(PendingReadbacks.Count, Is.Zero);
            Assert.That(request.done, Is.False);
            request.WaitForCompletion();
            others.Release();
        }

        [Test]
        public void A_result_that_is_waited_for_is_there_at_once_and_no_other_is_waited_for()
        {
            GraphicsBuffer others = GpuTest.Upload("Others", new uint[4]);
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(others);
            using (var readback = new Readback(GpuTest.Upload("Buffer", new uint[] { 7, 8 })))
            {
                int arrived = 0;
                readback.Arrived = () => arrived++;
                readback.Complete();        // nothing is pending
                readback.Request();
                readback.Complete();
                Assert.That((arrived, readback.IsPending, readback.HasResult), Is.EqualTo((1, false, true)));
                Assert.That(readback.Latest.ToArray(), Is.EqualTo(new uint[] { 7, 8 }));
                Assert.That(request.done, Is.False, "somebody else's");
            }
            request.WaitForCompletion();
            others.Release();
        }

        [Test]
        public void Answers_that_are_waited_for_come_in_the_order_of_their_requests()
        {
            var order = new List<int>();
            using (var ring = new ReadbackRing("Ring", 3, 1, order.Add))
            {
                for (int slot = 0; slot < 3; slot++)
                    BufferClear.Now(ring.Buffer(slot));
                foreach (int slot in new[] { 1, 2, 0 })
                    ring.Request(slot);
                ring.Complete();
                Assert.That(order, Is.EqualTo(new[] { 1, 2, 0 }));
                Assert.That(ring.Free(), Is.EqualTo(0), "all are free again");
                ring.Request(2);
                ring.Request(1);
                ring.Complete();
                Assert.That(order, Is.EqualTo(new[] { 1, 2, 0, 2, 1 }));
            }
        }

        static readonly Action<FluidSimulation>[] Waits =
        {
            fluid => fluid.Results.Measurements.MeasureNow(),
            fluid => fluid.Inputs.Parts.FindBlockedEmitters(),
            fluid => fluid.FlushQueries(),
        };

        [Test]
        public void What_tests_ask_of_a_fluid_waits_for_no_readback_of_the_game([Values(0, 1, 2)] int wait)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.05f, 2000).Fill(0.2f))
            using (var batch = new FluidQueryBatch(scene.Fluid, 1))
            {
                FluidProbe probe = scene.Probe(Vector3.zero);
                scene.Add<FluidEmitter>(new Vector3(0f, 0.3f, 0f), Vector3.down);
                batch.SetPoints(new[] { Vector3.zero }, 0, 1);
                scene.Step();
                GraphicsBuffer others = GpuTest.Upload("Others", new uint[4]);
                AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(others);
                Waits[wait](scene.Fluid);
                Assert.That(request.done, Is.False);
                Assert.That(probe.TryGetSample(out _), Is.EqualTo(wait == 2));
                Assert.That(batch.HasResult, Is.EqualTo(wait == 2));
                batch.Flush();
                Assert.That(batch.HasResult);
                Assert.That(request.done, Is.False);
                request.WaitForCompletion();
                others.Release();
            }
        }

        [UnityTest]
        public IEnumerator A_result_comes_and_one_from_before_a_reset_is_dropped()
        {
            GraphicsBuffer buffer = GpuTest.Upload("Buffer", new uint[] { 7, 8 });
            using (var readback = new Readback(buffer))
            {
                readback.Request();
                readback.Invalidate();
                yield return Arrive(readback);
                Assert.That(readback.HasResult, Is.False);
                readback.Request();
                yield return Arrive(readback);
                Assert.That(readback.HasResult);
                Assert.That(readback.Latest.ToArray(), Is.EqualTo(new uint[] { 7, 8 }));
            }
        }

        static IEnumerator Arrive(Readback readback)
        {
            for (int frame = 0; frame < 30 && readback.IsPending; frame++)
                yield return null;
            Assert.That(readback.IsPending, Is.False);
        }

        static void Leave(GraphicsBuffer buffer)
        {
            var readback = new Readback(buffer);
            readback.Request();
            readback.Dispose();
        }
    }
}
