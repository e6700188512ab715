using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Fluids for probes and detectors to ask, and what they should say, by the particles themselves.</summary>
    static class QueryScene
    {
        public const float Spacing = 0.05f;

        public static FluidProbe Probe(this SourceScene scene, Vector3 at) => scene.Add<FluidProbe>(at, Vector3.forward);

        /// <summary>Takes steps and lets the results come, as the frames of a player do.</summary>
        public static SourceScene Run(this SourceScene scene, int steps)
        {
            for (int i = 0; i < steps; i++)
            {
                scene.Step();
                scene.Fluid.FlushQueries();
            }
            return scene;
        }

        /// <summary>Reads a million times between frames of two lengths, before and after results come, and across restarts.</summary>
        /// <param name="read">Gets how many times to read.</param>
        public static void ReadAtAnyTime(FluidSimulation fluid, Action<int> read)
        {
            for (int round = 0; round < 50; round++)
            {
                read(5000);
                for (int frame = 0; frame < 5; frame++)
                {
                    fluid.Advance(frame % 2 == 0 ? 1f / 144f : 1f / 50f);
                    read(3000);
                    if (round % 3 == frame % 3)
                        fluid.FlushQueries();
                }
                if (round % 2 == 0)
                    fluid.Restart();
            }
        }

        /// <summary>Particles on a lattice in the box where they satisfy a condition, at one velocity. World space, m.</summary>
        public static int AddWhere(this SourceScene scene, Func<Vector3, bool> isWater, Vector3 velocity = default)
        {
            float d = scene.Fluid.ParticleSpacing;
            Vector3 box = scene.Fluid.DomainSize;
            int3 counts = (int3)math.round((float3)box / d);
            var points = new List<float3>();
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                    {
                        Vector3 position = new Vector3(x + 0.5f, y + 0.5f, z + 0.5f) * d - box * 0.5f;
                        if (isWater(position))
                            points.Add(position);
                    }
            using (var positions = new NativeArray<float3>(points.ToArray(), Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(Enumerable.Repeat((float3)velocity, points.Count).ToArray(), Allocator.Persistent))
                scene.Fluid.AddParticles(positions, velocities);
            return points.Count;
        }

        /// <summary>The newest sample, waiting for the device; fails where it is not valid.</summary>
        public static FluidProbeSample Flushed(this FluidProbe probe)
        {
            probe.Flush();
            Assert.That(probe.TryGetSample(out FluidProbeSample sample), "a valid sample");
            Assert.That(sample.step, Is.EqualTo(probe.Simulation.StepCount));
            return sample;
        }

        /// <summary>Returns the newest sample of a detector, likewise.</summary>
        public static FluidDetectorSample Flushed(this FluidDetector detector)
        {
            detector.Flush();
            Assert.That(detector.TryGetSample(out FluidDetectorSample sample), "a valid sample");
            Assert.That(sample.step, Is.EqualTo(detector.Simulation.StepCount));
            return sample;
        }

        /// <summary>Density at a point, in d, relative to rest, over what the walls leave: by all particles.</summary>
        public static double Density(ParticleState state, double3 at)
        {
            double sum = 0.0;
            foreach (float4 position in state.positions)
                sum += Reference.Kernels.Poly6(math.distance((double3)position.xyz, at));
            return sum / Reference.Kernels.RestDensity / Math.Max(1.0 - Reference.Walls.Density(at, state.box), 0.1);
        }

        /// <summary>Height of the highest place on the vertical line through a place where the density is half that of rest, d: from the
        /// lid down in steps of half a spacing, and between two on a line. NaN for none.</summary>
        public static double Surface(ParticleState state, double3 at)
        {
            double above = 0.0;
            for (double y = state.box.y; y >= 0.0; y -= 0.5)
            {
                double density = Density(state, new double3(at.x, y, at.z));
                if (density >= 0.5)
                    return y == state.box.y ? y : y + 0.5 * (density - 0.5) / (density - above);
                above = density;
            }
            return double.NaN;
        }

        /// <summary>Mean velocity by the same weights, d/s.</summary>
        public static double3 Velocity(ParticleState state, double3 at)
        {
            double3 sum = 0.0;
            double weights = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                double weight = Reference.Kernels.Poly6(math.distance((double3)state.positions[i].xyz, at));
                sum += weight * (double3)state.velocities[i].xyz;
                weights += weight;
            }
            return sum / weights;
        }
    }
}
