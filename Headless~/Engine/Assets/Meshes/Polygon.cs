using System;
using System.Collections.Generic;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>Cuts a polygon into triangles along its outline, seen along its normal: ear clipping. Corners may touch others, as where a cut
    /// leads to a hole.</summary>
    /// <remarks>Meisters 1975, "Polygons have ears"; the normal is Newell's. An ear is taken only if no corner lies on its third side, so that
    /// corners along a straight side stay corners of triangles, as those of the faces beside it are.</remarks>
    internal sealed class Polygon
    {
        readonly struct Point
        {
            public readonly double X, Y;
            public Point(double x, double y) => (X, Y) = (x, y);
        }

        // Fractions of the polygon's size and its square: rounding errors of a straight side, and of no area.
        const double Straight = 1e-12, Flat = 1e-10;

        readonly Point[] points;
        readonly List<int> triangles;
        readonly int[] before, after;

        Polygon(Point[] points, List<int> triangles)
        {
            this.points = points;
            this.triangles = triangles;
            before = new int[points.Length];
            after = new int[points.Length];
            int last = -1, first = -1;
            for (var i = 0; i < points.Length; i++)
            {
                // A corner at the position of the one before it bounds nothing.
                if (last >= 0 && Same(last, i)) continue;
                if (last >= 0) (after[last], before[i]) = (i, last);
                else first = i;
                last = i;
            }
            if (last != first && Same(last, first)) last = before[last];
            (after[last], before[first]) = (first, last);
            Start = first;
        }

        int Start { get; }

        /// <summary>Adds three numbers of corners for each triangle, all in the polygon's orientation.</summary>
        /// <returns>False for a polygon that crosses itself: none are added.</returns>
        public static bool TryCut(IReadOnlyList<Vector3> corners, List<int> triangles)
        {
            var count = corners.Count;
            if (count == 3)
            {
                Add(triangles, 0, 1, 2);
                return true;
            }
            // Corners that are not numbers, or in one line, are reported by the mesh.
            var points = Seen(corners, out var isFinite, out var hasArea, out var isLine);
            if (!isFinite || isLine || hasArea && IsConvex(points))
            {
                for (var i = 1; i + 1 < count; i++) Add(triangles, 0, i, i + 1);
                return true;
            }
            var cut = triangles.Count;
            if (hasArea && !Crosses(points) && new Polygon(points, triangles).Clip()) return true;
            triangles.RemoveRange(cut, triangles.Count - cut);
            return false;
        }

        static void Add(List<int> triangles, int a, int b, int c)
        {
            triangles.Add(a);
            triangles.Add(b);
            triangles.Add(c);
        }

        /// <summary>Corners across the polygon's normal, counterclockwise, about the first one and by the polygon's size.</summary>
        static Point[] Seen(IReadOnlyList<Vector3> corners, out bool isFinite, out bool hasArea, out bool isLine)
        {
            var count = corners.Count;
            var away = new (double X, double Y, double Z)[count];
            var size = 0.0;
            for (var i = 0; i < count; i++)
            {
                away[i] = ((double)corners[i].x - corners[0].x, (double)corners[i].y - corners[0].y, (double)corners[i].z - corners[0].z);
                size = Math.Max(size, Math.Max(Math.Abs(away[i].X), Math.Max(Math.Abs(away[i].Y), Math.Abs(away[i].Z))));
                if (!double.IsFinite(away[i].X + away[i].Y + away[i].Z)) size = double.NaN;
            }
            isFinite = double.IsFinite(size);
            double x = 0, y = 0, z = 0, most = 0;
            for (var i = 0; i < count; i++)
            {
                var (a, b) = (away[i], away[(i + 1) % count]);
                var (u, v, w) = ((a.Y * b.Z - a.Z * b.Y) / (size * size), (a.Z * b.X - a.X * b.Z) / (size * size),
                    (a.X * b.Y - a.Y * b.X) / (size * size));
                (x, y, z) = (x + u, y + v, z + w);
                most = Math.Max(most, Math.Sqrt(u * u + v * v + w * w));
            }
            var length = Math.Sqrt(x * x + y * y + z * z);
            hasArea = length > Flat;
            isLine = !(most > Flat);
            var points = new Point[count];
            if (!hasArea) return points;
            (x, y, z) = (x / length, y / length, z / length);
            // Two axes across the normal (Duff et al. 2017).
            var sign = z < 0 ? -1.0 : 1.0;
            var (f, g) = (-1 / (sign + z), x * y * (-1 / (sign + z)));
            for (var i = 0; i < count; i++)
            {
                var a = away[i];
                points[i] = new Point((a.X * (1 + sign * x * x * f) + a.Y * sign * g - a.Z * sign * x) / size,
                    (a.X * g + a.Y * (sign + y * y * f) - a.Z * y) / size);
            }
            return points;
        }

        // Above 0 where c lies left of the line from a to b: twice the area of their triangle.
        static double Turn(Point a, Point b, Point c) => (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);

        double Turn(int a, int b, int c) => Turn(points[a], points[b], points[c]);

        bool Same(int a, int b) => points[a].X == points[b].X && points[a].Y == points[b].Y;

        /// <summary>Whether it turns left at every corner, and once around in all.</summary>
        static bool IsConvex(Point[] points)
        {
            int count = points.Length, changes = 0;
            bool GoesRight(int i) => points[(i + 1) % count].X > points[i].X;
            for (var i = 0; i < count; i++)
            {
                if (!(Turn(points[i], points[(i + 1) % count], points[(i + 2) % count]) > Straight)) return false;
                changes += GoesRight(i) != GoesRight((i + 1) % count) ? 1 : 0;
            }
            return changes == 2;
        }

        /// <summary>Whether two sides pass through each other. They may touch.</summary>
        static bool Crosses(Point[] points)
        {
            var count = points.Length;
            var sides = new int[count];
            var lowest = new double[count];
            for (var i = 0; i < count; i++)
            {
                sides[i] = i;
                lowest[i] = Math.Min(points[i].X, points[(i + 1) % count].X);
            }
            Array.Sort(lowest, sides);
            for (var i = 0; i < count; i++)
            {
                Point a = points[sides[i]], b = points[(sides[i] + 1) % count];
                for (var j = i + 1; j < count && lowest[j] <= Math.Max(a.X, b.X); j++)
                {
                    Point c = points[sides[j]], d = points[(sides[j] + 1) % count];
                    if (Opposed(Turn(a, b, c), Turn(a, b, d)) && Opposed(Turn(c, d, a), Turn(c, d, b))) return true;
                }
            }
            return false;
        }

        static bool Opposed(double a, double b) => a > Straight && b < -Straight || a < -Straight && b > Straight;

        bool Clip()
        {
            var left = 1;
            for (var i = after[Start]; i != Start; i = after[i]) left++;
            var at = Start;
            for (var tries = 0; left > 3 && tries < left;)
                if (IsEar(at))
                {
                    Take(at);
                    // The one beyond it, so that the triangles do not all hang on one corner.
                    at = after[after[at]];
                    (left, tries) = (left - 1, 0);
                }
                else (at, tries) = (after[at], tries + 1);
            // There and back again bounds nothing.
            for (var tries = 0; left > 3 && tries < left;)
                if (Math.Abs(Turn(before[at], at, after[at])) <= Straight)
                {
                    Remove(at);
                    at = after[at];
                    (left, tries) = (left - 1, 0);
                }
                else if (IsEar(at))
                {
                    Take(at);
                    at = after[at];
                    (left, tries) = (left - 1, 0);
                }
                else (at, tries) = (after[at], tries + 1);
            if (left > 3) return false;
            if (left == 3 && Turn(before[at], at, after[at]) > Straight) Take(at);
            return true;
        }

        void Take(int corner)
        {
            Add(triangles, before[corner], corner, after[corner]);
            Remove(corner);
        }

        void Remove(int corner)
        {
            after[before[corner]] = after[corner];
            before[after[corner]] = before[corner];
        }

        bool IsEar(int tip)
        {
            int a = before[tip], b = after[tip];
            if (!(Turn(a, tip, b) > Straight)) return false;
            for (var i = after[b]; i != a; i = after[i])
            {
                if (Same(i, a) && ReachesIn(i, a, tip, b) || Same(i, tip) && ReachesIn(i, tip, b, a) || Same(i, b) && ReachesIn(i, b, a, tip))
                    return false;
                if (Same(i, a) || Same(i, tip) || Same(i, b)) continue;
                if (Turn(a, tip, i) >= -Straight && Turn(tip, b, i) >= -Straight && Turn(b, a, i) >= -Straight) return false;
            }
            return true;
        }

        /// <summary>Whether the outline goes on between the sides that meet at a corner of a triangle, from another corner at the same
        /// position.</summary>
        bool ReachesIn(int other, int corner, int next, int last)
            => IsBetween(before[other], corner, next, last) || IsBetween(after[other], corner, next, last);

        bool IsBetween(int i, int corner, int next, int last) => Turn(corner, next, i) > Straight && Turn(last, corner, i) > Straight;
    }
}
