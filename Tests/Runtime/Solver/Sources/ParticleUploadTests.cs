using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    public class ParticleUploadTests
    {
        const int Capacity = 1000;

        ParticleBuffers particles;
        ParticleUpload emission;

        [SetUp]
        public void Empty()
        {
            particles = new ParticleBuffers(Capacity);
            ParticleState.Random(0, seed: 1).WriteTo(particles);
            emission = new ParticleUpload();
            GpuTest.Run(cmd => emission.Clear(cmd, particles));
        }

        [TearDown]
        public void Release()
        {
            particles.Dispose();
            emission.Dispose();
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(127)]
        [TestCase(128)]
        [TestCase(129)]
        [TestCase(997)]
        public void A_batch_is_added_as_it_is(int count)
        {
            ParticleState batch = Append(count, seed: count);

            Compare.Same("positions", GpuTest.Read<float4>(particles.Positions, count), batch.positions);
            Compare.Same("velocities", GpuTest.Read<float4>(particles.Velocities, count), batch.velocities);
            Compare.Same("ids", GpuTest.Read<uint>(particles.Ids, count), batch.ids);
            Assert.That(Counter(ParticleCounter.Alive), Is.EqualTo(count));
            // Clearing wrote the first slot.
            Assert.That(GpuTest.Read<float4>(particles.Positions, Capacity).Skip(Math.Max(count, 1)).All(GpuTest.IsGarbage),
                "places behind the batch are left alone");
        }

        [TestCase(129)]
        [TestCase(997)]
        public void One_velocity_is_that_of_all_particles_of_a_batch(int count)
        {
            ParticleState batch = ParticleState.Random(count, seed: 6);
            var velocity = new float4(1f, 2f, 3f, 0f);
            using (var positions = new NativeArray<float4>(batch.positions, Allocator.Persistent))
            using (var velocities = new NativeArray<float4>(new[] { velocity }, Allocator.Persistent))
                emission.Append(particles, Capacity, positions, velocities);

            Compare.Same("positions", GpuTest.Read<float4>(particles.Positions, count), batch.positions);
            Compare.Same("velocities", GpuTest.Read<float4>(particles.Velocities, count),
                Enumerable.Repeat(new float4(velocity.xyz, 1f), count).ToArray());
        }

        [Test]
        public void Other_numbers_of_velocities_are_refused_by_name()
        {
            using (var positions = new NativeArray<float4>(3, Allocator.Persistent))
            using (var velocities = new NativeArray<float4>(2, Allocator.Persistent))
                Assert.That(() => emission.Append(particles, Capacity, positions, velocities),
                    Throws.ArgumentException.With.Message.Contains("3 positions with 2 velocities"));
        }

        [TestCase(0, 0)]
        [TestCase(1, 0)]
        [TestCase(Capacity, 0)]
        [TestCase(Capacity + 1, 1)]
        [TestCase(100003, 100003 - Capacity)]
        public void What_does_not_fit_the_capacity_is_refused_and_counted(int count, int refused)
        {
            ParticleState batch = Append(count, seed: 3);

            int added = count - refused;
            Assert.That(Counter(ParticleCounter.Alive), Is.EqualTo(added));
            Assert.That(Counter(ParticleCounter.Refused), Is.EqualTo(refused));
            Compare.Same("positions", GpuTest.Read<float4>(particles.Positions, added), batch.positions.Take(added).ToArray());
        }

        [Test]
        public void Batches_come_behind_those_alive_until_it_is_full()
        {
            ParticleState first = Append(600, seed: 4);
            ParticleState second = Append(600, seed: 5);
            Append(10, seed: 6);

            Assert.That(Counter(ParticleCounter.Alive), Is.EqualTo(Capacity));
            Assert.That(Counter(ParticleCounter.Refused), Is.EqualTo(210));
            Compare.Same("positions", GpuTest.Read<float4>(particles.Positions, Capacity),
                first.positions.Concat(second.positions.Take(400)).ToArray());
        }

        [Test]
        public void An_id_is_never_given_twice_even_to_those_refused()
        {
            Append(600, seed: 7);
            Append(600, seed: 8);
            SetAlive(500);      // as if half had drained
            Append(100, seed: 9);

            uint[] ids = GpuTest.Read<uint>(particles.Ids, 600);
            Compare.Same("the last batch", ids.Skip(500).ToArray(), Enumerable.Range(1200, 100).Select(i => (uint)i).ToArray());
            Assert.That(ids.Distinct().Count(), Is.EqualTo(600));
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(128)]
        [TestCase(129)]
        [TestCase(Capacity)]
        public void Arguments_for_the_particles_alive_are_written(int count)
        {
            Append(count, seed: 10);
            Assert.That(GpuTest.Read<uint>(particles.AliveArguments, ParticleState.ArgumentCount), Is.EqualTo(ParticleState.ArgumentsFor(count)));
        }

        [Test]
        public void Clearing_leaves_no_particle_and_no_count()
        {
            Append(Capacity + 7, seed: 11);
            GpuTest.Run(cmd => emission.Clear(cmd, particles));

            Assert.That(GpuTest.Read<uint>(particles.Counters, ParticleBuffers.CounterCount), Is.All.Zero);
            Assert.That(GpuTest.Read<uint>(particles.AliveArguments, ParticleState.ArgumentCount), Is.EqualTo(ParticleState.ArgumentsFor(0)));
        }

        [Test]
        public void A_batch_larger_than_one_upload_is_added_whole()
        {
            const int count = (1 << 20) + 3;
            using (var many = new ParticleBuffers(count))
            using (var points = new NativeArray<float4>(count, Allocator.Persistent))
            {
                GpuTest.Run(cmd => emission.Clear(cmd, many));
                NativeArray<float4> numbered = points;
                for (int i = 0; i < count; i++)
                    numbered[i] = new float4(i, 0f, 0f, 0f);
                emission.Append(many, count, points, points);

                float4[] positions = GpuTest.Read<float4>(many.Positions, count);
                uint[] ids = GpuTest.Read<uint>(many.Ids, count);
                for (int i = 0; i < count; i++)
                    if (positions[i].x != i || ids[i] != i)
                        Assert.Fail($"particle {i} is at {positions[i]} with id {ids[i]}");
            }
        }

        [Test]
        public void Positions_without_velocities_are_refused_by_number()
        {
            using (var positions = new NativeArray<float4>(3, Allocator.Persistent))
            using (var velocities = new NativeArray<float4>(2, Allocator.Persistent))
            {
                var error = Assert.Throws<ArgumentException>(() => emission.Append(particles, Capacity, positions, velocities));
                Assert.That(error.Message, Does.Contain("3 positions with 2 velocities"));
            }
        }

        // A particle that was just added has density 1 after its velocity, as ParticleState has.
        ParticleState Append(int count, int seed)
        {
            ParticleState batch = ParticleState.Random(count, seed, speed: 10f);
            using (var positions = new NativeArray<float4>(batch.positions, Allocator.Persistent))
            using (var velocities = new NativeArray<float4>(batch.velocities, Allocator.Persistent))
                emission.Append(particles, Capacity, positions, velocities);
            return batch;
        }

        void SetAlive(uint count)
        {
            uint[] counters = GpuTest.Read<uint>(particles.Counters, ParticleBuffers.CounterCount);
            counters[(int)ParticleCounter.Alive] = count;
            particles.Counters.SetData(counters);
        }

        uint Counter(ParticleCounter counter) => GpuTest.Read<uint>(particles.Counters, ParticleBuffers.CounterCount)[(int)counter];
    }
}
