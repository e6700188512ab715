using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Smoke in a box without water, and its state. Coordinates in cells of 1 d, times in s.</summary>
    sealed class SmokeStage : IDisposable
    {
        public const float Spacing = 0.05f;

        public readonly TestFluid Fluid;
        public float[] Flow, Air;

        public SmokeStage(int3 counts, SmokeSettings settings)
        {
            Fluid = new TestFluid((float3)counts * Spacing, Spacing, 1000);
            Fluid.Input.settings.deepWater = DeepWater.Off;
            Fluid.Input.hasSmoke = true;
            Fluid.Input.smoke = settings;
            Fluid.Input.sources = new StepSources();
        }

        /// <summary>Still air that stays as it is but for what sources do, in a box with open sides.</summary>
        public static SmokeSettings Lasting(BoxWalls open) => new SmokeSettings { airTemperature = 20f, openSides = open };

        public Smoke Smoke => Fluid.Solver.Smoke;
        public int3 Counts => Smoke.Counts;
        public float StepTime => Fluid.Input.timeStep;

        public SmokeStage AddSource(float3 center, float radius, float heat, float density = 1f, float3 velocity = default)
        {
            Fluid.Input.sources.Add(new SmokeRegion { center = center, radius = radius, heat = heat, density = density, velocity = velocity });
            return this;
        }

        public SmokeStage Step(int count)
        {
            Fluid.Step(count);
            return Read();
        }

        public SmokeStage Read()
        {
            int3 nodes = Counts + 1;
            Flow = GpuTest.Read<float>(Smoke.Flow, 3 * nodes.x * nodes.y * nodes.z);
            Air = GpuTest.Read<float>(Smoke.Air, 2 * Cells);
            return this;
        }

        public int Cells => Counts.x * Counts.y * Counts.z;

        public int Cell(int x, int y, int z) => (z * Counts.y + y) * Counts.x + x;

        public int Face(int axis, int x, int y, int z)
        {
            int3 nodes = Counts + 1;
            return axis * nodes.x * nodes.y * nodes.z + (z * nodes.y + y) * nodes.x + x;
        }

        public float Heat(int x, int y, int z) => Air[Cell(x, y, z)];

        public float Density(int x, int y, int z) => Air[Cells + Cell(x, y, z)];

        /// <summary>Velocity along y at a cell's center, d/s.</summary>
        public float Rise(int x, int y, int z) => 0.5f * (Flow[Face(1, x, y, z)] + Flow[Face(1, x, y + 1, z)]);

        /// <summary>Divergence of the flow in a cell, 1/s.</summary>
        public float Divergence(int x, int y, int z)
        {
            float3 size = Smoke.CellSize;
            return (Flow[Face(0, x + 1, y, z)] - Flow[Face(0, x, y, z)]) / size.x + (Flow[Face(1, x, y + 1, z)] - Flow[Face(1, x, y, z)]) / size.y
                + (Flow[Face(2, x, y, z + 1)] - Flow[Face(2, x, y, z)]) / size.z;
        }

        public void ForEachCell(Action<int, int, int> visit)
        {
            for (int z = 0; z < Counts.z; z++)
                for (int y = 0; y < Counts.y; y++)
                    for (int x = 0; x < Counts.x; x++)
                        visit(x, y, z);
        }

        public void Dispose() => Fluid.Dispose();
    }
}
