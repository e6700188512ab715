using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Potential that a coarse grid takes from that of a connected fluid.</summary>
    public class NeighborPotentialTests
    {
        static readonly float3 Box = new float3(40f, 16f, 13f), OtherBox = new float3(48f, 16f, 13f);

        // Offsets of the neighbor by whole cells, by fractions of one, and along two axes, d; its cells may be larger.
        [TestCase(28f, 0f, 4f)]
        [TestCase(29.3f, 0f, 4f)]
        [TestCase(-37.7f, 0f, 4f)]
        [TestCase(29.3f, 5.1f, 4f)]
        [TestCase(29.3f, 0f, 8f)]
        public void Beyond_its_side_of_the_overlap_it_is_the_neighbors_and_elsewhere_its_own(float x, float y, float otherCell)
        {
            float3 offset = new float3(x, y, 0f), slope = new float3(0.7f, -1.3f, 0.4f);
            float center = 0.5f * (math.max(x, 0f) + math.min(x + OtherBox.x, Box.x)), sign = x > 0f ? -1f : 1f;
            var region = new TransferRegion { offset = offset, plane = new float4(sign, 0f, 0f, sign * center) };
            const float Own = -5f, Scale = 0.25f;
            using (var taker = new CoarseCorrection(LayoutOf(Box), 4f))
            using (var other = new CoarseCorrection(LayoutOf(OtherBox), otherCell))
            {
                float3[] positions = Centers(taker.Grid), otherPoints = Centers(other.Grid);
                other.Cells.flowPotential.SetData(otherPoints.Select(p => 3f + math.dot(slope, p)).ToArray());
                taker.Cells.flowPotential.SetData(positions.Select(_ => Own).ToArray());
                ComputeShader shader = StageShader.LoadCompute("CoarseGrid");
                GpuTest.Run(cmd =>
                {
                    cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, taker.Constants, 0, taker.Constants.stride);
                    taker.RecordTake(cmd, region, other, other.Cells.flowPotential, taker.Cells.flowPotential, Scale);
                });
                float[] taken = GpuTest.Read<float>(taker.Cells.flowPotential, taker.Grid.Total);
                int count = 0;
                for (int cell = 0; cell < positions.Length; cell++)
                {
                    float3 q = positions[cell] - offset;
                    bool takes = sign * positions[cell].x < sign * center && math.all(q >= 0f) && math.all(q <= OtherBox);
                    float3 nearest = math.clamp(q, 0.5f * other.Grid.CellSize, OtherBox - 0.5f * other.Grid.CellSize);
                    float expected = takes ? Scale * (3f + math.dot(slope, nearest)) : Own;
                    Assert.That(taken[cell], Is.EqualTo(expected).Within(1e-4f), $"cell at {positions[cell]}");
                    count += takes ? 1 : 0;
                }
                Assert.That(count, Is.GreaterThan(0).And.LessThan(positions.Length / 2));
            }
        }

        static SolverLayout LayoutOf(float3 box) => new SolverLayout(box * SolverStages.Spacing, SolverStages.Spacing, 10, 96, 1f);

        // In the order of the cells, d.
        static float3[] Centers(CoarseGrid grid)
        {
            int3 counts = grid.Counts;
            return Enumerable.Range(0, grid.Total)
                .Select(cell => (new float3(cell % counts.x, cell / counts.x % counts.y, cell / (counts.x * counts.y)) + 0.5f) * grid.CellSize)
                .ToArray();
        }
    }
}
