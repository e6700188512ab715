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
        /// <summary>Set for thick water: its normal, z, is stored more finely than other shapes are.</summary>
        public bool isDisc;

        /// <summary>Those that the solver has to draw, sorted by particle.</summary>
        public static SurfaceShape[] Read(PbfSolver solver) => Read(solver.Surface);

        public static SurfaceShape[] Read(SurfaceParticles stage)
        {
            int drawn = (int)GpuTest.Read<uint>(stage.Counters, 3)[(int)SurfaceParticles.Counter.Drawn];
            return GpuTest.Read<SurfaceParticles.Element>(stage.Particles, drawn).Select(Unpack).OrderBy(shape => shape.particle).ToArray();
        }

        /// <summary>The sum of the outer products of the semi-axes.</summary>
        public Tensor Squares => semiAxes.x * semiAxes.x * Tensor.Outer(x, x) + semiAxes.y * semiAxes.y * Tensor.Outer(y, y)
            + semiAxes.z * semiAxes.z * Tensor.Outer(z, z);

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
            double2 first = Halves(element.b.y), second = Halves(element.b.z), third = Halves(element.b.w);
            var shape = new SurfaceShape
            {
                center = math.asfloat(element.a.xyz),
                particle = (int)element.a.w,
                isDisc = first.y < 0.0,
                semiAxes = new double3(math.abs(first), second.x),
                chord = new double3(second.y, third),
            };
            if (shape.isDisc)
            {
                shape.z = Normal(element.b.x);
                shape.x = math.normalize(math.cross(Math.Abs(shape.z.x) < 0.6 ? new double3(1, 0, 0) : new double3(0, 1, 0), shape.z));
                shape.y = math.cross(shape.z, shape.x);
                return shape;
            }
            double4 q = Rotation(element.b.x);
            shape.x = Turn(q, new double3(1, 0, 0));
            shape.y = Turn(q, new double3(0, 1, 0));
            shape.z = Turn(q, new double3(0, 0, 1));
            return shape;
        }

        static double3 Normal(uint packed)
        {
            double2 picture = new double2((short)packed, (short)(packed >> 16)) / 32767.0;
            var n = new double3(picture, 1.0 - math.csum(math.abs(picture)));
            if (n.z < 0.0)
                n.xy = (1.0 - math.abs(n.yx)) * new double2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
            return math.normalize(n);
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
