using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Report
{
    /// <summary>A scene played step by step, with what can be asked of its state in between. Meters and seconds.</summary>
    sealed class FluidRun : IDisposable
    {
        public readonly PbfSolver Solver;
        public StepInput Input;
        readonly string name;
        readonly int particles;
        readonly CommandBuffer commands = new() { name = "run" };

        public FluidRun(ExperimentScene scene, in StepInput input) : this(scene.Name, scene.Domain, scene.Spacing, scene.Particles, input)
        {
            scene.Fill(Solver);
        }

        /// <param name="box">d.</param>
        /// <param name="places">d.</param>
        /// <param name="velocity">Of the particle at a point, m/s.</param>
        public FluidRun(string name, float3 box, float spacing, IReadOnlyList<float3> points, Func<float3, float3> velocity,
            in StepInput input) : this(name, box * spacing, spacing, points.Count, input)
        {
            using var positions = new NativeArray<float4>(points.Select(p => new float4(p * spacing, 0f)).ToArray(), Allocator.Persistent);
            using var velocities = new NativeArray<float4>(points.Select(p => new float4(velocity(p), 0f)).ToArray(), Allocator.Persistent);
            Solver.Add(positions, velocities);
        }

        FluidRun(string name, float3 domain, float spacing, int particles, in StepInput input)
        {
            this.name = name;
            this.particles = particles;
            Input = input;
            Solver = new PbfSolver(new SolverLayout(domain, spacing, particles, input.settings.neighborCapacity, input.settings.listMargin));
        }

        /// <summary>60 steps a second under gravity, water, the default settings with these changed.</summary>
        public static StepInput Water(int substeps, int iterations, DeepWater deepWater = DeepWater.On)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = substeps;
            settings.iterations = iterations;
            settings.deepWater = deepWater;
            return ExperimentFigures.Input(settings);
        }

        /// <summary>Adds a block of particles on a lattice, with the small offsets with which fluid is filled in.</summary>
        /// <param name="corner">Lowest coordinates of the block, d.</param>
        public static void AddBlock(List<float3> positions, float3 corner, int3 counts, ref Unity.Mathematics.Random random)
        {
            for (int x = 0; x < counts.x; x++)
                for (int y = 0; y < counts.y; y++)
                    for (int z = 0; z < counts.z; z++)
                        positions.Add(corner + new float3(x, y, z) + 0.5f + random.NextFloat3(-0.02f, 0.02f));
        }

        /// <summary>Damping of a wave or a swing by a first-order step alone: ω² Δt / 2, 1/s.</summary>
        /// <param name="period">s.</param>
        public static double FirstOrderDamping(double period, in StepInput input)
        {
            double frequency = 2 * Math.PI / period;
            return frequency * frequency * (input.timeStep / input.settings.substeps) / 2;
        }

        public const float Gravity = ExperimentFigures.Gravity;

        /// <summary>Steps taken.</summary>
        public int Steps { get; private set; }
        public double Time => Steps * (double)Input.timeStep;
        /// <summary>s.</summary>
        public float Substep => Input.timeStep / Input.settings.substeps;

        public void Step()
        {
            Record(cmd => Solver.Step(cmd, Input));
            Steps++;
        }

        /// <summary>Puts these colliders instead of those before; each moves from its start to its end in a step.</summary>
        public void Use(params ColliderMotion[] motions)
        {
            Input.colliders ??= new ColliderSet();
            if (Input.colliders.Count != motions.Length)
            {
                Input.colliders.Version++;
                Input.colliders.Order++;
            }
            motions.CopyTo(Input.colliders.Items, 0);
            Input.colliders.Count = motions.Length;
            Input.frameTo = 1f;
        }

        /// <summary>Reads the positions of the particles alive, d.</summary>
        public float4[] ReadPositions()
        {
            int alive = (int)Read<uint>(Solver.Counters, Solver.Counters.count)[(int)ParticleCounter.Alive];
            if (alive != particles)
                throw new HostException($"{name}: {alive:N0} of {particles:N0} particles are left at step {Steps}; what is measured needs all.");
            return Read<float4>(Solver.Positions, alive);
        }

        /// <summary>In the order of the positions, d/s.</summary>
        public float4[] ReadVelocities() => Read<float4>(Solver.Velocities, particles);

        public static T[] Read<T>(GraphicsBuffer buffer, int count) where T : struct
        {
            var data = new T[count];
            buffer.GetData(data, 0, 0, count);
            return data;
        }

        public FluidStatistics Measure()
        {
            Record(cmd => Solver.RecordStatistics(cmd, Input));
            Solver.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            Solver.TryGetStatistics(Input, out FluidStatistics statistics);
            return statistics;
        }

        public void Dispose()
        {
            Solver.Dispose();
            commands.Dispose();
        }

        void Record(Action<CommandBuffer> record)
        {
            commands.Clear();
            record(commands);
            Graphics.ExecuteCommandBuffer(commands);
        }
    }
}
