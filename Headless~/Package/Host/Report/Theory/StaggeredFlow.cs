using System;

namespace Host.Report
{
    /// <summary>Velocities of an inviscid flow with a free surface on the faces of square cells, in a box without friction.</summary>
    sealed class StaggeredFlow
    {
        const int SolverSteps = 600, ExtendLayers = 4;
        const double Tolerance = 1e-4, NearestSurface = 0.1;

        public readonly int Columns, Rows;
        readonly double cell;
        readonly double[] pressure, distance;   // distance to the water's surface, negative within
        readonly bool[] water;
        readonly Faces horizontal, vertical;

        public StaggeredFlow(int columns, int rows, double cell)
        {
            (Columns, Rows, this.cell) = (columns, rows, cell);
            pressure = new double[columns * rows];
            distance = new double[columns * rows];
            water = new bool[columns * rows];
            horizontal = new Faces(columns + 1, rows, 0, 0.5);
            vertical = new Faces(columns, rows + 1, 0.5, 0);
        }

        public void Clear()
        {
            horizontal.Clear();
            vertical.Clear();
            Array.Clear(water);
            Array.Fill(distance, 3 * cell);
        }

        /// <param name="radius">Of the disc of water that a particle stands for.</param>
        public void Add(double x, double y, double u, double v, double radius)
        {
            horizontal.Add(x / cell, y / cell, u);
            vertical.Add(x / cell, y / cell, v);
            int column = (int)(x / cell), row = (int)(y / cell);
            water[row * Columns + column] = true;
            for (int j = Math.Max(row - 2, 0); j <= Math.Min(row + 2, Rows - 1); j++)
                for (int i = Math.Max(column - 2, 0); i <= Math.Min(column + 2, Columns - 1); i++)
                {
                    double dx = (i + 0.5) * cell - x, dy = (j + 0.5) * cell - y;
                    ref double nearest = ref distance[j * Columns + i];
                    nearest = Math.Min(nearest, Math.Sqrt(dx * dx + dy * dy) - radius);
                }
        }

        /// <summary>From the velocities that were added to those a step later, without divergence.</summary>
        public void Project(double step, double gravity)
        {
            horizontal.Average();
            vertical.Average();
            for (int k = 0; k < vertical.Values.Length; k++)
                if (vertical.Known[k])
                    vertical.Values[k] -= gravity * step;
            StopAtWalls();
            Solve(step);
            horizontal.Subtract(step / cell, Gradient);
            vertical.Subtract(step / cell, Gradient);
            horizontal.Extend(ExtendLayers);
            vertical.Extend(ExtendLayers);
            StopAtWalls();
        }

        /// <summary>Velocity at a place and its change by the last projection.</summary>
        public (double U, double V, double DU, double DV) At(double x, double y) =>
            (horizontal.At(horizontal.Values, x / cell, y / cell), vertical.At(vertical.Values, x / cell, y / cell),
            horizontal.At(horizontal.Changes, x / cell, y / cell), vertical.At(vertical.Changes, x / cell, y / cell));

        void StopAtWalls()
        {
            for (int j = 0; j < Rows; j++)
                horizontal.Values[j * (Columns + 1)] = horizontal.Values[j * (Columns + 1) + Columns] = 0;
            for (int i = 0; i < Columns; i++)
                vertical.Values[i] = vertical.Values[Rows * Columns + i] = 0;
        }

        // Pressure difference over the face left of or below a cell, towards the surface by its distance; none between two cells of air.
        double? Gradient(int face, int width)
        {
            bool sideways = width == Columns + 1;
            int i = face % width, j = face / width;
            if (sideways ? i == 0 || i == Columns : j == 0 || j == Rows)
                return 0;
            int next = j * Columns + i, before = next - (sideways ? 1 : Columns);
            if (!water[next] && !water[before])
                return null;
            return (pressure[next] - pressure[before]) * (water[next] == water[before] ? 1 : water[next] ? Weight(next, before)
                : Weight(before, next));
        }

        double Weight(int wet, int dry)
        {
            double inside = Math.Min(distance[wet], -1e-6 * cell), outside = Math.Max(distance[dry], 0);
            return 1 / Math.Max(inside / (inside - outside), NearestSurface);
        }

        // Conjugate gradients with the diagonal as preconditioner, from the last pressure.
        void Solve(double step)
        {
            int n = pressure.Length;
            double[] diagonal = new double[n], residual = new double[n], z = new double[n], direction = new double[n], product = new double[n];
            double scale = 0, rz = 0;
            for (int k = 0; k < n; k++)
            {
                if (!water[k])
                {
                    pressure[k] = 0;
                    continue;
                }
                int i = k % Columns, j = k / Columns;
                foreach ((bool inside, int other) in Around(i, j, k))
                    diagonal[k] += !inside ? 0 : water[other] ? 1 : Weight(k, other);
                residual[k] = -(horizontal.Values[j * (Columns + 1) + i + 1] - horizontal.Values[j * (Columns + 1) + i]
                    + vertical.Values[k + Columns] - vertical.Values[k]) * cell / step;
                scale = Math.Max(scale, Math.Abs(residual[k]));
            }
            Multiply(diagonal, pressure, product);
            for (int k = 0; k < n; k++)
            {
                residual[k] -= product[k];
                direction[k] = z[k] = water[k] ? residual[k] / diagonal[k] : 0;
                rz += residual[k] * z[k];
            }
            for (int iteration = 0; iteration < SolverSteps; iteration++)
            {
                Multiply(diagonal, direction, product);
                double along = 0, next = 0, largest = 0;
                for (int k = 0; k < n; k++)
                    along += direction[k] * product[k];
                if (along <= 0)
                    return;
                for (int k = 0; k < n; k++)
                {
                    if (!water[k])
                        continue;
                    pressure[k] += rz / along * direction[k];
                    residual[k] -= rz / along * product[k];
                    z[k] = residual[k] / diagonal[k];
                    next += residual[k] * z[k];
                    largest = Math.Max(largest, Math.Abs(residual[k]));
                }
                if (largest < Tolerance * scale)
                    return;
                for (int k = 0; k < n; k++)
                    direction[k] = z[k] + next / rz * direction[k];
                rz = next;
            }
            throw new HostException($"The reference's pressure did not converge in {SolverSteps} steps.");
        }

        void Multiply(double[] diagonal, double[] x, double[] y)
        {
            for (int k = 0; k < x.Length; k++)
            {
                y[k] = 0;
                if (!water[k])
                    continue;
                int i = k % Columns, j = k / Columns;
                double sum = diagonal[k] * x[k];
                if (i > 0) sum -= x[k - 1];
                if (i < Columns - 1) sum -= x[k + 1];
                if (j > 0) sum -= x[k - Columns];
                if (j < Rows - 1) sum -= x[k + Columns];
                y[k] = sum;
            }
        }

        (bool, int)[] Around(int i, int j, int k)
            => new[] { (i > 0, k - 1), (i < Columns - 1, k + 1), (j > 0, k - Columns), (j < Rows - 1, k + Columns) };
    }
}
