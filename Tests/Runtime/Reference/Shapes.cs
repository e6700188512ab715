using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>Signed distances from the shapes of colliders, in double precision.</summary>
    static class Shapes
    {
        /// <param name="shape">At the end of its motion.</param>
        /// <param name="p">In the domain's frame, d.</param>
        public static double Distance(in ColliderMotion shape, double3 p)
        {
            double3 local = Unrotate(shape.end.rotation, p - (double3)shape.end.position);
            double distance = Distance(shape.shape, shape.size, local);
            return shape.insideOut ? -distance : distance;
        }

        /// <summary>Fraction of the rest density that a shape adds at p: of the half space beyond its surface, for a box the product of its
        /// three slabs; at most that at a surface.</summary>
        public static double Density(in ColliderMotion shape, double3 p)
        {
            double surface = Walls.PlaneDensity(0.0);
            if (shape.shape != ColliderShape.Box)
                return Walls.PlaneDensity(Math.Max(Distance(shape, p), 0.0));

            double3 local = Unrotate(shape.end.rotation, p - (double3)shape.end.position);
            double full = 2.0 * surface, inside = 1.0;
            for (int axis = 0; axis < 3; axis++)
                inside *= 1.0 - (Beyond(shape.size[axis] - local[axis]) + Beyond(shape.size[axis] + local[axis])) / full;
            return Math.Min(full * (shape.insideOut ? 1.0 - inside : inside), surface);
        }

        // Density of what lies beyond a plane at distance s, also from its back.
        static double Beyond(double s) => s >= 0.0 ? Walls.PlaneDensity(s) : 2.0 * Walls.PlaneDensity(0.0) - Walls.PlaneDensity(-s);

        static double Distance(ColliderShape kind, double3 size, double3 p)
        {
            switch (kind)
            {
                case ColliderShape.Sphere:
                    return math.length(p) - size.x;
                case ColliderShape.Capsule:
                    return math.length(p - new double3(0.0, math.clamp(p.y, -size.y, size.y), 0.0)) - size.x;
                case ColliderShape.Plane:
                    return p.y;
                case ColliderShape.Box:
                    double3 beyond = math.abs(p) - size;
                    return math.length(math.max(beyond, 0.0)) + Math.Min(math.cmax(beyond), 0.0);
                default:
                    throw new ArgumentException($"{kind} has no formula");
            }
        }

        static double3 Unrotate(quaternion rotation, double3 v)
        {
            double3 axis = -(double3)rotation.value.xyz;
            return v + 2.0 * math.cross(axis, math.cross(axis, v) + rotation.value.w * v);
        }
    }
}
