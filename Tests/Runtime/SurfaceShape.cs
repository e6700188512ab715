using System;
using System.Linq;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>An ellipsoid of the surface, as the renderers unpack it; lengths in d.</summary>
    struct SurfaceShape
    {
        public double3 center, chord;
        /// <summary>Unit vectors along the semi-axes.</summary>
        public double3 x, y, z;
        public double3 semiAxes;
        public int particle;

        /// <summary>Those that the solver has to draw, sorted by particle.</summary>
        public static SurfaceShape[] Read(PbfSolver solver) => Read(solver.Surface);

        public static SurfaceShape[] Read(SurfaceParticles stage)
        {
            int drawn = (int)GpuTest.Read<uint>(stage.Counters, 3)[(int)SurfaceParticles.Counter.Drawn];
            return GpuTest.Read<SurfaceParticles.Element>(stage.Particles, drawn).Select(Unpack).OrderBy(shape => shape.particle).ToArray();
        }

        /// <summary>The sum of the outer products of the semi-axes.</summary>
        public Tensor Squares => semiAxes.x * semiAxes.x * Tensor.Outer(x, x) + semiAxes.y * semiAxes.y * Tensor.Outer(y, y) + semiAxes.z * semiAxes.z * Tensor.Outer(z, z);

        /// <summary>How far it reaches along the axes of the domain.</summary>
        public double3 Reach
        {
            get
            {
                Tensor squares = Squares;
                return math.sqrt(new double3(squares.x.x, squares.y.y, squares.z.z));
            }
        }

        /// <summary>Whether it is a disc that covers a wall of the box.</summary>
        public bool IsOnWall(double3 box)
        {
            double3 distance = math.min(center, box - center), along = math.abs(z);
            return semiAxes.z < 0.101 && math.any((along > 0.999) & (math.abs(distance - 0.1) < 1e-4));
        }

        public static SurfaceShape Unpack(SurfaceParticles.Element element)
        {
            double4 q = Rotation(element.b.x);
            double2 first = Halves(element.b.y), second = Halves(element.b.z), third = Halves(element.b.w);
            return new SurfaceShape
            {
                center = math.asfloat(element.a.xyz),
                particle = (int)element.a.w,
                semiAxes = new double3(first, second.x),
                chord = new double3(second.y, third),
                x = Turn(q, new double3(1, 0, 0)),
                y = Turn(q, new double3(0, 1, 0)),
                z = Turn(q, new double3(0, 0, 1)),
            };
        }

        static double2 Halves(uint packed) => new double2(Mathf.HalfToFloat((ushort)packed), Mathf.HalfToFloat((ushort)(packed >> 16)));

        static double4 Rotation(uint packed)
        {
            double3 kept = (new double3((packed >> 20) & 1023, (packed >> 10) & 1023, packed & 1023) - 511.0) * (Math.Sqrt(0.5) / 511.0);
            double left = Math.Sqrt(Math.Max(1.0 - math.dot(kept, kept), 0.0));
            switch (packed >> 30)
            {
                case 0: return new double4(left, kept);
                case 1: return new double4(kept.x, left, kept.yz);
                case 2: return new double4(kept.xy, left, kept.z);
                default: return new double4(kept, left);
            }
        }

        static double3 Turn(double4 q, double3 v) => v + 2.0 * math.cross(q.xyz, math.cross(q.xyz, v) + q.w * v);
    }
}
