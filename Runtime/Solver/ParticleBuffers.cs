using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Entries of the counter buffer. Since the reset, kAdded + kEmitted + kHandedIn = kDrained + kHandedOut +
    /// kNonFinite + kAlive at the end of a step.</summary>
    [SharedWithHlsl("Counters")]
    enum ParticleCounter
    {
        /// <summary>particles at the start of the step</summary>
        Alive,
        /// <summary>of those, with a finite position: particles of this step</summary>
        Sorted,
        NextId,
        /// <summary>did not fit the capacity, since the reset</summary>
        Refused,
        /// <summary>culled, since the reset</summary>
        NonFinite,
        /// <summary>particles of this step with more neighbors than the list holds</summary>
        Overflow,
        /// <summary>most neighbors of such a particle</summary>
        MaxNeighbors,
        /// <summary>by a volume or by code</summary>
        Added,
        Emitted,
        Drained,
        /// <summary>due from an emitter and given up, since there was no room for a second</summary>
        Blocked,
        /// <summary>due from an emitter and without room so far</summary>
        Waiting,
        /// <summary>drained and not yet back from an emitter</summary>
        Recycling,
        /// <summary>took part in the last step: the first of those alive</summary>
        Moved,
        /// <summary>of the viscosity's last solve, float bits: of what neighbors brake a particle by, half the largest eigenvalue of the
        /// sum in ImplicitViscosity.compute</summary>
        ViscosityBound,
        /// <summary>of the same, float bits: largest change of a velocity in its last pass, d/s</summary>
        ViscosityChange,
        /// <summary>from a neighbor, or back from outside the box, since the reset</summary>
        HandedIn,
        /// <summary>to a neighbor, or kept outside the box, since the reset</summary>
        HandedOut,
    }

    /// <summary>The state of the particles on the GPU. Lengths in d, in the domain's frame.</summary>
    /// <remarks>
    /// Three position buffers change roles over a step: <see cref="Current"/> is sorted into <see cref="Start"/> and
    /// <see cref="Predicted"/> and is free from then on, so the passes of the constraint alternate between it and
    /// Predicted. What they end in is the next step's Current.
    /// </remarks>
    sealed class ParticleBuffers : IDisposable
    {
        /// <summary>threads of a particle kernel</summary>
        [SharedWithHlsl("Solver")] public const int Group = 128;

        /// <summary>words of the counter buffer</summary>
        [SharedWithHlsl("Counters")] public const int CounterCount = 18;

        /// <summary>
        /// Particles up to which kernels are dispatched for all of the capacity: the GPU waits less for a dispatch whose size is known, and
        /// 2,048 groups without a particle cost less than that. More run for as many as there are, by indirect arguments.
        /// </summary>
        public const int DirectCapacity = 1 << 18;

        readonly int capacity;

        /// <summary>float4 [capacity], xyz position at the start of a step.</summary>
        public GraphicsBuffer Current;
        /// <summary>float4 [capacity], the same, sorted.</summary>
        public GraphicsBuffer Start;
        /// <summary>float4 [capacity], sorted: predicted, then corrected position.</summary>
        public GraphicsBuffer Predicted;
        /// <summary>float4 [capacity], xyz velocity, d/s; w density relative to rest.</summary>
        public GraphicsBuffer Velocities;
        /// <summary>uint [capacity].</summary>
        public GraphicsBuffer Ids;
        /// <summary>uint [capacity], the ids in this step's order.</summary>
        public GraphicsBuffer SortedIds;
        /// <summary>uint [<see cref="CounterCount"/>], by <see cref="ParticleCounter"/>.</summary>
        public GraphicsBuffer Counters;
        /// <summary>Arguments for the particles alive at the start of a step, and to draw them.</summary>
        public GraphicsBuffer AliveArguments;
        /// <summary>Arguments for the particles of this step.</summary>
        public GraphicsBuffer SortedArguments;

        public ParticleBuffers(int capacity)
        {
            this.capacity = capacity;
            Current = GpuBuffer.Structured<float4>("Rill.Positions", capacity);
            Start = GpuBuffer.Structured<float4>("Rill.StartPositions", capacity);
            Predicted = GpuBuffer.Structured<float4>("Rill.Predicted", capacity);
            Velocities = GpuBuffer.Structured<float4>("Rill.Velocities", capacity);
            Ids = GpuBuffer.Structured<uint>("Rill.Ids", capacity);
            SortedIds = GpuBuffer.Structured<uint>("Rill.SortedIds", capacity);
            Counters = GpuBuffer.Structured<uint>("Rill.Counters", CounterCount);
            AliveArguments = GpuBuffer.Arguments("Rill.AliveArguments");
            SortedArguments = GpuBuffer.Arguments("Rill.SortedArguments");
        }

        /// <summary>The same as a set that transfers give to and take from.</summary>
        /// <param name="tags">Null for none.</param>
        public ParticleSet AsSet(ParticleTags tags)
            => new ParticleSet(Current, Velocities, Ids, tags?.Current, Counters, AliveArguments, capacity);

        /// <summary>Groups of <see cref="Group"/> threads that hold so many.</summary>
        public static int Groups(int count) => (count + Group - 1) / Group;

        /// <summary>Records a kernel for the particles alive at the start of a step.</summary>
        public void DispatchAlive(CommandBuffer cmd, ComputeShader shader, int kernel) => Dispatch(cmd, shader, kernel, AliveArguments);

        /// <summary>Records a kernel for the particles of this step.</summary>
        public void DispatchSorted(CommandBuffer cmd, ComputeShader shader, int kernel) => Dispatch(cmd, shader, kernel, SortedArguments);

        /// <summary>Records a kernel that begins with the bounds test of its particle.</summary>
        void Dispatch(CommandBuffer cmd, ComputeShader shader, int kernel, GraphicsBuffer arguments)
        {
            if (capacity <= DirectCapacity)
                cmd.DispatchCompute(shader, kernel, Groups(capacity), 1, 1);
            else
                cmd.DispatchCompute(shader, kernel, arguments, GpuBuffer.DispatchArgumentsAt);
        }

        /// <summary>After the velocity update: the corrected positions and the sorted ids are the state.</summary>
        public void Advance()
        {
            (Current, Predicted) = (Predicted, Current);
            (Ids, SortedIds) = (SortedIds, Ids);
        }

        /// <summary>A stage that changed places with the velocities has left them in a buffer of its own.</summary>
        public void NameVelocities()
        {
            if (Velocities != null)
                Velocities.name = "Rill.Velocities";
        }

        public void Dispose()
        {
            GpuBuffer.Release(ref Current);
            GpuBuffer.Release(ref Start);
            GpuBuffer.Release(ref Predicted);
            GpuBuffer.Release(ref Velocities);
            GpuBuffer.Release(ref Ids);
            GpuBuffer.Release(ref SortedIds);
            GpuBuffer.Release(ref Counters);
            GpuBuffer.Release(ref AliveArguments);
            GpuBuffer.Release(ref SortedArguments);
        }

        public void Describe(StageDescription stage)
        {
            stage.Buffer("Rill.Positions", Current);
            stage.Buffer("Rill.StartPositions", Start);
            stage.Buffer("Rill.Predicted", Predicted);
            stage.Buffer("Rill.Velocities", Velocities);
            stage.Buffer("Rill.Ids", Ids);
            stage.Buffer("Rill.SortedIds", SortedIds);
            stage.Buffer("Rill.Counters", Counters);
            stage.Buffer("Rill.AliveArguments", AliveArguments);
            stage.Buffer("Rill.SortedArguments", SortedArguments);
        }
    }
}
