using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>
    /// Results of SurfaceParticles.compute, in double precision and without its lists: the water's images in the walls are
    /// particles like the others here. Lengths in d.
    /// </summary>
    sealed class Surface
    {
        /// <summary>An ellipsoid: the sum of the outer products of its semi-axes, and where it lies.</summary>
        public struct Ellipsoid
        {
            public double3 center;
            public Tensor shape;
        }

        struct Plane
        {
            public double3 normal;
            public double depth, trust;
        }

        const int Passes = 3;
        const double Reach = 3.5;       // from a wall, of particles whose image can be a neighbor of a neighbor
        const double PlaneFraction = 0.95, Disc = 1.5, DiscHeight = 0.1, WallDisc = 1.3, DropRadius = 0.62, MinSemiAxis = 0.1;

        readonly double3 box;
        readonly double3[] points;          // the particles, then the images
        readonly double3[] sides;           // of each, 1 or -1 along an axis that is mirrored
        readonly int[] sources;             // particle of which it is, or is an image
        readonly int particles;
        readonly int[][] neighbors;
        readonly double[] weights, offsets;
        readonly double3[] directions;
        Plane[] planes;

        /// <param name="isDrawn">Decides for particles that lie too near a threshold for single precision.</param>
        public Surface(double3[] positions, double3 box, Func<int, bool> isDrawn)
        {
            this.box = box;
            particles = positions.Length;
            var all = new List<double3>(positions);
            var allSides = Enumerable.Repeat((double3)1.0, particles).ToList();
            var allSources = Enumerable.Range(0, particles).ToList();
            for (int image = 1; image < 27; image++)
            {
                var digits = new int3(image % 3, image / 3 % 3, image / 9);
                for (int i = 0; i < particles; i++)
                {
                    double3 p = positions[i], side = 1.0;
                    bool near = true;
                    for (int axis = 0; axis < 3; axis++)
                    {
                        if (digits[axis] == 0)
                            continue;
                        double wall = digits[axis] == 1 ? 0.0 : box[axis];
                        near &= Math.Abs(wall - p[axis]) < Reach;
                        p[axis] = 2.0 * wall - p[axis];
                        side[axis] = -1.0;
                    }
                    if (!near)
                        continue;
                    all.Add(p);
                    allSides.Add(side);
                    allSources.Add(i);
                }
            }
            points = all.ToArray();
            sides = allSides.ToArray();
            sources = allSources.ToArray();
            neighbors = Neighbors.ByCells(points, Kernels.H).Take(particles).ToArray();

            weights = new double[particles];
            offsets = new double[particles];
            directions = new double3[particles];
            IsDrawn = new bool[particles];
            planes = new Plane[particles];
            for (int i = 0; i < particles; i++)
                Estimate(i, isDrawn);
            for (int pass = 0; pass < Passes; pass++)
                planes = Enumerable.Range(0, particles).Select(i => planes[i].trust > 0.0 ? Mean(i, Flat, out _, out _) : planes[i]).ToArray();
        }

        /// <summary>Whether a particle belongs to the surface.</summary>
        public bool[] IsDrawn { get; }

        /// <summary>Sum of the weights around a particle, and the length of their mean vector.</summary>
        public (double weight, double offset) Sums(int i) => (weights[i], offsets[i]);

        /// <summary>All that is drawn for a particle: its own ellipsoid and discs on the walls.</summary>
        public List<Ellipsoid> Ellipsoids(int i)
        {
            var ellipsoids = new List<Ellipsoid>();
            if (IsDrawn[i])
                ellipsoids.Add(Shape(i));
            if (weights[i] > 6.0)
                for (int axis = 0; axis < 3; axis++)
                    for (int side = 0; side < 2; side++)
                        if ((side == 0 ? points[i][axis] : box[axis] - points[i][axis]) < 1.0)
                            ellipsoids.Add(DiscOnWall(i, axis, side));
            return ellipsoids;
        }

        static double Cubic(double r) => Math.Max(1.0 - Math.Pow(r / Kernels.H, 3.0), 0.0);

        static double Flat(double r) => Math.Max(1.0 - Math.Pow(r / Kernels.H, 6.0), 0.0);

        static double Step(double from, double to, double x)
        {
            double t = Math.Min(Math.Max((x - from) / (to - from), 0.0), 1.0);
            return t * t * (3.0 - 2.0 * t);
        }

        void Estimate(int i, Func<int, bool> isDrawn)
        {
            double weight = 1.0;
            double3 sum = 0.0;
            foreach (int j in neighbors[i])
            {
                double w = Cubic(math.distance(points[i], points[j]));
                weight += w;
                sum += w * (points[j] - points[i]);
            }
            double3 offset = sum / weight;
            weights[i] = weight;
            offsets[i] = math.length(offset);
            directions[i] = offsets[i] > 1e-6 ? -offset / offsets[i] : 0.0;
            IsDrawn[i] = Math.Abs(weight - 13.5) < 1e-4 || Math.Abs(offsets[i] - 0.14) < 1e-5 ? isDrawn(i) : weight < 13.5 || offsets[i] > 0.14;
            if (IsDrawn[i])
                planes[i] = First(i);
        }

        Plane First(int i)
        {
            return new Plane
            {
                normal = directions[i], depth = Math.Min(-0.065 - 1.08 * offsets[i] + 0.0873 * weights[i], 1.4),
                trust = Step(0.02, 0.1, offsets[i])
            };
        }

        // The mean of the planes around a particle, and how much they bend.
        Plane Mean(int i, Func<double, double> weightOf, out double curvature, out double weight)
        {
            Plane own = planes[i];
            double3 normal = own.trust * own.normal;
            double depth = own.trust * own.depth, bend = 0.0, bendWeight = 0.0;
            weight = own.trust;
            foreach (int j in neighbors[i])
            {
                Plane other = planes[sources[j]];
                if (other.trust <= 0.0)
                    continue;
                other.normal *= sides[j];
                double cosine = math.dot(other.normal, own.normal);
                double w = weightOf(math.distance(points[i], points[j])) * other.trust * Math.Min(Math.Max((cosine - 0.3) / 0.3, 0.0), 1.0);
                double3 piece = points[j] + other.normal * other.depth - points[i];
                normal += w * other.normal;
                depth += w * math.dot(PlaneFraction * other.normal + own.normal, piece) / (1.0 + PlaneFraction * cosine);
                weight += w;
                double3 along = piece - own.normal * own.depth;
                bend += w * math.dot(other.normal - own.normal, along);
                bendWeight += w * math.lengthsq(along);
            }
            curvature = bend / Math.Max(bendWeight, 1e-4);
            if (weight <= 1e-4)
                return own;
            return new Plane { normal = math.normalize(normal), depth = depth / weight, trust = own.trust };
        }

        Ellipsoid Shape(int i)
        {
            double weight = 1.0;
            double3 sum = 0.0;
            var moments = new Tensor();
            foreach (int j in neighbors[i].Where(j => j < particles))
            {
                double3 difference = points[j] - points[i];
                double w = Cubic(math.length(difference));
                weight += w;
                sum += w * difference;
                moments += w * Tensor.Outer(difference, difference);
            }
            double3 offset = sum / weight;
            double lonely = Math.Max(1.0 - (weight - 1.0) / 6.5, 0.0), scale = 1.0 + 0.24 * lonely * lonely;
            Tensor squares = 3.0 * scale * scale * ((1.0 / weight) * moments - Tensor.Outer(offset, offset) + 1.0 / 12.0 * Tensor.Identity);
            double volume = 4.0 / 3.0 * Math.PI * Math.Sqrt(Determinant(squares)), there = weight * math.lerp(0.7, 1.0, lonely * lonely * lonely);
            double fraction = Math.Min(Math.Max(there / volume, 0.2), 1.0);
            double3 center = points[i] + offset;

            Plane plane = Mean(i, Cubic, out double curvature, out double planeWeight);
            double disc = planeWeight > 1e-4 ? Step(6.0, 9.5, weights[i]) * Math.Max(Step(0.1, 0.25, offsets[i]), Step(11.0, 13.0, weights[i])) : 0.0;
            double height = Math.Min(Math.Max(Disc * Disc * curvature, DiscHeight), 0.5);
            Tensor flat = Disc * Disc * Tensor.Identity + (height * height - Disc * Disc) * Tensor.Outer(plane.normal, plane.normal);
            squares = (1.0 - disc) * squares + disc * flat;
            center = math.lerp(center, points[i] + plane.normal * (plane.depth - height), disc);
            return Inside(center, WithinLimits(squares, Math.Pow(fraction, 1.0 - disc)));
        }

        Ellipsoid DiscOnWall(int i, int axis, int side)
        {
            double3 wallNormal = 0.0;
            wallNormal[axis] = side == 0 ? -1.0 : 1.0;
            bool inCorner = math.all(math.min(points[i], box - points[i]) < 1.0);
            double size = inCorner ? DropRadius : math.lerp(DropRadius, WallDisc, Step(6.0, 10.0, weights[i]));
            double3 center = points[i] + wallNormal * ((side == 0 ? points[i][axis] : box[axis] - points[i][axis]) - DiscHeight);
            Plane plane = First(i);
            double3 up = plane.normal - wallNormal * math.dot(plane.normal, wallNormal);
            double slope = math.length(up);
            if (IsDrawn[i] && plane.trust > 0.0 && slope > 1e-3)
                center -= up / slope * Math.Min(Math.Max(size - plane.depth / slope, 0.0), size);
            return Inside(center, size * size * Tensor.Identity + (DiscHeight * DiscHeight - size * size) * Tensor.Outer(wallNormal, wallNormal));
        }

        static double Determinant(Tensor a) => math.dot(a.x, math.cross(a.y, a.z));

        // With its eigenvalues between the squares of the shortest and the longest semi-axis, and a fraction of its volume.
        static Tensor WithinLimits(Tensor a, double fraction)
        {
            Tensor turn = Tensor.Identity;      // its rows become the eigenvectors
            for (int sweep = 0; sweep < 12; sweep++)
                foreach ((double3 p, double3 q) in new[] { (X, Y), (Y, Z), (X, Z) })     // the largest comes first
                {
                    double mixed = math.dot(p, a * q);
                    double angle = 0.5 * Math.Atan2(2.0 * mixed, math.dot(p, a * p) - math.dot(q, a * q));
                    double c = Math.Cos(angle), s = Math.Sin(angle);
                    double3 third = math.cross(p, q);
                    Tensor rotation = Tensor.Outer(third, third) + c * (Tensor.Outer(p, p) + Tensor.Outer(q, q))
                        + s * (Tensor.Outer(p, q) - Tensor.Outer(q, p));
                    a = rotation * a * rotation.Transposed;
                    turn = rotation * turn;
                }
            double3 values = math.clamp(new double3(a.x.x, a.y.y, a.z.z), MinSemiAxis * MinSemiAxis, Disc * Disc), ends = 2.5 - values;
            values = math.max(values * math.pow(fraction, 2.0 * ends / math.csum(ends)), MinSemiAxis * MinSemiAxis);
            return values.x * Tensor.Outer(turn.x, turn.x) + values.y * Tensor.Outer(turn.y, turn.y) + values.z * Tensor.Outer(turn.z, turn.z);
        }

        static readonly double3 X = new double3(1.0, 0.0, 0.0), Y = new double3(0.0, 1.0, 0.0), Z = new double3(0.0, 0.0, 1.0);

        // Moved so that it does not reach out of the box.
        Ellipsoid Inside(double3 center, Tensor squares)
        {
            double3 reach = math.min(new double3(Math.Sqrt(squares.x.x), Math.Sqrt(squares.y.y), Math.Sqrt(squares.z.z)), 0.5 * box);
            return new Ellipsoid { center = math.clamp(center, reach, box - reach), shape = squares };
        }
    }
}
