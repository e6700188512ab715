using System;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    public class VorticityConfinementTests
    {
        const double TimeStep = 1.0 / 60.0;
        const float Vorticity = 0.5f, Viscosity = 0.2f;

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Curl_is_that_of_the_reference(int count)
        {
            using (var swirl = new Swirl(ParticleState.Random(count, seed: count, speed: 20f), Vorticity))
            {
                Velocities reference = swirl.Reference;
                Compare.Vectors("curl", count, i => swirl.Curl[i].xyz, i => reference.Curl(i).value, i => 1e-4 + 1e-5 * reference.Curl(i).size);
                Compare.Scalars("its magnitude", count, i => swirl.Curl[i].w, i => math.length((double3)swirl.Curl[i].xyz),
                    i => 1e-4 + 1e-5 * swirl.Curl[i].w);
            }
        }

        [TestCaseSource(typeof(GpuTest), nameof(GpuTest.Sizes))]
        public void Confined_velocities_are_those_of_the_reference(int count)
        {
            using (var swirl = new Swirl(ParticleState.Random(count, seed: count + 1, speed: 20f), Vorticity))
            {
                Velocities reference = swirl.Reference;
                double3[] curls = Compare.Points(swirl.Curl);
                double[] magnitudes = swirl.Curl.Select(curl => (double)curl.w).ToArray();
                double strength = Vorticity / SolverStages.Spacing;
                Compare.Vectors("velocities", count, i => swirl.Confined[i].xyz,
                    i => reference.Confined(i, curls, magnitudes, strength, TimeStep, Viscosity), Tolerance);

                // The direction of a short eta is uncertain.
                double Tolerance(int i)
                {
                    VectorSum eta = reference.Eta(i, magnitudes);
                    double turn = Math.Min(2.0, (1e-6 + 1e-5 * eta.size) / Math.Max(math.length(eta.value), 1e-30));
                    return 2e-4 + turn * strength * TimeStep * magnitudes[i];
                }
            }
        }

        [Test]
        public void The_density_comes_with_the_confined_velocities()
        {
            using (var swirl = new Swirl(ParticleState.Random(997, seed: 2, speed: 5f), Vorticity))
            {
                var reference = new Constraint(swirl.Stages.Layout.DomainSize, swirl.Points, swirl.Neighbors);
                Compare.Scalars("densities", 997, i => swirl.Confined[i].w, reference.Density, i => 1e-5 * (1.0 + swirl.Confined[i].w));
            }
        }

        [Test]
        public void A_block_that_turns_as_one_has_its_curl_along_the_axis()
        {
            ParticleState state = ParticleState.Lattice(30f, 10f, 9).With(p => math.cross(new float3(0f, 0f, 4f), p - 14f));
            using (var swirl = new Swirl(state, Vorticity))
            {
                int center = Array.FindIndex(swirl.Points, p => math.distance(p, 14.0) < 1e-3);
                float4 curl = swirl.Curl[center];
                Assert.That(curl.z, Is.GreaterThan(4f), "twice the rate of turning, as far as the kernel sums to one");
                Assert.That(math.abs(curl.x) + math.abs(curl.y), Is.LessThan(1e-2f));
                Assert.That(curl.w, Is.EqualTo(curl.z).Within(1e-3));
            }
        }

        [Test]
        public void Fluid_that_moves_as_one_is_left_alone()
        {
            ParticleState state = ParticleState.Lattice(40f, 10f, 10).With(p => new float3(2f, 4f, -8f));
            using (var swirl = new Swirl(state, vorticity: 10f))
                Compare.Vectors("velocities", state.Count, i => swirl.Confined[i].xyz, i => new double3(2.0, 4.0, -8.0), i => 1e-2);
        }

        [Test]
        public void Places_past_the_particles_are_left_alone()
        {
            using (var swirl = new Swirl(ParticleState.Random(200, seed: 3, speed: 5f), Vorticity, maxBinding: 0, capacity: 300))
                Assert.That(GpuTest.Read<float4>(swirl.CurlBuffer, 300).Skip(200).All(GpuTest.IsGarbage));
        }

        [Test]
        public void Without_particles_nothing_is_written()
        {
            using (var swirl = new Swirl(ParticleState.Random(0, seed: 4), Vorticity))
                foreach (GraphicsBuffer buffer in new[] { swirl.CurlBuffer, swirl.Stages.Particles.Velocities })
                    Assert.That(GpuTest.Read<float4>(buffer, swirl.Stages.Layout.Capacity).All(GpuTest.IsGarbage));
        }

        [Test]
        public void Two_lists_give_the_result_of_one_bit_for_bit()
        {
            ParticleState state = ParticleState.Random(997, seed: 5, speed: 10f);
            using (var one = new Swirl(state, Vorticity))
            using (var two = new Swirl(state, Vorticity, maxBinding: 96 * 4 * 512))
            {
                Assert.That(two.Stages.Layout.TwoLists);
                Compare.Same("velocities", two.Confined, one.Confined);
            }
        }

        /// <summary>The stage run once over particles that no constraint has moved, and its reference.</summary>
        sealed class Swirl : IDisposable
        {
            public readonly SolverStages Stages;
            public readonly float4[] Curl, Confined;
            public readonly double3[] Points;
            public readonly int[][] Neighbors;
            public readonly Velocities Reference;

            readonly VorticityConfinement stage;

            public Swirl(ParticleState state, float vorticity, long maxBinding = 0, int capacity = 0)
            {
                FluidMaterial material = FluidMaterial.Water;
                material.vorticity = vorticity;
                material.velocitySmoothing = Viscosity;
                Stages = new SolverStages(state, SolverStages.Still(SolverStages.Roomy, material), capacity, maxBinding);
                Stages.Sort().Constrain(iterations: 0).UpdateVelocities();
                Points = Compare.Points(Stages.Predicted);
                Neighbors = Rill.Tests.Reference.Neighbors.ByCells(Points, Kernels.H);
                Reference = new Velocities(Points, Compare.Points(Stages.Velocities), Neighbors);

                stage = new VorticityConfinement(Stages.Layout.Capacity);
                GpuTest.FillWithGarbage(stage.Unconfined);
                if (Stages.Sorted > 0)
                    stage.Unconfined.SetData(Stages.Velocities);
                GpuTest.FillWithGarbage(stage.Curl);
                GpuTest.FillWithGarbage(Stages.Particles.Velocities);
                GpuTest.Run(cmd => stage.Record(Stages.Context(cmd)));
                Curl = GpuTest.Read<float4>(stage.Curl, Stages.Sorted);
                Confined = Stages.Velocities;
            }

            public GraphicsBuffer CurlBuffer => stage.Curl;

            public void Dispose()
            {
                stage.Dispose();
                Stages.Dispose();
            }
        }
    }
}
