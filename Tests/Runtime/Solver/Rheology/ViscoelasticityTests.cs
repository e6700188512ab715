using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The stage by itself: against a reference, and against what an upper-convected Maxwell fluid does in flows that are known.</summary>
    public class ViscoelasticityTests
    {
        const float TimeStep = 1f / 60f, Modulus = 20f, RelaxationTime = 0.2f;

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Stretch_and_velocities_are_those_of_the_reference(int count)
        {
            using (var stage = new Stage(ParticleState.Random(count, seed: count, speed: 3f), Modulus))
            {
                stage.Set(i => Stretched(stage.Ids[i]));
                Tensor[] before = stage.Stretch;
                stage.Run();
                Elasticity reference = stage.Reference;
                double relaxing = Math.Exp(-0.5 * TimeStep / RelaxationTime),
                    stiffness = Modulus / 1000.0 * Math.Pow(TimeStep / SolverStages.Spacing, 2);
                Tensor[] after = Enumerable.Range(0, count).Select(i => reference.Deformed(i, before[i], relaxing)).ToArray();
                Tensor[] stresses = Enumerable.Range(0, count).Select(i => reference.Stress(i, after[i], stiffness)).ToArray();
                VectorSum[] changes = Enumerable.Range(0, count).Select(i => reference.Change(i, stresses)).ToArray();
                Tensor[] stretch = stage.Stretch;
                float4[] velocities = stage.After;
                Compare.Scalars("stretch", count, i => (stretch[i] - after[i]).Length, i => 0.0, i => 1e-4);
                Compare.Vectors("velocities", count, i => velocities[i].xyz, i => stage.Before[i].xyz + changes[i].value / TimeStep,
                    i => 1e-4 + 1e-4 * changes[i].size / TimeStep);
                Assert.That(velocities.Select(v => v.w), Is.EqualTo(stage.Before.Select(v => v.w)), "densities");
            }
        }

        [Test]
        public void Stress_at_rest_relaxes_exponentially()
        {
            using (var stage = new Stage(ParticleState.Lattice(20f, 5f, 8, jitter: 0.1f), Modulus))
            {
                stage.Set(i => Stretched(stage.Ids[i]));
                Tensor[] before = stage.Stretch;
                stage.Run(24);
                double left = Math.Exp(-24 * TimeStep / RelaxationTime);
                Tensor[] after = stage.Stretch;
                Compare.Scalars("stretch", before.Length, i => (after[i] - left * before[i]).Length, i => 0.0, i => 1e-5);
            }
        }

        // Maxwell fluid from rest in simple shear: B_xy = s (1 − e), B_xx − 1 = 2 s² (1 − e (1 + t/τ)), e = exp(−t/τ), s = rate τ.
        [Test]
        public void Steady_shear_builds_the_stress_of_a_Maxwell_fluid()
        {
            const double Rate = 4.0;
            using (var stage = new Stage(ParticleState.Lattice(20f, 5f, 8, jitter: 0.1f), Modulus))
            {
                var shear = Tensor.Identity;
                shear.x.y = Rate * TimeStep;
                double worst = 0.0, s = Rate * RelaxationTime;
                for (int step = 1; step <= 60; step++)
                {
                    stage.Come(shear);
                    double past = step * TimeStep / RelaxationTime, left = Math.Exp(-past);
                    Tensor expected = Tensor.Symmetric(new double3(2.0 * s * s * (1.0 - left * (1.0 + past)), 0.0, 0.0),
                        new double3(0.0, 0.0, s * (1.0 - left)));
                    worst = Math.Max(worst, stage.Stretch.Max(b => (b - expected).Length) / s);
                }
                TestContext.Out.WriteLine(
                    $"off by at most {worst:0.00000} of the last shear stress; (Δt/τ)² is {Math.Pow(TimeStep / RelaxationTime, 2):0.00000}");
                Assert.That(worst, Is.LessThan(0.5 * Math.Pow(TimeStep / RelaxationTime, 2)), "second order in the time step");
            }
        }

        [Test]
        public void A_turn_builds_no_stress_and_takes_what_there_is_along()
        {
            const double Angle = 0.3;
            using (var stage = new Stage(ParticleState.Lattice(20f, 5f, 8, jitter: 0.1f), Modulus, relaxationTime: 1000f))
            {
                double speed = 0.0;
                for (int step = 0; step < 20; step++)
                    speed = Math.Max(speed, stage.Come(Tensor.Turn(Angle)));
                double built = stage.Stretch.Max(b => b.Length);
                TestContext.Out.WriteLine($"stretch {built:g3} after 20 turns, {speed:g3} d/s");
                Assert.That(built, Is.LessThan(1e-4), "what rounding leaves; a turn is 0.3 rad, whose square is 0.09");
                Assert.That(speed, Is.LessThan(1e-3), "d/s");

                Tensor stretch = Stretched(1);
                stage.Set(i => stretch);
                for (int step = 0; step < 20; step++)
                    stage.Come(Tensor.Turn(Angle));
                Tensor turned = Tensor.Turn(20 * Angle) * stretch * Tensor.Turn(20 * Angle).Transposed;
                Assert.That(stage.Stretch.Max(b => (b - turned).Length), Is.LessThan(1e-3 * stretch.Length));
            }
        }

        [TestCase(Modulus)]
        [TestCase(1e6f)]
        public void Stress_gives_neither_momentum_nor_spin(float modulus)
        {
            using (var stage = new Stage(ParticleState.Random(997, seed: 7, speed: 3f), modulus))
            {
                stage.Set(i => Stretched(stage.Ids[i]));
                stage.Run();
                float4[] after = stage.After;
                double3 sum = new double3(0.0), spin = new double3(0.0);
                double size = 0.0, longest = 0.0;
                for (int i = 0; i < after.Length; i++)
                {
                    double3 change = (double3)after[i].xyz - stage.Before[i].xyz;
                    sum += change;
                    spin += math.cross(stage.Points[i], change);
                    size += math.length(change);
                    longest = Math.Max(longest, math.length(change) * TimeStep);
                }
                TestContext.Out.WriteLine($"momentum {math.length(sum) / size:g3}, spin {math.length(spin) / size:g3} d of " +
                    $"{size / after.Length:g3} d/s; longest displacement {longest:g3} d");
                Assert.That(longest, Is.GreaterThan(0.001).And.LessThan(0.5), "something was done, and nothing was cut off");
                Assert.That(math.length(sum), Is.LessThan(1e-6 * size));
                Assert.That(math.length(spin), Is.LessThan(1e-5 * size));
            }
        }

        // A flow of up to half a spacing to the next one, back and forth at random: harder than any that the solver lets through.
        [Test]
        public void However_it_is_torn_the_stretch_stays_finite_and_positive([Values(0.001f, 1000f)] float relaxationTime,
            [Values(1f, 1e6f)] float modulus)
        {
            using (var stage = new Stage(ParticleState.Lattice(20f, 5f, 8, jitter: 0.1f), modulus, relaxationTime))
            {
                var random = new Unity.Mathematics.Random(3);
                double most = 0.0, fastest = 0.0;
                for (int step = 0; step < 100; step++)
                {
                    fastest = Math.Max(fastest, stage.Tear(random.NextFloat(0f, 3f), random.NextUInt()));
                    Assert.That(stage.Stretch.All(b => (Tensor.Identity + b).IsPositive), $"step {step}");
                    most = Math.Max(most, stage.Stretch.Max(b => b.Trace));
                }
                TestContext.Out.WriteLine($"largest trace {most:g3}, fastest {fastest * TimeStep:g3} d a substep");
                Assert.That(most, Is.LessThanOrEqualTo((modulus > 1f ? 2.0 : 10.0) * (1.0 + 1e-5)),
                    "soft fluid is drawn out far, one as stiff as may be to twice its length");
                Assert.That(fastest * TimeStep, Is.LessThanOrEqualTo(0.5 * (1.0 + 1e-5)));
            }
        }

        [Test]
        public void Two_lists_give_the_result_of_one_bit_for_bit()
        {
            ParticleState state = ParticleState.Random(997, seed: 5, speed: 3f);
            using (var one = new Stage(state, Modulus))
            using (var two = new Stage(state, Modulus, maxBinding: 96 * 4 * 512))
            {
                Assert.That(two.Stages.Layout.TwoLists);
                Compare.Same("velocities", two.Run().After, one.Run().After);
                Assert.That(two.After, Is.Not.EqualTo(two.Before));
            }
        }

        [Test]
        public void Points_past_the_particles_are_left_alone_and_none_is_no_harm()
        {
            foreach (int count in new[] { 0, 200 })
                using (var stage = new Stage(ParticleState.Random(count, seed: 3, speed: 3f), Modulus, capacity: 300))
                {
                    uint[] before = GpuTest.Read<uint>(stage.Stages.Particles.Velocities, 1200);
                    GpuTest.FillWithGarbage(stage.Conformation);
                    stage.Run(2);       // into the other buffer and back
                    Assert.That(GpuTest.Read<uint>(stage.Stages.Particles.Velocities, 1200).Skip(4 * count), Is.EqualTo(before.Skip(4 * count)));
                    Assert.That(GpuTest.Read<uint>(stage.Conformation, 1800).Skip(6 * count).All(word => word == GpuTest.Garbage));
                }
        }

        // Takes any positive B; different from one particle to the next.
        static Tensor Stretched(uint id)
        {
            var random = new Unity.Mathematics.Random(id * 7919u + 17u);
            return Tensor.Symmetric(new double3(random.NextFloat3(-0.3f, 0.6f)), new double3(random.NextFloat3(-0.2f, 0.2f)));
        }

        /// <summary>The stage over particles that no constraint has moved.</summary>
        sealed class Stage : IDisposable
        {
            public readonly SolverStages Stages;
            public readonly double3[] Points;
            public readonly uint[] Ids;

            readonly Viscoelasticity stage;
            readonly float4[] positions;

            public Stage(ParticleState state, float modulus, float relaxationTime = RelaxationTime, long maxBinding = 0, int capacity = 0)
            {
                FluidMaterial material = FluidMaterial.Water;
                material.shearModulus = modulus;
                material.relaxationTime = relaxationTime;
                material.velocitySmoothing = 0f;
                Stages = new SolverStages(state, SolverStages.Still(SolverStages.Roomy, material), capacity, maxBinding);
                Stages.Sort().Constrain(iterations: 0).UpdateVelocities();
                positions = Stages.Predicted;
                Points = Compare.Points(positions);
                Ids = Stages.SortedIds;
                Before = Stages.Velocities;
                stage = new Viscoelasticity(Stages.Layout.Capacity);
                // One slot before and after the sort.
                stage.PreviousIndices.SetData(Enumerable.Range(0, Stages.Layout.Capacity).Select(i => (uint)i).ToArray());
            }

            public float4[] Before { get; private set; }
            public float4[] After => Stages.Velocities;
            public UnityEngine.GraphicsBuffer Conformation => stage.Conformation;

            public Elasticity Reference => new Elasticity(Compare.Points(Stages.Start), Points, Neighbors.ByCells(Points, Kernels.H));

            public Tensor[] Stretch => GpuTest.Read<Viscoelasticity.Symmetric>(stage.Conformation, Ids.Length)
                .Select(b => Tensor.Symmetric(b.diagonal, b.others)).ToArray();

            public void Set(Func<int, Tensor> stretch)
            {
                stage.Conformation.SetData(Enumerable.Range(0, Ids.Length).Select(i => stretch(i)).Select(b => new Viscoelasticity.Symmetric
                {
                    diagonal = new float3((float)b.x.x, (float)b.y.y, (float)b.z.z),
                    others = new float3((float)b.y.z, (float)b.x.z, (float)b.x.y),
                }).ToArray(), 0, 0, Ids.Length);
            }

            public Stage Run(int count = 1)
            {
                for (int i = 0; i < count; i++)
                    GpuTest.Run(cmd => stage.Record(Stages.Context(cmd)));
                return this;
            }

            /// <summary>A substep in which the particles come to their places as a linear map has them; the fastest that the stress makes
            /// one, d/s.</summary>
            public double Come(Tensor map)
            {
                double3 center = Points.Aggregate((a, b) => a + b) / Points.Length;
                Tensor back = map.Inverse;
                return From(Points.Select(p => center + back * (p - center)).ToArray());
            }

            /// <summary>Largest rate from anywhere within a distance of their positions.</summary>
            public double Tear(float distance, uint seed)
            {
                var random = new Unity.Mathematics.Random(seed | 1u);
                return From(Points.Select(p => p + distance * (double3)random.NextFloat3(-1f, 1f)).ToArray());
            }

            double From(double3[] starts)
            {
                Stages.Particles.Start.SetData(starts.Select(p => new float4((float3)p, 0f)).ToArray(), 0, 0, starts.Length);
                Stages.Particles.Velocities.SetData(new float4[starts.Length], 0, 0, starts.Length);
                Run();
                return After.Max(v => math.length(v.xyz));
            }

            public void Dispose()
            {
                stage.Dispose();
                Stages.Dispose();
            }
        }
    }
}
