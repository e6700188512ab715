using System;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The stage by itself: against a solve in double precision, and by what every viscosity keeps.</summary>
    [Category("LongRun")]
    public class ImplicitViscosityTests
    {
        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Velocities_are_those_of_the_reference(int count)
        {
            foreach (double strength in count < 1000 ? new[] { 0.001, 0.3, 5.0 } : new[] { 0.3 })
                using (var stage = new Stage(ParticleState.Random(count, seed: count, speed: 3f), strength))
                {
                    double3[] before = Compare.Points(stage.Before), solved = stage.Reference.Solve(before, strength);
                    float4[] after = stage.Run().After;
                    double change = Rms(before, solved), error = Rms(Compare.Points(after), solved);
                    double bound = 30.0 * strength * math.asfloat(stage.Stages.Counter(ParticleCounter.ViscosityBound)),
                        left = ErrorLeft(ImplicitViscosity.PassesFor(strength), bound);
                    TestContext.Out.WriteLine($"{count} at {strength}: changed by {change:g3} d/s, {error / Math.Max(change, 1e-9):g3} " +
                        $"of it wrong, {left:g3} allowed; eigenvalues up to 1 + {bound:g3}, " +
                        $"{strength * LatticeKernels.ViscosityEigenvalue:g3} on the lattice");
                    Assert.That(error, Is.LessThan(1.001 * left * change + 1e-5), "Chebyshev's bound");
                    Assert.That(left, Is.LessThan(0.05));
                    Assert.That(after.Select(v => v.w), Is.EqualTo(stage.Before.Select(v => v.w)), "densities");
                }
        }

        [TestCase(0.01)]
        [TestCase(0.3)]
        [TestCase(1000.0)]
        public void Momentum_and_spin_are_kept(double strength)
        {
            using (var stage = new Stage(ParticleState.Random(997, seed: 7, speed: 3f), strength))
            {
                double3[] before = Compare.Points(stage.Before), after = Compare.Points(stage.Run().After);
                double3 momentum = new double3(0.0), spin = new double3(0.0);
                double size = 0.0;
                for (int i = 0; i < after.Length; i++)
                {
                    momentum += after[i] - before[i];
                    spin += math.cross(stage.Points[i], after[i] - before[i]);
                    size += math.length(after[i] - before[i]);
                }
                TestContext.Out.WriteLine(
                    $"momentum {math.length(momentum) / size:g3}, spin {math.length(spin) / size:g3} d of {size / after.Length:g3} d/s");
                Assert.That(size / after.Length, Is.GreaterThan(0.01), "something was done");
                Assert.That(math.length(momentum), Is.LessThan(1e-6 * size));
                Assert.That(math.length(spin), Is.LessThan(1e-5 * size));
                Assert.That(Energy(after), Is.LessThanOrEqualTo(Energy(before)));
            }
        }

        [TestCase(0.3)]
        [TestCase(1000.0)]
        public void What_turns_as_a_rigid_body_is_left_alone(double strength)
        {
            ParticleState body = ParticleState.Random(997, seed: 3);
            using (var stage = new Stage(body.With(p => new float3(1f, 2f, 3f) + math.cross(new float3(0.7f, -0.4f, 1.1f), p)), strength))
            {
                float4[] after = stage.Run().After;
                Compare.Vectors("velocities", body.Count, i => after[i].xyz, i => stage.Before[i].xyz, i => 1e-3);
            }
        }

        // 1 / T_n of Chebyshev's polynomial for eigenvalues from 1 to 1 + span.
        static double ErrorLeft(int passes, double span)
        {
            double x = span > 0.0 ? (2.0 + span) / span : 1e6;
            return 1.0 / Math.Cosh(passes * Math.Log(x + Math.Sqrt(x * x - 1.0)));
        }

        static double Energy(double3[] velocities) => velocities.Sum(v => math.dot(v, v));

        static double Rms(double3[] a, double3[] b) => Math.Sqrt(a.Zip(b, math.distancesq).Average());

        /// <summary>The stage over particles that a substep without forces and corrections has just left, with neighbors listed.</summary>
        sealed class Stage : IDisposable
        {
            public readonly SolverStages Stages;
            public readonly double3[] Points;

            readonly ImplicitViscosity stage;

            public Stage(ParticleState state, double strength, long maxBinding = 0, int capacity = 0)
            {
                FluidMaterial material = FluidMaterial.Water;
                material.velocitySmoothing = 0f;
                material.wallFriction = 0f;         // so that nothing but the fluid acts
                StepInput input = SolverStages.Still(SolverStages.Roomy, material);
                input.material.dynamicViscosity = (float)(strength * material.density * SolverStages.Spacing * SolverStages.Spacing / input.timeStep);
                Stages = new SolverStages(state, input, capacity, maxBinding);
                float3[] velocities = state.velocities.Select(v => v.xyz).ToArray();
                Stages.Particles.Velocities.SetData(new float4[state.Count], 0, 0, state.Count);
                Stages.Sort().Constrain(iterations: 0).UpdateVelocities();
                Stages.Particles.Advance();
                Before = GpuTest.Read<uint>(Stages.Particles.Ids, state.Count).Select(id => new float4(velocities[id], 0.25f + id)).ToArray();
                Stages.Particles.Velocities.SetData(Before, 0, 0, state.Count);
                Points = Compare.Points(GpuTest.Read<float4>(Stages.Particles.Positions, state.Count));
                stage = new ImplicitViscosity(Stages.Layout.Capacity);
            }

            /// <summary>In the order of the sort.</summary>
            public float4[] Before { get; }

            public float4[] After => GpuTest.Read<float4>(Stages.Particles.Velocities, Before.Length);

            public Viscosity Reference => new Viscosity(Points, Neighbors.ByCells(Points, Kernels.H));

            public Stage Run()
            {
                GpuTest.Run(cmd => stage.Record(Stages.Context(cmd)));
                return this;
            }

            public void Dispose()
            {
                stage.Dispose();
                Stages.Dispose();
            }
        }
    }
}
