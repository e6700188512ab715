using System;
using System.Linq;
using Host.Studies.Methods;
using Rill;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>The density constraint particle after particle, away from the walls and without pairs of 0.25 d: the slow twin of the
    /// study's kernels.</summary>
    sealed class SerialConstraint
    {
        readonly SolverLayout layout;
        readonly SolverConstants c;
        readonly int[][] neighbors;
        readonly int[] cells;
        readonly int3[] blocks;

        /// <param name="start">d, by the particles' numbers; the lists are made here.</param>
        public SerialConstraint(float3[] start, SolverLayout layout, in StepInput input)
        {
            this.layout = layout;
            c = SolverConstants.For(layout, input, 1);
            neighbors = start.Select((a, i) => Enumerable.Range(0, start.Length)
                .Where(j => j != i && math.distancesq(a, start[j]) < c.listRadiusSquared).ToArray()).ToArray();
            cells = start.Select(Cell).ToArray();
            blocks = start.Select(p => Block(p, layout)).ToArray();
        }

        /// <summary>All particles at once.</summary>
        public float3[] Jacobi(float3[] p)
        {
            double[] multipliers = p.Select((_, i) => Multiplier(i, p, out double3 unused)).ToArray();
            return p.Select((a, i) => a + Limited(c.relaxation * Sum(i, p, multipliers))).ToArray();
        }

        /// <summary>One particle after the other, color by color, in place.</summary>
        public float3[] Sweep(float3[] start, bool byConstraint, int stride)
        {
            float3[] p = start.ToArray();
            double[] multipliers = p.Select((_, i) => Multiplier(i, p, out double3 unused)).ToArray();
            foreach (int i in Enumerable.Range(0, p.Length).OrderBy(i => Color(blocks[i], stride)).ThenBy(i => cells[i]).ThenBy(i => i))
            {
                multipliers[i] = Multiplier(i, p, out double3 gradient);
                double3 own = byConstraint ? multipliers[i] * gradient : Sum(i, p, multipliers);
                if (byConstraint)
                    foreach (int j in neighbors[i])
                        p[j] += Limited(-c.relaxation * multipliers[i] * c.gradientScale * Spiky(p[i] - p[j]));
                p[i] += Limited(c.relaxation * own);
            }
            return p;
        }

        /// <summary>Of the coloring.</summary>
        public static int3 Block(float3 p, SolverLayout layout) => (int3)(p / layout.CellSize) / layout.CellsPerRadius;

        static int Color(int3 block, int stride) => block.x % stride + stride * (block.y % stride + stride * (block.z % stride));

        int Cell(float3 p)
        {
            var cell = (int3)(p / layout.CellSize);
            return (cell.z * layout.CellCounts.y + cell.y) * layout.CellCounts.x + cell.x;
        }

        double Multiplier(int i, float3[] p, out double3 gradient)
        {
            double density = 0, squares = 0;
            gradient = 0.0;
            foreach (int j in neighbors[i])
            {
                double3 pair = c.gradientScale * Spiky(p[i] - p[j]);
                density += Math.Pow(Math.Max(4.0 - math.lengthsq(p[i] - p[j]), 0.0), 3.0);
                gradient += pair;
                squares += math.dot(pair, pair);
            }
            double error = c.densityScale * density + c.selfDensity - 1.0;
            return -Math.Max(error, 0.0) / (squares + math.dot(gradient, gradient) + c.epsilon);
        }

        double3 Sum(int i, float3[] p, double[] multipliers) =>
            c.gradientScale * neighbors[i].Aggregate(new double3(0.0), (sum, j) => sum + (multipliers[i] + multipliers[j]) * Spiky(p[i] - p[j]));

        static double3 Spiky(double3 difference)
        {
            double r = math.length(difference);
            return difference * (Math.Pow(Math.Max(2.0 - r, 0.0), 2.0) / r);
        }

        float3 Limited(double3 correction) => (float3)(correction * Math.Min(1.0, c.maxCorrection / Math.Max(math.length(correction), 1e-30)));
    }
}
