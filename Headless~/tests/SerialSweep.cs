using System;
using System.Linq;
using Rill;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>One iteration of coloured Gauss-Seidel, particle after particle, away from the walls: the slow twin of GaussSeidel.compute.</summary>
    static class SerialSweep
    {
        /// <param name="positions">d, by the particles' numbers; they are at rest.</param>
        public static float3[] Of(float4[] positions, SolverLayout layout, in StepInput input, bool byConstraint, int stride)
        {
            SolverConstants c = SolverConstants.For(layout, input, 1);
            int side = Host.Report.Methods.GaussSeidel.BlockCells(layout);
            float3[] p = positions.Select(position => position.xyz).ToArray();
            int[][] neighbors = p.Select((a, i) => Enumerable.Range(0, p.Length).Where(j => j != i && math.distancesq(a, p[j]) < c.listRadiusSquared).ToArray()).ToArray();
            int[] order = Enumerable.Range(0, p.Length).OrderBy(i => Colour(Block(p[i], layout, side), stride)).ThenBy(i => Cell(p[i], layout)).ThenBy(i => i).ToArray();
            double[] multipliers = p.Select((_, i) => Multiplier(i, p, neighbors[i], c, out double3 unused)).ToArray();
            foreach (int i in order)
            {
                multipliers[i] = Multiplier(i, p, neighbors[i], c, out double3 gradient);
                double3 own = c.relaxation * multipliers[i] * gradient;
                if (byConstraint)
                    foreach (int j in neighbors[i])
                        p[j] += Limited(-c.relaxation * multipliers[i] * c.gradientScale * Spiky(p[i] - p[j]), c.maxCorrection);
                else
                    own = c.relaxation * c.gradientScale * neighbors[i].Aggregate(new double3(0.0), (sum, j) => sum + (multipliers[i] + multipliers[j]) * Spiky(p[i] - p[j]));
                p[i] += Limited(own, c.maxCorrection);
            }
            return p;
        }

        /// <summary>Of the colouring, so many grid cells wide.</summary>
        public static int3 Block(float3 p, SolverLayout layout, int side) => (int3)(p / layout.CellSize) / side;

        static int Colour(int3 block, int stride) => block.x % stride + stride * (block.y % stride + stride * (block.z % stride));

        static int Cell(float3 p, SolverLayout layout)
        {
            var cell = (int3)(p / layout.CellSize);
            return (cell.z * layout.CellCounts.y + cell.y) * layout.CellCounts.x + cell.x;
        }

        static double Multiplier(int i, float3[] p, int[] neighbors, SolverConstants c, out double3 gradient)
        {
            double density = 0, squares = 0;
            gradient = 0.0;
            foreach (int j in neighbors)
            {
                double3 pair = c.gradientScale * Spiky(p[i] - p[j]);
                density += Math.Pow(Math.Max(4.0 - math.lengthsq(p[i] - p[j]), 0.0), 3.0);
                gradient += pair;
                squares += math.dot(pair, pair);
            }
            double error = c.densityScale * density + c.selfDensity - 1.0;
            return -Math.Max(error, 0.0) / (squares + math.dot(gradient, gradient) + c.epsilon);
        }

        static double3 Spiky(double3 difference)
        {
            double r = math.length(difference);
            return difference * (Math.Pow(Math.Max(2.0 - r, 0.0), 2.0) / r);
        }

        static float3 Limited(double3 correction, double longest) => (float3)(correction * Math.Min(1.0, longest / Math.Max(math.length(correction), 1e-30)));
    }
}
