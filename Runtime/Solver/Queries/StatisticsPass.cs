using System;
using Unity.Collections;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Measures the fluid at the end of a step and brings the result back without waiting. Made when first needed.</summary>
    sealed class StatisticsPass : Stage
    {
        /// <summary>of C+ between 0 and kMaxBin, finer towards 0: bin ~ sqrt(C+)</summary>
        [GenerateHlsl("Statistics")] const int Bins = 4096;

        /// <summary>d: how far beyond the walls and inside colliders a particle counts as escaped</summary>
        [GenerateHlsl("Statistics")] public const float EscapedBeyond = 0.1f;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Statistics");

        readonly ComputeShader shader = StageShader.LoadCompute("Statistics");
        readonly KernelVariants measure;        // with colliders
        readonly Kernel reduce, measurePhases, reducePhases;
        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.Statistics.Results", FluidStatistics.BlockSize));
        readonly int groups;
        GraphicsBuffer partials, histogram, phasePartials;

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public StatisticsPass(int capacity, ReadbackErrors errors = null)
        {
            readback.Report(errors, ReadbackKinds.Statistics);
            readback.Lost = readback.Invalidate;        // an older one would be taken for new
            measure = new KernelVariants(shader, "Measure", "MeasureWithColliders");
            reduce = new Kernel(shader, "Reduce");
            measurePhases = new Kernel(shader, "MeasurePhases");
            reducePhases = new Kernel(shader, "ReducePhases");
            groups = ParticleBuffers.Groups(capacity);
            partials = Buffers.Structured<float>("Rill.Statistics.Partials", (long)groups * FluidStatistics.QuantityCount);
            histogram = Buffers.Structured<uint>("Rill.Statistics.Histogram", Bins);
            Buffers.AddShared("Rill.Statistics.Results", readback.Buffer, "_Statistics");
            BufferClear.Now(histogram);
        }

        /// <summary>Whether a result is pending; a new one is asked for only after it has come.</summary>
        public bool IsPending => readback.IsPending;

        /// <summary>Whether <see cref="Latest"/> holds a result of the time since the last <see cref="PbfSolver.Clear"/>.</summary>
        public bool HasResult => readback.HasResult;

        /// <summary>The newest result, uint bits as Statistics.compute writes them.</summary>
        public NativeArray<uint> Latest => readback.Latest;

        /// <summary>Records the measuring of the current state; the boundary of the colliders lies ready at rest.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            cmd.BeginSample(Marker);
            step.Search.RecordOrderAtRest(step);
            step.BindConstants(shader);

            int kernel = measure.For(step.Colliders != null);
            Ids.Colliders.Bind(cmd, shader, kernel, step.Colliders?.Boundary, step.Colliders?.ContactOffsets);
            particles.Bind(cmd, shader, kernel);
            step.BindOrderAtRest(shader, kernel);
            Buffers.Bind(cmd, shader, kernel);
            cmd.DispatchCompute(shader, kernel, particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);

            particles.Bind(cmd, shader, reduce);
            Buffers.Bind(cmd, shader, reduce);
            cmd.DispatchCompute(shader, reduce, 1, 1, 1);
            if (step.Input.HasPhases)
                RecordPhases(step);
            cmd.EndSample(Marker);
        }

        // After the reduction, which clears the sums of the phases.
        void RecordPhases(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            phasePartials ??= Buffers.Structured<float>("Rill.Statistics.PhasePartials", (long)groups * FluidStatistics.PhaseSums);
            step.Particles.Bind(cmd, shader, measurePhases);
            Ids.Phases.Bind(cmd, shader, measurePhases, step.Search.CellOrder, step.Tags);
            Buffers.Bind(cmd, shader, measurePhases);
            cmd.DispatchCompute(shader, measurePhases, step.Particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);

            step.Particles.Bind(cmd, shader, reducePhases);
            Buffers.Bind(cmd, shader, reducePhases);
            cmd.DispatchCompute(shader, reducePhases, FluidStatistics.PhaseSums, 1, 1);
        }

        /// <summary>Asks for what was recorded, after its command buffer was executed. Nothing while a result is pending.</summary>
        public void Request() => readback.Request();

        /// <summary>Waits for the result that is pending, and for nothing else.</summary>
        public void Complete() => readback.Complete();

        /// <summary>Results from before a restart are dropped when they come.</summary>
        public override bool Survives(ParticleChange change)
        {
            if (change == ParticleChange.Restarted)
                readback.Invalidate();
            return true;
        }

        public override void Dispose()
        {
            readback.Dispose();
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        /// <param name="interval">Steps between measurements; 0 for none.</param>
        public static StageDescription Describe(StatisticsPass stage, in StepContext step, int interval)
        {
            var description = new StageDescription("Statistics", interval > 0, interval > 0
                ? Invariant($"measured every {interval} steps, outside the step") : "the statistics interval is 0");
            if (stage == null)
                return description;
            step.Search.DescribeOrderAtRest(description);
            if (step.Colliders != null)
                description.Kernel(step.Colliders.FindBoundary, 0);
            description.Kernel(stage.measure.For(step.Colliders != null), 0);
            description.Kernel(stage.reduce, 0);
            if (step.Input.HasPhases)
            {
                description.Kernel(stage.measurePhases, 0);
                description.Kernel(stage.reducePhases, 0);
            }
            stage.Buffers.Describe(description);
            return description;
        }

        static class Ids
        {
            public static readonly ShaderParameters Colliders = new ShaderParameters("_Boundary", "_Distances");
            public static readonly ShaderParameters Phases = new ShaderParameters("_Order", "_Tags");
        }
    }
}
