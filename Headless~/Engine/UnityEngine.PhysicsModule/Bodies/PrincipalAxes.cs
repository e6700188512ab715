using System;

namespace UnityEngine.Headless
{
    /// <summary>Eigenvalues and axes of a symmetric matrix by Jacobi's rotations (Golub and Van Loan, Matrix Computations, 8.5).</summary>
    internal static class PrincipalAxes
    {
        const int Sweeps = 16;
        const double Small = 1e-6;      // of the largest element: an axis-aligned body keeps its axes

        public static void Find(float[,] matrix, out Vector3 values, out Quaternion axes)
        {
            var a = new double[3, 3];
            var v = new double[3, 3];
            double largest = 0.0;
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                {
                    a[i, j] = matrix[i, j];
                    v[i, j] = i == j ? 1.0 : 0.0;
                    largest = Math.Max(largest, Math.Abs(a[i, j]));
                }
            for (int sweep = 0; sweep < Sweeps; sweep++)
                for (int p = 0; p < 2; p++)
                    for (int q = p + 1; q < 3; q++)
                        if (Math.Abs(a[p, q]) > Small * largest)
                            Rotate(a, v, p, q);
            values = new Vector3((float)a[0, 0], (float)a[1, 1], (float)a[2, 2]);
            axes = Turn(v);
        }

        static void Rotate(double[,] a, double[,] v, int p, int q)
        {
            double tau = (a[q, q] - a[p, p]) / (2.0 * a[p, q]);
            double t = (tau >= 0.0 ? 1.0 : -1.0) / (Math.Abs(tau) + Math.Sqrt(1.0 + tau * tau)), c = 1.0 / Math.Sqrt(1.0 + t * t), s = t * c;
            for (int k = 0; k < 3; k++)
                (a[k, p], a[k, q]) = (c * a[k, p] - s * a[k, q], s * a[k, p] + c * a[k, q]);
            for (int k = 0; k < 3; k++)
                (a[p, k], a[q, k]) = (c * a[p, k] - s * a[q, k], s * a[p, k] + c * a[q, k]);
            for (int k = 0; k < 3; k++)
                (v[k, p], v[k, q]) = (c * v[k, p] - s * v[k, q], s * v[k, p] + c * v[k, q]);
        }

        // Rotations leave the columns a rotation themselves.
        static Quaternion Turn(double[,] v)
        {
            if (v[0, 0] == 1.0 && v[1, 1] == 1.0)
                return Quaternion.identity;
            return Quaternion.LookRotation(new Vector3((float)v[0, 2], (float)v[1, 2], (float)v[2, 2]),
                new Vector3((float)v[0, 1], (float)v[1, 1], (float)v[2, 1]));
        }
    }
}
