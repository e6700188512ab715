using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Random = Unity.Mathematics.Random;

namespace Host.Report.Extremes
{
    /// <summary>A solver to stress, measured as it goes. Positions in spacings d, everything else in SI units.</summary>
    sealed class ExtremeFluid : IDisposable
    {
        const int StepsAtOnce = 20;

        public readonly PbfSolver Solver;
        public StepInput Input;
        public readonly List<FluidStatistics> Samples = new();

        readonly CommandBuffer commands = new() { name = "extreme" };

        /// <param name="box">d.</param>
        /// <param name="spacing">m.</param>
        public ExtremeFluid(float3 box, float spacing, int capacity, SolverSettings settings)
        {
            Input = ExperimentFigures.Input(settings);
            Solver = new PbfSolver(new SolverLayout(box * spacing, spacing, capacity, settings.neighborCapacity, settings.listMargin));
        }

        public ExtremeFluid(ExperimentScene scene, SolverSettings settings) : this(scene.Box, scene.Spacing, scene.Particles, settings)
        {
            scene.Fill(Solver);
            Added = scene.Particles;
        }

        /// <summary>Particles given to the solver.</summary>
        public long Added { get; private set; }
        public float Spacing => Solver.Layout.Spacing;
        public ExtremeCounts Counts => ExtremeCounts.Of(Added, Samples);
        public FluidStatistics Last => Samples[^1];

        /// <param name="velocity">m/s.</param>
        public ExtremeFluid Add(IEnumerable<float3> points, float3 velocity = default)
        {
            using var positions = new NativeArray<float4>(points.Select(p => new float4(p * Spacing, 0f)).ToArray(), Allocator.Persistent);
            using var velocities = new NativeArray<float4>(Enumerable.Repeat(new float4(velocity, 0f), positions.Length).ToArray(),
                Allocator.Persistent);
            Solver.Add(positions, velocities);
            Added += positions.Length;
            return this;
        }

        /// <param name="corner">Where the lattice's first cell begins.</param>
        /// <param name="pitch">Side of the lattice's cells, d: 0.5 is eight times the density.</param>
        public ExtremeFluid AddLattice(float3 corner, int3 counts, float3 velocity = default, float pitch = 1f)
            => Add(Lattice(corner, counts, pitch), velocity);

        public static IEnumerable<float3> Lattice(float3 corner, int3 counts, float pitch = 1f)
        {
            var random = new Random(7);
            var positions = new List<float3>();
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                        positions.Add(corner + (new float3(x, y, z) + 0.5f + random.NextFloat3(-0.02f, 0.02f)) * pitch);
            return positions;
        }

        /// <param name="every">Steps between measurements; the last step is always measured.</param>
        public ExtremeFluid Step(int steps, int every)
        {
            if (Samples.Count == 0)
                Measure();
            for (int step = 1; step <= steps; step++)
            {
                Solver.Step(commands, Stable());
                bool measure = step % every == 0 || step == steps;
                if (measure || step % StepsAtOnce == 0)
                {
                    Graphics.ExecuteCommandBuffer(commands);
                    commands.Clear();
                }
                if (measure)
                    Measure();
            }
            return this;
        }

        /// <summary>Steps in which a collider moves from where it was to where it is told.</summary>
        /// <param name="pose">By the time since the first of these steps, s; the collider is there at 0.</param>
        /// <param name="after">After every step, with the time and the pose; null for none.</param>
        public ExtremeFluid StepAmong(ColliderMotion obstacle, Func<float, RigidPose> pose, int steps, int every, Action<RigidPose> after = null)
        {
            if (Samples.Count == 0)
                Measure();
            Input.colliders ??= new ColliderSet { Count = 1, Version = 1, Order = 1 };
            Input.frameTo = 1f;
            obstacle.end = pose(0f);
            for (int step = 1; step <= steps; step++)
            {
                obstacle.start = obstacle.end;
                obstacle.end = pose(step * Input.timeStep);
                Input.colliders.Items[0] = obstacle;
                Solver.Step(commands, Stable());
                Graphics.ExecuteCommandBuffer(commands);
                commands.Clear();
                after?.Invoke(obstacle.end);
                if (step % every == 0 || step == steps)
                    Measure();
            }
            return this;
        }

        public ExtremeFluid Seconds(double seconds, int every = 10) => Step((int)Math.Round(seconds / Input.timeStep), every);

        /// <summary>Mean over the samples of the last seconds.</summary>
        public double Settled(Func<FluidStatistics, double> value, double seconds = 2)
        {
            double end = Last.step * (double)Input.timeStep;
            return Samples.Where(s => s.step * (double)Input.timeStep > end - seconds - 1e-6).Average(value);
        }

        /// <summary>Highest energy of all samples over that of the first.</summary>
        public double MaxEnergy => Samples.Max(s => s.Energy) / Samples[0].Energy;

        /// <summary>Highest energy of a sample less the least before it, as a fraction of the first.</summary>
        public double MaxRise
        {
            get
            {
                double rise = 0, least = double.MaxValue;
                foreach (FluidStatistics sample in Samples)
                {
                    least = Math.Min(least, sample.Energy);
                    rise = Math.Max(rise, sample.Energy - least);
                }
                return rise / Math.Abs(Samples[0].Energy);
            }
        }

        /// <summary>Ids of all particles, in the order of the positions.</summary>
        public uint[] ReadIds()
        {
            var ids = new uint[Last.particles];
            Solver.ParticleIds.GetData(ids, 0, 0, ids.Length);
            return ids;
        }

        /// <summary>Positions of all particles, d.</summary>
        public float3[] Read()
        {
            var positions = new float4[Last.particles];
            if (positions.Length > 0)
                Solver.Positions.GetData(positions, 0, 0, positions.Length);
            return positions.Select(p => p.xyz).ToArray();
        }

        public void Dispose()
        {
            commands.Dispose();
            Solver.Dispose();
        }

        // Input that the component would give the solver.
        StepInput Stable()
        {
            StepInput stable = Input;
            stable.settings.relaxation = Input.settings.StableRelaxation(Solver.IsDeep(Input));
            stable.settings.substeps = Input.settings.StableSubsteps(math.length(Input.gravity) * Input.timeStep * Input.timeStep / Spacing);
            return stable;
        }

        void Measure()
        {
            Solver.RecordStatistics(commands, Input);
            Graphics.ExecuteCommandBuffer(commands);
            commands.Clear();
            Solver.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            if (!Solver.TryGetStatistics(Input, out FluidStatistics statistics))
                throw new InvalidOperationException("The statistics did not come with the device's other answers.");
            Samples.Add(statistics);
        }
    }
}
