using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>The stages of a solver one by one over the same particles, each run at once, so that a test sees what it left.</summary>
    sealed class SolverStages : IDisposable
    {
        /// <summary>m; a power of two, so that the way to meters and back rounds nothing.</summary>
        public const float Spacing = 0.0625f;

        public readonly SolverLayout Layout;
        public readonly ParticleBuffers Particles;
        public readonly NeighborSearch Search;
        public readonly DensityConstraint Constraint;
        public readonly VelocityUpdate VelocityUpdate = new VelocityUpdate();
        public readonly GraphicsBuffer Constants;
        public readonly StepInput Input;

        /// <param name="capacity">0: as many as there are, and some.</param>
        /// <param name="maxBinding">Bytes of the largest buffer; 0: the device's.</param>
        public SolverStages(ParticleState state, StepInput input, int capacity = 0, long maxBinding = 0)
        {
            Input = input;
            capacity = capacity > 0 ? capacity : state.Count + 5;
            Layout = new SolverLayout(state.box * Spacing, Spacing, capacity, input.settings.neighborCapacity, input.settings.listMargin,
                maxBinding > 0 ? maxBinding : GpuBuffer.MaxBinding);
            Particles = new ParticleBuffers(capacity);
            Search = new NeighborSearch(Layout);
            Constraint = new DensityConstraint(Layout);
            Constants = GpuTest.UploadConstants(SolverConstants.For(Layout, input, 1));
            state.WriteTo(Particles);
        }

        /// <summary>No gravity, 60 steps a second, settings and material as given.</summary>
        public static StepInput Still(SolverSettings settings, FluidMaterial material)
        {
            return new StepInput { timeStep = 1f / 60f, settings = settings, material = material };
        }

        public static StepInput Still() => Still(Roomy, FluidMaterial.Water);

        /// <summary>Default settings with lists that hold what random places bring.</summary>
        public static SolverSettings Roomy
        {
            get
            {
                SolverSettings settings = SolverSettings.Default;
                settings.neighborCapacity = 96;
                return settings;
            }
        }

        public int Sorted => (int)Counter(ParticleCounter.Sorted);

        /// <summary>Sorted positions at the start of the step.</summary>
        public float4[] Start => GpuTest.Read<float4>(Particles.Start, Sorted);
        /// <summary>Sorted positions, predicted and then corrected.</summary>
        public float4[] Predicted => GpuTest.Read<float4>(Particles.Predicted, Sorted);
        /// <summary>After the constraint: the positions that its last multipliers were solved at, and w those.</summary>
        public float4[] Multipliers => GpuTest.Read<float4>(Particles.Multipliers, Sorted);
        public float4[] Velocities => GpuTest.Read<float4>(Particles.Velocities, Sorted);
        public uint[] SortedIds => GpuTest.Read<uint>(Particles.SortedIds, Sorted);

        public uint Counter(ParticleCounter counter) => GpuTest.Read<uint>(Particles.Counters, ParticleBuffers.CounterCount)[(int)counter];

        /// <summary>Context for a stage that is run alone.</summary>
        public StepContext Context(CommandBuffer cmd) => Context(cmd, Input);

        public StepContext Context(CommandBuffer cmd, in StepInput input, CoarseCorrection coarse = null)
            => new StepContext(cmd, Constants, Particles, Search, Constraint.Lists, Layout, input, coarse);

        public SolverStages Sort()
        {
            GpuTest.Run(cmd => Search.RecordSort(Context(cmd), takesProjection: false));
            return this;
        }

        /// <param name="iterations">0: the list and the first multipliers only.</param>
        /// <param name="coarse">Adds its density correction; null for none.</param>
        public SolverStages Constrain(int iterations, CoarseCorrection coarse = null)
        {
            StepInput input = Input;
            input.settings.iterations = iterations;
            GpuTest.Run(cmd => Constraint.Record(Context(cmd, input, coarse)));
            return this;
        }

        public SolverStages UpdateVelocities()
        {
            GpuTest.Run(cmd => VelocityUpdate.Record(Context(cmd)));
            return this;
        }

        /// <summary>The neighbors that the constraint listed for each sorted particle; layout as in NeighborList.hlsl.</summary>
        public int[][] ListedNeighbors()
        {
            int sorted = Sorted, capacity = Layout.NeighborCapacity;
            uint[] counts = GpuTest.Read<uint>(Constraint.Lists.Counts, sorted);
            uint4[] first = GpuTest.Read<uint4>(Constraint.Lists.First, (int)Layout.FirstListEntries / NeighborLists.BlockEntries);
            uint4[] second = Layout.TwoLists ? GpuTest.Read<uint4>(Constraint.Lists.Second,
                (int)Layout.SecondListEntries / NeighborLists.BlockEntries) : null;
            var lists = new int[sorted][];
            for (int i = 0; i < sorted; i++)
            {
                bool inFirst = i < Layout.FirstListParticles;
                int index = inFirst ? i : i - Layout.FirstListParticles;
                lists[i] = new int[counts[i]];
                for (int k = 0; k < lists[i].Length; k++)
                    lists[i][k] = (int)(inFirst ? first : second)[index / 32 * 32 * (capacity / 4) + k / 4 * 32 + index % 32][k % 4];
            }
            return lists;
        }

        public void Dispose()
        {
            Particles.Dispose();
            Search.Dispose();
            Constraint.Dispose();
            Constants.Release();
        }
    }
}
