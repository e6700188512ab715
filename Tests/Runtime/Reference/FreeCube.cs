using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>
    /// A viscous body in the shape of a cube without stress at its surface, by finite elements in double precision: steps of
    /// v' − s (∇²v' + 2 ∇∇·v') = v, which is what the pairs' forces of ImplicitViscosity.compute are where the fluid is even. Knows nothing
    /// of particles. One eighth of the cube is solved, of flow that turns about z and is its own mirror image. Lengths in d.
    /// </summary>
    sealed class FreeCube
    {
        readonly int elements;
        readonly double[] start;
        readonly bool[] held;
        readonly double[,] mass = new double[8, 8], stiffness = new double[24, 24];

        /// <param name="side">Of the cube.</param>
        /// <param name="elements">Along half of the side.</param>
        /// <param name="velocity">At a place from the center: x odd in y, y odd in x, z odd in all three.</param>
        public FreeCube(double side, int elements, Func<double3, double3> velocity)
        {
            this.elements = elements;
            double size = 0.5 * side / elements;
            AddElement(size);
            int nodes = (elements + 1) * (elements + 1) * (elements + 1);
            start = new double[3 * nodes];
            held = new bool[3 * nodes];
            for (int x = 0; x <= elements; x++)
                for (int y = 0; y <= elements; y++)
                    for (int z = 0; z <= elements; z++)
                    {
                        int node = 3 * Node(x, y, z);
                        double3 v = velocity(size * new double3(x, y, z));
                        (start[node], start[node + 1], start[node + 2]) = (v.x, v.y, v.z);
                        held[node] = y == 0;
                        held[node + 1] = x == 0;
                        held[node + 2] = x == 0 || y == 0 || z == 0;
                    }
        }

        /// <summary>Returns the fraction of the flow along itself that steps leave.</summary>
        /// <param name="strength">s = ν Δt / d².</param>
        public double Left(double strength, int steps)
        {
            double[] velocity = (double[])start.Clone(), weighted = Apply(start, 0.0);
            double all = Dot(weighted, start);
            for (int step = 0; step < steps; step++)
                Solve(velocity, Apply(velocity, 0.0), strength);
            return Dot(weighted, velocity) / all;
        }

        // Conjugate gradients, from where the velocities are.
        void Solve(double[] velocity, double[] right, double strength)
        {
            double[] residual = Apply(velocity, strength);
            for (int i = 0; i < residual.Length; i++)
                residual[i] = right[i] - residual[i];
            double[] direction = (double[])residual.Clone();
            double squares = Dot(residual, residual), enough = 1e-12 * squares;
            for (int pass = 0; pass < 1000 && squares > enough; pass++)
            {
                double[] image = Apply(direction, strength);
                double step = squares / Dot(direction, image);
                for (int i = 0; i < residual.Length; i++)
                {
                    velocity[i] += step * direction[i];
                    residual[i] -= step * image[i];
                }
                double last = squares;
                squares = Dot(residual, residual);
                for (int i = 0; i < residual.Length; i++)
                    direction[i] = residual[i] + squares / last * direction[i];
            }
        }

        // Mass and strength times stiffness.
        double[] Apply(double[] velocity, double strength)
        {
            var image = new double[velocity.Length];
            var at = new int[8];
            for (int x = 0; x < elements; x++)
                for (int y = 0; y < elements; y++)
                    for (int z = 0; z < elements; z++)
                    {
                        for (int corner = 0; corner < 8; corner++)
                            at[corner] = 3 * Node(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
                        for (int a = 0; a < 24; a++)
                        {
                            double sum = 0.0;
                            for (int b = 0; b < 8; b++)
                                sum += mass[a / 3, b] * velocity[at[b] + a % 3];
                            if (strength > 0.0)
                                for (int b = 0; b < 24; b++)
                                    sum += strength * stiffness[a, b] * velocity[at[b / 3] + b % 3];
                            image[at[a / 3] + a % 3] += sum;
                        }
                    }
            for (int i = 0; i < image.Length; i++)
                if (held[i])
                    image[i] = 0.0;
            return image;
        }

        // Trilinear, two points of Gauss along each edge. Half of the mass in the corners: so waves are right to the fourth order.
        void AddElement(double size)
        {
            for (int point = 0; point < 8; point++)
            {
                double3 at = (2.0 * Corner(point) - 1.0) / Math.Sqrt(3.0);
                double weight = size * size * size / 8.0;
                var value = new double[8];
                var slope = new double3[8];
                for (int a = 0; a < 8; a++)
                {
                    double3 sign = 2.0 * Corner(a) - 1.0, factor = 0.5 * (1.0 + sign * at);
                    value[a] = factor.x * factor.y * factor.z;
                    slope[a] = sign / size * new double3(factor.y * factor.z, factor.z * factor.x, factor.x * factor.y);
                }
                for (int a = 0; a < 8; a++)
                {
                    mass[a, a] += 0.5 * weight / 8.0;
                    for (int b = 0; b < 8; b++)
                    {
                        mass[a, b] += 0.5 * weight * value[a] * value[b];
                        for (int k = 0; k < 3; k++)
                            for (int l = 0; l < 3; l++)
                                stiffness[3 * a + k, 3 * b + l] += weight
                                    * ((k == l ? math.dot(slope[a], slope[b]) : 0.0) + slope[a][l] * slope[b][k]
                                    + slope[a][k] * slope[b][l]);
                    }
                }
            }
        }

        static double3 Corner(int corner) => new double3(corner & 1, corner >> 1 & 1, corner >> 2);

        int Node(int x, int y, int z) => (x * (elements + 1) + y) * (elements + 1) + z;

        static double Dot(double[] a, double[] b)
        {
            double sum = 0.0;
            for (int i = 0; i < a.Length; i++)
                sum += a[i] * b[i];
            return sum;
        }
    }
}
