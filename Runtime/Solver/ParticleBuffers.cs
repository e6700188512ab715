using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Entries of the counter buffer. Since the reset, kAdded + kEmitted + kHandedIn = kDrained + kHandedOut +
    /// kNonFinite + kAlive at the end of a step.</summary>
    [GenerateHlsl("Counters")]
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
        /// <summary>due from an emitter and given up after a second without room</summary>
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
    /// A substep sorts <see cref="Positions"/> into <see cref="Start"/> and <see cref="Predicted"/>. The passes of the constraint alternate
    /// between Predicted and <see cref="Multipliers"/>, which takes the memory of Positions until <see cref="Advance"/> makes Predicted the
    /// state. The two change places there, and so do the ids: each pair is named A and B on the GPU.
    /// </remarks>
    sealed class ParticleBuffers : IDisposable
    {
        /// <summary>threads of a particle kernel</summary>
        [GenerateHlsl("Solver")] public const int Group = 128;

        /// <summary>words of the counter buffer</summary>
        [GenerateHlsl("Counters")] public const int CounterCount = 18;

        /// <summary>
        /// Particles up to which kernels are dispatched for all of the capacity: the GPU waits less for a dispatch whose size is known, and
        /// 2,048 groups without a particle cost less than that. More run for as many as there are, by indirect arguments.
        /// </summary>
        public const int DirectCapacity = 1 << 18;

        readonly int capacity;
        readonly BufferSet buffers = new BufferSet();
        GraphicsBuffer positions, predicted, ids, sortedIds;

        /// <summary>float4 [capacity], xyz position: the state between substeps, until the sort has read it.</summary>
        public GraphicsBuffer Positions => positions;
        /// <summary>float4 [capacity], sorted, in the memory of <see cref="Positions"/> from the sort to the end of the substep: xyz the position
        /// that a particle's multiplier was found at, w the multiplier.</summary>
        public GraphicsBuffer Multipliers => Positions;
        /// <summary>float4 [capacity], the same, sorted.</summary>
        public GraphicsBuffer Start { get; }
        /// <summary>float4 [capacity], sorted: predicted, then corrected position.</summary>
        public GraphicsBuffer Predicted => predicted;
        /// <summary>float4 [capacity], xyz velocity, d/s; w density relative to rest, 1 where no stage sums it.</summary>
        public GraphicsBuffer Velocities { get; }
        /// <summary>uint [capacity].</summary>
        public GraphicsBuffer Ids => ids;
        /// <summary>uint [capacity], the ids in this step's order.</summary>
        public GraphicsBuffer SortedIds => sortedIds;
        /// <summary>uint [<see cref="CounterCount"/>], by <see cref="ParticleCounter"/>.</summary>
        public GraphicsBuffer Counters { get; }
        /// <summary>Arguments for the particles alive at the start of a step, and to draw them.</summary>
        public GraphicsBuffer AliveArguments { get; }
        /// <summary>Arguments for the particles of this step.</summary>
        public GraphicsBuffer SortedArguments { get; }

        public ParticleBuffers(int capacity)
        {
            this.capacity = capacity;
            positions = buffers.Structured<float4>("Rill.PositionsA", capacity, "_Positions");
            Start = buffers.Structured<float4>("Rill.StartPositions", capacity);
            predicted = buffers.Structured<float4>("Rill.PositionsB", capacity, "_Predicted");
            Velocities = buffers.Structured<float4>("Rill.Velocities", capacity);
            ids = buffers.Structured<uint>("Rill.IdsA", capacity, "_Ids");
            sortedIds = buffers.Structured<uint>("Rill.IdsB", capacity, "_SortedIds");
            Counters = buffers.Structured<uint>("Rill.Counters", CounterCount);
            AliveArguments = buffers.Arguments("Rill.AliveArguments");
            SortedArguments = buffers.Arguments("Rill.SortedArguments");
        }

        /// <summary>Records the state as what a kernel reads and writes: positions, those at the start of the substep, velocities, ids,
        /// counters and arguments of those alive. What a kernel finds elsewhere is recorded after this.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            ParticleIds.State.Bind(cmd, shader, kernel, positions, Start, Velocities, ids, Counters, AliveArguments);
        }

        /// <summary>Returns the particles as a set that transfers give to and take from.</summary>
        /// <param name="tags">Null for none.</param>
        public ParticleSet AsSet(ParticleTags tags)
            => new ParticleSet(Positions, Velocities, Ids, tags?.Current, Counters, AliveArguments, capacity);

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
            buffers.Swap(ref positions, ref predicted);
            buffers.Swap(ref ids, ref sortedIds);
        }

        public void Dispose() => buffers.Dispose();

        public void Describe(StageDescription stage) => buffers.Describe(stage);
    }

    /// <summary>Properties of the buffers of particles and cells in all shaders.</summary>
    static class ParticleIds
    {
        public static readonly ShaderParameters State = new ShaderParameters(
            "_Positions", "_StartPositions", "_Velocities", "_Ids", "_Counters", "_AliveArguments");
        public static readonly ShaderParameters Motion = new ShaderParameters("_Positions", "_Velocities");
        /// <summary>Positions that a pass of the constraint reads, and those that it writes.</summary>
        public static readonly ShaderParameters Pass = new ShaderParameters("_Positions", "_Corrected");
        public static readonly ShaderParameters Cells = new ShaderParameters("_CellStarts", "_Order");
        public static readonly int Positions = Shader.PropertyToID("_Positions");
        public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
        public static readonly int Velocities = Shader.PropertyToID("_Velocities");
        public static readonly int Ids = Shader.PropertyToID("_Ids");
        public static readonly int Counters = Shader.PropertyToID("_Counters");
        public static readonly int CellStarts = Shader.PropertyToID("_CellStarts");
    }
}
