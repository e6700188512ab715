using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>A whole solver without a component around it. Meters and seconds, in the domain's frame.</summary>
    sealed class TestFluid : IDisposable
    {
        public readonly PbfSolver Solver;
        public StepInput Input;

        /// <param name="maxBinding">Bytes of the largest buffer; 0: the device's.</param>
        public TestFluid(float3 box, float spacing, int capacity, SolverSettings settings, long maxBinding = 0)
        {
            Input = SolverStages.Still(settings, FluidMaterial.Water);
            Input.gravity = new float3(0f, -9.81f, 0f);
            Solver = new PbfSolver(new SolverLayout(box, spacing, capacity, settings.neighborCapacity, settings.listMargin,
                maxBinding > 0 ? maxBinding : GpuBuffer.MaxBinding));
        }

        public TestFluid(float3 box, float spacing, int capacity) : this(box, spacing, capacity, SolverSettings.Default) { }

        public float Spacing => Solver.Layout.Spacing;

        /// <summary>Particles given to the solver.</summary>
        public int Added { get; private set; }

        /// <summary>Adds a block of still or moving particles on a lattice, its lowest corner at <paramref name="corner"/>.</summary>
        public TestFluid AddBlock(float3 corner, float3 size, float3 velocity = default, float jitter = 0.02f)
        {
            int3 counts = (int3)math.floor(size / Spacing + 1e-3f);
            ParticleState block = ParticleState.Lattice(0f, 0.5f, counts, jitter);
            return Add(block.positions.Select(p => corner + p.xyz * Spacing).ToArray(), velocity);
        }

        /// <summary>Adds a block on a lattice but for what would lie in or too near to a shape. Lengths in d.</summary>
        public TestFluid AddAround(ColliderMotion shape, float3 corner, float3 size)
        {
            ParticleState block = ParticleState.Lattice(0f, 0.5f, (int3)size, 0.02f);
            return Add(block.positions.Select(p => corner + p.xyz).Where(p => Reference.Shapes.Distance(shape, p) >= 0.5)
                .Select(p => p * Spacing).ToArray());
        }

        public TestFluid Add(float3[] positions, float3 velocity = default) => Add(positions, _ => velocity);

        public TestFluid Add(float3[] positions, Func<float3, float3> velocityAt) => Add(positions, positions.Select(velocityAt).ToArray());

        public TestFluid Add(float3[] points, float3[] speeds)
        {
            using (var positions = new NativeArray<float4>(points.Select(p => new float4(p, 0f)).ToArray(), Allocator.Persistent))
            using (var velocities = new NativeArray<float4>(speeds.Select(v => new float4(v, 0f)).ToArray(), Allocator.Persistent))
                Solver.Add(positions, velocities);
            Added += points.Length;
            return this;
        }

        /// <summary>Adds still particles of a phase. Positions in d.</summary>
        public TestFluid AddPhase(int phase, IEnumerable<float3> points)
        {
            using (var positions = new NativeArray<float4>(points.Select(p => new float4(p, 0f)).ToArray(), Allocator.Persistent))
            using (var velocity = new NativeArray<float4>(1, Allocator.Persistent))
                Solver.AddInSpacings(positions, velocity, 0f, Solver.Layout.DomainSize, Solver.TagFor(phase, 0));
            return this;
        }

        /// <summary>Phases of the particles, in the order of the buffers.</summary>
        public uint[] Phases() => GpuTest.Read<uint>(Solver.Tags, Alive).Select(tag => tag >> ParticleTags.PhaseShift).ToArray();

        public TestFluid Step(int count = 1)
        {
            for (int i = 0; i < count; i++)
                GpuTest.Run(cmd => Solver.Step(cmd, Input));
            return this;
        }

        public int Alive => (int)Counter(ParticleCounter.Alive);

        public uint Counter(ParticleCounter counter) => GpuTest.Read<uint>(Solver.Counters, ParticleBuffers.CounterCount)[(int)counter];

        /// <summary>In the order of the buffers, d.</summary>
        public ParticleState Read() => Read(Solver);

        /// <summary>The particles of a solver in the order of its buffers, d.</summary>
        public static ParticleState Read(PbfSolver solver)
        {
            int count = (int)GpuTest.Read<uint>(solver.Counters, ParticleBuffers.CounterCount)[(int)ParticleCounter.Alive];
            return new ParticleState(solver.Layout.DomainSize, new float3[0])
            {
                positions = GpuTest.Read<float4>(solver.Positions, count),
                velocities = GpuTest.Read<float4>(solver.Velocities, count),
                ids = GpuTest.Read<uint>(solver.ParticleIds, count),
            };
        }

        /// <summary>Statistics of the current state, waiting for the device.</summary>
        public FluidStatistics Measure()
        {
            GpuTest.Run(cmd => Solver.RecordStatistics(cmd, Input));
            Solver.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            if (!Solver.TryGetStatistics(Input, out FluidStatistics statistics))
                throw new InvalidOperationException("The statistics did not arrive with WaitAllRequests.");
            return statistics;
        }

        /// <summary>Statistics of the current state; fails unless every particle is alive, refused or culled, and those alive are inside
        /// with a velocity.</summary>
        public FluidStatistics MeasureWhole()
        {
            FluidStatistics statistics = Measure();
            ParticleState state = Read();
            Assert.That(state.Count + statistics.refused + statistics.nonFinite, Is.EqualTo(Added), "particles alive, refused and culled");
            Assert.That(state.ids.Distinct().Count(), Is.EqualTo(state.Count), "different ids");
            Assert.That(statistics.escaped, Is.Zero, "escaped");
            for (int i = 0; i < state.Count; i++)
                if (!math.all(state.positions[i].xyz >= 0.5f) || !math.all(state.positions[i].xyz <= state.box - 0.5f)
                    || !math.all(math.isfinite(state.velocities[i])))
                    Assert.Fail($"particle {state.ids[i]} is at {state.positions[i].xyz} with velocity {state.velocities[i].xyz} in a " +
                        $"box of {state.box}");
            return statistics;
        }

        public void Dispose() => Solver.Dispose();

        /// <summary>Fails unless both hold the same particles in the same order, bit for bit.</summary>
        public static void AssertSame(ParticleState actual, ParticleState expected)
        {
            Compare.Same("ids", actual.ids, expected.ids);
            Compare.Same("positions", actual.positions, expected.positions);
            Compare.Same("velocities", actual.velocities, expected.velocities);
        }
    }
}
