using System;
using Host.Fluids;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Report
{
    /// <summary>A scene played step by step, with what can be asked of its state in between. Metres and seconds.</summary>
    sealed class FluidRun : IDisposable
    {
        public readonly PbfSolver Solver;
        public StepInput Input;
        readonly ExperimentScene scene;
        readonly CommandBuffer commands = new() { name = "run" };

        public FluidRun(ExperimentScene scene, in StepInput input)
        {
            this.scene = scene;
            Input = input;
            Solver = new PbfSolver(new SolverLayout(scene.Domain, scene.Spacing, scene.Particles, input.settings.neighborCapacity, input.settings.listMargin));
            scene.Fill(Solver);
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

        /// <summary>Of the particles alive, d.</summary>
        public float4[] ReadPositions()
        {
            int alive = (int)Read<uint>(Solver.Counters, Solver.Counters.count)[(int)ParticleCounter.Alive];
            if (alive != scene.Particles)
                throw new HostException($"{scene.Name}: {alive:N0} of {scene.Particles:N0} particles are left at step {Steps}; what is measured needs all.");
            return Read<float4>(Solver.Positions, alive);
        }

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
