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
