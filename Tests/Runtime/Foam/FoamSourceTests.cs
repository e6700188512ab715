using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Sources of foam: the potentials and what they spawn, against double precision.</summary>
    public class FoamSourceTests
    {
        const float Step = 1f / 60f;
        // Values of Research~/foam-study.md.
        const double Low = 0.25 * 20.0, High = 0.5 * 20.0;      // d/s, of FoamStage.Settings
        const double MinStrain = 2.0;       // 1/s, at 1 for speed over depth
        const double SolverStrain = 0.025, MinBend = 0.1, MaxBend = 0.5;
        static readonly double Made = Step * Math.Pow(50.0 / 20.0, 3.0);

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Potentials_are_those_of_the_reference(int count)
        {
            using (var stage = new FoamStage(ParticleState.Random(count, seed: count + 1, speed: 12f), FoamStage.Settings(1f)))
            {
                stage.Step();
                var twin = new Twin(stage);
                uint2[] found = GpuTest.Read<uint2>(stage.Foam.Potentials, count);
                Compare.Scalars("trapped air", count, i => math.asfloat(found[i].y & 0x7fffffffu), i => twin.Trapped[i],
                    i => twin.IsUncertain(i) ? 1.0 : 2e-4 * Made);
                for (int i = 0; i < count; i++)
                    if (twin.Kinetic[i] > 0.01 && !twin.IsUncertain(i))
                        Assert.That(found[i].y >> 31 != 0, Is.EqualTo(twin.FliesOut[i]), $"particle {i} flies out");
                if (count > 500)
                    Assert.That(twin.Trapped.Count(n => n > 0.1 * Made), Is.GreaterThan(count / 4),
                        "particles that trap air, or nothing is compared");
            }
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void As_many_are_spawned_as_the_reference_counts_and_where_it_puts_them(int count)
        {
            using (var stage = new FoamStage(ParticleState.Random(count, seed: count + 2, speed: 12f), FoamStage.Settings(2f, 1000000)))
            {
                stage.Step();
                var twin = new Twin(stage);
                FoamParticle[] foam = stage.Read();
                int at = 0, spawned = 0, sure = 0;
                uint[] counts = GpuTest.Read<uint>(stage.Foam.SpawnCounts, count);
                for (int i = 0; i < count; i++)
                {
                    uint hash = Reference.FoamSpawn.Hash(1u, stage.Ids[i], 1u);
                    // normals are packed, and neighbors of a crest may be at a limit
                    double expected = 2.0 * (twin.Trapped[i] + twin.Crest[i]), margin = 1e-3 + (twin.FliesOut[i] ? 0.4 * Made : 0.0);
                    int low = Reference.FoamSpawn.Count(expected - margin, hash), high = Reference.FoamSpawn.Count(expected + margin, hash);
                    int number = (int)(counts[i] >> 16);
                    if (!twin.IsUncertain(i))
                        Assert.That(number, Is.InRange(low, high), $"spawned by particle {i}, which should spawn {expected}");
                    sure += !twin.IsUncertain(i) && low == high ? 1 : 0;
                    for (int k = 0; k < number; k++, at++)
                    {
                        double3 position = Reference.FoamSpawn.Position(stage.Points[i], stage.Velocities[i], Step,
                            stage.Stages.Layout.DomainSize, hash, k, out double3 velocity);
                        Assert.That(math.distance(FoamStage.Position(foam[at]), position), Is.LessThan(2e-3),
                            $"foam particle {at}, number {k} of particle {i}");
                        Assert.That(math.distance(FoamStage.Velocity(foam[at]), velocity), Is.LessThan(2e-3), $"velocity of foam particle {at}");
                    }
                    spawned += number;
                }
                Assert.That(foam.Length, Is.EqualTo(spawned));
                Assert.That(stage.Counter(FoamCounter.Spawned), Is.EqualTo(spawned));
                Assert.That(sure, Is.GreaterThan(0.9 * count), "particles whose number is known");
                if (count > 500)
                    Assert.That(spawned, Is.GreaterThan(count / 10));
            }
        }

        [Test]
        public void Two_lists_give_what_one_gives_bit_for_bit()
        {
            ParticleState state = ParticleState.Random(997, seed: 5, speed: 12f);
            using (var one = new FoamStage(state, FoamStage.Settings(2f)))
            using (var two = new FoamStage(state, FoamStage.Settings(2f), maxBinding: 96 * 4 * 512))
            {
                Assert.That(two.Stages.Layout.TwoLists);
                FoamParticle[] expected = one.Step().Read();
                Assert.That(expected, Is.Not.Empty);
                Assert.That(two.Step().Read(), Is.EqualTo(expected));
            }
        }

        [Test]
        public void Without_particles_nothing_is_spawned()
        {
            using (var stage = new FoamStage(ParticleState.Random(0, seed: 4), FoamStage.Settings(10f)))
            {
                Assert.That(stage.Step(3).Read(), Is.Empty);
                Assert.That(GpuTest.Read<uint2>(stage.Foam.Potentials, stage.Stages.Layout.Capacity).All(p => GpuTest.IsGarbage(p.x)
                    && GpuTest.IsGarbage(p.y)));
            }
        }

        [Test]
        public void Water_that_moves_as_one_makes_no_foam_however_fast()
        {
            ParticleState state = ParticleState.Lattice(60f, 10f, 12, jitter: 0.1f).With(p => new float3(30f, -15f, 8f));
            using (var stage = new FoamStage(state, FoamStage.Settings(10f)))
            {
                stage.Step();
                uint2[] potentials = GpuTest.Read<uint2>(stage.Foam.Potentials, state.Count);
                Assert.That(potentials.Sum(p => (double)math.asfloat(p.y & 0x7fffffffu)), Is.Zero, "trapped air");
            }
        }

        [Test]
        public void Slow_water_makes_no_foam_however_it_is_sheared()
        {
            ParticleState state = ParticleState.Random(2000, seed: 8, speed: 2.5f);     // at most 4.4 d/s of the 5 from which it does
            using (var stage = new FoamStage(state, FoamStage.Settings(10f)))
                Assert.That(stage.Step(10).Counter(FoamCounter.Spawned), Is.Zero);
        }

        [Test]
        public void A_crest_that_flies_out_makes_foam_and_a_flat_surface_does_not()
        {
            double flat = Crests(p => true), ridge = Crests(p => math.abs(p.x - 20f) < 1.1f);
            Assert.That(ridge, Is.GreaterThan(20.0), "of a ridge");
            Assert.That(flat, Is.LessThan(0.05 * ridge), "of a flat surface");

            // Expected foam of the particles of the top layer, far from its edges. Water rises as one: no air is trapped.
            double Crests(Func<float3, bool> isThere)
            {
                ParticleState block = ParticleState.Lattice(0f, 10.5f, new int3(20, 6, 20), jitter: 0.02f);
                var state = new ParticleState(40f, block.positions.Select(p => p.xyz).Where(p => p.y < 14f || isThere(p)).ToArray());
                using (var stage = new FoamStage(state.With(p => new float3(0f, 15f, 0f)), FoamStage.Settings(10f)))
                {
                    stage.Step();
                    var spawned = GpuTest.Read<uint>(stage.Foam.SpawnCounts, state.Count);
                    return Enumerable.Range(0, state.Count).Where(i => stage.Points[i].y > 14.2
                        && math.all(math.abs(stage.Points[i].xz - 20.0) < 7.0)).Sum(i => spawned[i] >> 16);
                }
            }
        }

        [Test]
        public void Half_the_spacing_makes_the_same_foam_over_an_area_of_sheared_broken_water()
        {
            // A coarse area has few particles: the mean of eight.
            double coarse = Enumerable.Range(0, 8).Average(seed => FoamOfArea(1, 99u + (uint)seed)), fine = FoamOfArea(2, 99u);
            TestContext.Out.WriteLine($"{fine / coarse:0.000} of the foam at twice the spacing");
            Assert.That(coarse, Is.GreaterThan(0.5), "foam particles of the area in a step");
            Assert.That(fine / coarse, Is.EqualTo(1.0).Within(0.1), $"{fine} of {coarse} with twice the spacing");

            // Water with 40 % of air, sheared at the same rate: foam particles that are expected over 12 x 12 d of a layer of 4 d, away
            // from its ends.
            double FoamOfArea(int finer, uint seed)
            {
                ParticleState block = ParticleState.Lattice(0f, 2.5f, new int3(16 * finer, 8 * finer, 16 * finer), jitter: 0.15f);
                var random = new Unity.Mathematics.Random(seed);
                var state = new ParticleState(20f * finer, block.positions.Select(p => p.xyz).Where(_ => random.NextFloat() < 0.6f).ToArray());
                FoamSettings settings = FoamStage.Settings(1f);
                settings.referenceSpeed *= finer;       // the same in meters
                settings.referenceDepth *= finer;
                using (var stage = new FoamStage(state.With(p => new float3(12f * finer + 20f * p.y, 0f, 0f)), settings, fluidStep: 1e-4f))
                {
                    stage.Step();
                    uint2[] potentials = GpuTest.Read<uint2>(stage.Foam.Potentials, state.Count);
                    double center = 10.0 * finer;
                    return Enumerable.Range(0, state.Count).Where(i => math.all(math.abs(stage.Points[i].xz - center) < 6.0 * finer)
                        && math.abs(stage.Points[i].y - 6.0 * finer) < 2.0 * finer).Sum(i
                        => (double)math.asfloat(potentials[i].y & 0x7fffffffu));
                }
            }
        }

        /// <summary>The reference over what a stage saw.</summary>
        sealed class Twin
        {
            public readonly double[] Kinetic, Trapped, Crest;
            public readonly bool[] FliesOut;
            readonly bool[] isUncertain;

            public Twin(FoamStage stage)
            {
                int count = stage.Points.Length;
                double3 box = stage.Stages.Layout.DomainSize;
                var potentials = new Reference.FoamPotentials(box, stage.Points, stage.Velocities,
                    Reference.Neighbors.ByCells(stage.Points, Reference.Kernels.H));
                Kinetic = new double[count];
                Trapped = new double[count];
                Crest = new double[count];
                FliesOut = new bool[count];
                isUncertain = new bool[count];
                var normals = new double3[count];
                for (int i = 0; i < count; i++)
                {
                    Kinetic[i] = potentials.Kinetic(i, Low, High);
                    if (Kinetic[i] == 0.0)
                        continue;
                    normals[i] = potentials.Normal(i);
                    isUncertain[i] = Math.Abs(potentials.Asymmetry - Reference.FoamPotentials.SurfaceNormal) < 1e-4;
                    FliesOut[i] = potentials.FliesOut(i, normals[i]);
                    double cosine = math.dot(normals[i], stage.Velocities[i]) / math.length(stage.Velocities[i]);
                    isUncertain[i] |= Math.Abs(cosine - Reference.FoamPotentials.Outwards) < 1e-4;
                    if (math.lengthsq(normals[i]) > 0.0)
                        Trapped[i] = Made * Kinetic[i] * Reference.FoamPotentials.Ramp(Flow(potentials.Strain(i)), MinStrain, 2.0 * MinStrain);
                }
                for (int i = 0; i < count; i++)
                    if (FliesOut[i])
                        Crest[i] = Made * Kinetic[i] * Reference.FoamPotentials.Ramp(potentials.Bend(i, normals), MinBend, MaxBend);
            }

            // Without the solver's own.
            static double Flow(double strain) => Math.Sqrt(Math.Max(strain * strain - Math.Pow(SolverStrain / Step, 2.0), 0.0));

            /// <summary>Whether single precision may take it to be on the other side of a limit.</summary>
            public bool IsUncertain(int i) => isUncertain[i];
        }
    }
}
