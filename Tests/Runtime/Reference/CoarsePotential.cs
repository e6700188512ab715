using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>(−∇² + 1/ℓ²) φ = source, or (−∇·1/ρ ∇ + 1/ℓ²) φ = source, with φ ≥ 0 on the active cells, 0 elsewhere; in
    /// double precision.</summary>
    sealed class CoarsePotential
    {
        readonly CoarseCells cells;
        readonly double[] source, diagonal;
        readonly double[] densities;
        readonly double3 coupling;

        /// <param name="densities">ρ of each cell; null for 1 everywhere.</param>
        public CoarsePotential(CoarseCells cells, double[] source, double[] diagonal, double[] densities = null)
        {
            this.densities = densities;
            this.cells = cells;
            this.source = source;
            this.diagonal = diagonal;
            coupling = 1.0 / (cells.size * cells.size);
        }

        /// <summary>Projected Gauss-Seidel, over-relaxed, until nothing changes by more than a fraction of the largest value.</summary>
        public double[] Solve(double relaxation, double fraction = 1e-9)
        {
            var potential = new double[cells.Total];
            for (int sweep = 0; sweep < 20000; sweep++)
            {
                double changed = 0.0, largest = 0.0;
                for (int cell = 0; cell < cells.Total; cell++)
                {
                    if (!cells.active[cell])
                        continue;
                    double before = potential[cell];
                    double solved = (source[cell] + Sum(cell, potential)) / diagonal[cell];
                    potential[cell] = Math.Max(before + relaxation * (solved - before), 0.0);
                    changed = Math.Max(changed, Math.Abs(potential[cell] - before));
                    largest = Math.Max(largest, potential[cell]);
                }
                if (changed <= fraction * largest)
                    return potential;
            }
            throw new InvalidOperationException("The reference did not converge.");
        }

        /// <summary>Rms of what each active cell lacks of its own equation, or of φ ≥ 0 where that binds: 0 at the solution.</summary>
        public double Residual(double[] potential)
        {
            double sum = 0.0;
            int number = 0;
            for (int cell = 0; cell < cells.Total; cell++)
            {
                if (!cells.active[cell])
                    continue;
                double residual = source[cell] + Sum(cell, potential) - diagonal[cell] * potential[cell];
                double lacking = Math.Max(residual, -diagonal[cell] * potential[cell]);
                sum += lacking * lacking;
                number++;
            }
            return Math.Sqrt(sum / Math.Max(number, 1));
        }

        // Sums what the cells beside one contribute.
        double Sum(int cell, double[] potential)
        {
            int3 counts = cells.counts;
            int x = cell % counts.x, y = cell / counts.x % counts.y, z = cell / (counts.x * counts.y);
            int strideY = counts.x, strideZ = counts.x * counts.y;
            double sum = 0.0;
            if (x > 0)
                sum += Coupling(cell, cell - 1, coupling.x) * potential[cell - 1];
            if (x < counts.x - 1)
                sum += Coupling(cell, cell + 1, coupling.x) * potential[cell + 1];
            if (y > 0)
                sum += Coupling(cell, cell - strideY, coupling.y) * potential[cell - strideY];
            if (y < counts.y - 1)
                sum += Coupling(cell, cell + strideY, coupling.y) * potential[cell + strideY];
            if (z > 0)
                sum += Coupling(cell, cell - strideZ, coupling.z) * potential[cell - strideZ];
            if (z < counts.z - 1)
                sum += Coupling(cell, cell + strideZ, coupling.z) * potential[cell + strideZ];
            return sum;
        }

        // A face has the mean density of its two cells.
        double Coupling(int cell, int other, double coupling)
            => densities == null ? coupling : coupling * 2.0 / (densities[cell] + densities[other]);
    }
}
