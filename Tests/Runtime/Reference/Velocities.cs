using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>XSPH and vorticity confinement (Macklin and Müller 2013, eq. 15-17) in double precision.</summary>
    sealed class Velocities
    {
        readonly double3[] points, velocities;
        readonly int[][] neighbors;

        public Velocities(double3[] points, double3[] velocities, int[][] neighbors)
        {
            this.points = points;
            this.velocities = velocities;
            this.neighbors = neighbors;
        }

        /// <summary>Velocity after XSPH with coefficient c; eq. 17.</summary>
        public double3 Smoothed(int i, double c) => velocities[i] + c * Difference(i);

        /// <summary>Vorticity; eq. 15. The gradient is that by the neighbor.</summary>
        public VectorSum Curl(int i)
        {
            var curl = new VectorSum();
            foreach (int j in neighbors[i])
                curl.Add(math.cross(velocities[j] - velocities[i], -Gradient(i, j)));
            return curl;
        }

        /// <summary>Gradient of the vorticity's magnitude.</summary>
        public VectorSum Eta(int i, double[] magnitudes)
        {
            var eta = new VectorSum();
            foreach (int j in neighbors[i])
                eta.Add((magnitudes[j] - magnitudes[i]) * Gradient(i, j));
            return eta;
        }

        /// <summary>Velocity after confinement of the given strength (eq. 16) over a time step and XSPH, both from the old velocities.</summary>
        public double3 Confined(int i, double3[] curls, double[] magnitudes, double strength, double timeStep, double c)
        {
            double3 eta = Eta(i, magnitudes).value;
            double length = math.length(eta);
            double3 force = length > 1e-6 ? strength * math.cross(eta / length, curls[i]) : new double3(0.0);
            return velocities[i] + force * timeStep + c * Difference(i);
        }

        double3 Difference(int i)
        {
            double3 difference = new double3(0.0);
            foreach (int j in neighbors[i])
                difference += (velocities[j] - velocities[i]) * (Kernels.Poly6(math.distance(points[i], points[j])) / Kernels.RestDensity);
            return difference;
        }

        // Gradient of the spiky kernel by particle i's position, over the rest density.
        double3 Gradient(int i, int j) => Kernels.SpikyGradient(points[i] - points[j]) / Kernels.RestDensity;
    }
}
