using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>A 3 x 3 matrix in double precision, by rows.</summary>
    struct Tensor
    {
        public double3 x, y, z;

        public Tensor(double3 x, double3 y, double3 z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public static readonly Tensor Identity = new Tensor(new double3(1.0, 0.0, 0.0), new double3(0.0, 1.0, 0.0), new double3(0.0, 0.0, 1.0));

        public static Tensor Symmetric(double3 diagonal, double3 others)
        {
            return new Tensor(new double3(diagonal.x, others.z, others.y), new double3(others.z, diagonal.y, others.x),
                new double3(others.y, others.x, diagonal.z));
        }

        public static Tensor Outer(double3 a, double3 b) => new Tensor(a.x * b, a.y * b, a.z * b);

        /// <summary>A turn about z.</summary>
        public static Tensor Turn(double angle)
        {
            return new Tensor(new double3(Math.Cos(angle), -Math.Sin(angle), 0.0), new double3(Math.Sin(angle), Math.Cos(angle), 0.0),
                new double3(0.0, 0.0, 1.0));
        }

        public static Tensor operator +(Tensor a, Tensor b) => new Tensor(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Tensor operator -(Tensor a, Tensor b) => new Tensor(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Tensor operator *(double s, Tensor a) => new Tensor(s * a.x, s * a.y, s * a.z);
        public static double3 operator *(Tensor a, double3 v) => new double3(math.dot(a.x, v), math.dot(a.y, v), math.dot(a.z, v));

        public static Tensor operator *(Tensor a, Tensor b)
        {
            Tensor columns = b.Transposed;
            return new Tensor(columns * a.x, columns * a.y, columns * a.z);
        }

        public Tensor Transposed => new Tensor(new double3(x.x, y.x, z.x), new double3(x.y, y.y, z.y), new double3(x.z, y.z, z.z));

        public double Trace => x.x + y.y + z.z;
        public double Determinant => math.dot(x, math.cross(y, z));
        public double Length => Math.Sqrt(math.dot(x, x) + math.dot(y, y) + math.dot(z, z));

        public Tensor Inverse => 1.0 / Determinant * new Tensor(math.cross(y, z), math.cross(z, x), math.cross(x, y)).Transposed;

        /// <summary>Whether all eigenvalues of a symmetric matrix are above 0: its leading minors are.</summary>
        public bool IsPositive => x.x > 0.0 && x.x * y.y - x.y * y.x > 0.0 && Determinant > 0.0;

        public override string ToString() => $"({x}, {y}, {z})";
    }

    /// <summary>Viscoelasticity.compute pair by pair in double precision, without its limits but for that of the moments. Lengths in d.</summary>
    sealed class Elasticity
    {
        readonly double3[] starts, ends;
        readonly int[][] neighbors;
        readonly Tensor[] inverseMoments;

        public Elasticity(double3[] starts, double3[] ends, int[][] neighbors)
        {
            this.starts = starts;
            this.ends = ends;
            this.neighbors = neighbors;
            inverseMoments = new Tensor[ends.Length];
            for (int i = 0; i < ends.Length; i++)
            {
                var moments = new Tensor();
                foreach (int j in neighbors[i])
                    moments += Weight(i, j) * Tensor.Outer(ends[i] - ends[j], ends[i] - ends[j]);
                double least = moments.Trace > 0.0 ? 4.0 * moments.Determinant / (moments.Trace * moments.Trace) : 0.0;
                inverseMoments[i] = (moments + Math.Max(1.0 - least, 0.0) * Tensor.Identity).Inverse;
            }
        }

        /// <summary>Displacement gradient by the place at the end.</summary>
        public Tensor Gradient(int i)
        {
            var flow = new Tensor();
            foreach (int j in neighbors[i])
                flow += Weight(i, j) * Tensor.Outer(ends[i] - starts[i] - (ends[j] - starts[j]), ends[i] - ends[j]);
            return flow * inverseMoments[i];
        }

        /// <summary>B − I after the substep.</summary>
        /// <param name="before">B − I before it.</param>
        /// <param name="relaxing">exp(−Δt / 2τ).</param>
        public Tensor Deformed(int i, Tensor before, double relaxing)
        {
            Tensor f = (Tensor.Identity - Gradient(i)).Inverse;
            return relaxing * (f * (Tensor.Identity + relaxing * before) * f.Transposed - Tensor.Identity);
        }

        /// <summary>The largest stiffness at which that of particle i is not limited.</summary>
        public double MaxStiffness(int i, Tensor after)
        {
            double weights = 0.0;
            foreach (int j in neighbors[i])
                weights += Weight(i, j);
            return 1.0 / (2.0 * inverseMoments[i].Length * Math.Max(weights, 1.0) * (1.0 + Math.Max(after.Trace, 0.0)));
        }

        /// <summary>T of the particle for a stiffness G Δt² / (ρ d²).</summary>
        public Tensor Stress(int i, Tensor after, double stiffness)
        {
            Tensor f = (Tensor.Identity - Gradient(i)).Inverse;
            return Math.Min(stiffness, MaxStiffness(i, after)) * (after + f * f.Transposed - Tensor.Identity) * inverseMoments[i];
        }

        /// <summary>Change of the displacement of a substep, d.</summary>
        public VectorSum Change(int i, Tensor[] stresses)
        {
            var change = new VectorSum();
            foreach (int j in neighbors[i])
                change.Add(Weight(i, j) * ((stresses[i] + stresses[j]) * (ends[j] - ends[i])));
            return change;
        }

        double Weight(int i, int j)
        {
            double missing = Math.Max(Kernels.H * Kernels.H - math.lengthsq(ends[i] - ends[j]), 0.0);
            return missing * missing;
        }
    }
}
