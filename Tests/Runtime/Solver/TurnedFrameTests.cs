using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The laws know no axes: a lump of fluid on a plate, far from the box's walls, moves the same where all of it is turned. Along
    /// the axes the mixed terms of tensors, and of motions that turn, vanish.</summary>
    public class TurnedFrameTests
    {
        const float Spacing = 0.05f, TimeStep = 0.01f;
        const int Steps = 4;

        static readonly float3 Center = 16f;        // of the box, d

        public enum Law { Water, Viscous, Elastic, Vortices, Tension, Friction, TurningPlate, ViscousTurningPlate, Corner, Extrapolated }

        [Test]
        public void A_lump_on_a_plate_moves_the_same_where_all_of_it_is_turned([Values] Law law)
        {
            (float3 position, float3 velocity)[] along = Run(law, quaternion.identity), turned = Run(law,
                quaternion.AxisAngle(math.normalize(new float3(1f, 2f, 3f)), 0.7f));
            double apart = 0.0, difference = 0.0, moved = 0.0, fastest = 0.0;
            for (int i = 0; i < along.Length; i++)
            {
                apart = Math.Max(apart, math.distance(along[i].position, turned[i].position));
                difference = Math.Max(difference, math.distance(along[i].velocity, turned[i].velocity));
                fastest = Math.Max(fastest, math.length(along[i].velocity));
            }
            (float3 position, float3 velocity)[] plain = Run(law == Law.Friction ? Law.Water : Law.Friction, quaternion.identity);
            for (int i = 0; i < along.Length; i++)
                moved = Math.Max(moved, math.distance(along[i].velocity, plain[i].velocity));
            TestContext.Out.WriteLine($"{apart:g2} d and {difference / fastest:g2} of the fastest apart; the law itself {moved / fastest:g2}");
            Assert.That(moved, Is.GreaterThan(0.02 * fastest), "it matters here");
            Assert.That(difference, Is.LessThan((law == Law.Extrapolated ? 5e-3 : 3e-4) * fastest));
            Assert.That(apart, Is.LessThan(law == Law.Extrapolated ? 2e-3 : 2e-4));
        }

        // By quarters, so that the coarse grid's cells come to lie on each other: the water's surface is below, above or beside, and each axis is
        // each one's. The grid is solved to the end, or the order of its cells would be seen. How much of a face is open is found from triangles,
        // whose sides are others where low ends and high ends change places: beside surfaces that are not plane that is seen, so these have
        // thirds alone.
        [Test, Category("LongRun")]
        public void Deep_water_among_colliders_moves_the_same_where_all_of_it_is_turned_by_quarters([Values(1, 2, 3, 4, 5, 6)] int turn)
        {
            bool isPlane = turn < FirstThird;
            (float3 position, float3 velocity)[] along = RunDeep(Quarters[0], isPlane), turned = RunDeep(Quarters[turn], isPlane);
            double apart = 0.0, difference = 0.0, fastest = 0.0;
            for (int i = 0; i < along.Length; i++)
            {
                apart = Math.Max(apart, math.distance(along[i].position, turned[i].position));
                difference = Math.Max(difference, math.distance(along[i].velocity, turned[i].velocity));
                fastest = Math.Max(fastest, math.length(along[i].velocity));
            }
            TestContext.Out.WriteLine($"{apart:g2} d and {difference / fastest:g2} of the fastest apart");
            Assert.That(difference, Is.LessThan(1e-3 * fastest));
            Assert.That(apart, Is.LessThan(1e-3));
        }

        const int FirstThird = 5;

        // Columns: where x, y and z come to point. Turned over about x and about z, on two sides, and by thirds about a diagonal.
        static readonly float3x3[] Quarters =
        {
            float3x3.identity,
            new float3x3(1, 0, 0, 0, -1, 0, 0, 0, -1),
            new float3x3(-1, 0, 0, 0, -1, 0, 0, 0, 1),
            new float3x3(0, -1, 0, 1, 0, 0, 0, 0, 1),
            new float3x3(1, 0, 0, 0, 0, -1, 0, 1, 0),
            new float3x3(0, 0, 1, 1, 0, 0, 0, 1, 0),
            new float3x3(0, 1, 0, 0, 0, 1, 1, 0, 0),
        };

        static (float3 position, float3 velocity)[] RunDeep(float3x3 turn, bool isPlane)
        {
            const float side = 24f;
            quaternion rotation = new quaternion(turn);
            float3 center = 0.5f * side;
            ColliderMotion slope = ColliderTests.Still(ColliderShape.Plane, 0f, Put(new float3(-11f, -12.7f, 0f)),
                math.mul(rotation, quaternion.Euler(0.1f, 0f, 0.3f)));
            ColliderMotion post = ColliderTests.Still(ColliderShape.Box, new float3(2.7f, 7.1f, 3.3f), Put(new float3(3.1f, -1.7f, 2.3f)),
                math.mul(rotation, quaternion.Euler(0.2f, 0.5f, -0.3f)));
            ColliderMotion ball = ColliderTests.Still(ColliderShape.Sphere, 3.3f, Put(new float3(-5.3f, -0.7f, -6.1f)), rotation);
            var random = new Unity.Mathematics.Random(29u);
            var positions = new List<float3>();
            var velocities = new List<float3>();
            for (int i = 0; i < 24 * 18 * 24; i++)
            {
                float3 p = new float3(i % 24, i / 24 % 18, i / (24 * 18)) - new float3(11.5f) + random.NextFloat3(-0.1f, 0.1f);
                float3 v = random.NextFloat3(-1f, 1f) + 8f * math.sin(0.3f * p.zxy);
                if (p.y > 0.3f * p.x + 0.1f * p.z + 1f || math.min(math.min(Away(slope, p), Away(post, p)), Away(ball, p)) < 0.6f)
                    continue;
                positions.Add(Put(p) * Spacing);
                velocities.Add(math.mul(turn, v) * Spacing);
            }
            using (var fluid = new TestFluid(side * Spacing, Spacing, positions.Count, ColliderDeepWaterTests.Deep))
            {
                fluid.Input.gravity = math.mul(turn, new float3(1f, -9f, 0.5f));
                fluid.Step();
                fluid.Solver.Coarse.Solver.Cycles = 40;
                fluid.Add(positions.ToArray(), velocities.ToArray());
                for (int step = 0; step < 3; step++)
                {
                    ColliderTests.Use(fluid, isPlane ? new[] { Moved(slope, step, 0.05f) } : new[] { slope, post, Moved(ball, step, 0.1f) });
                    fluid.Step();
                }
                ParticleState state = fluid.Read();
                Assert.That(state.Count, Is.EqualTo(positions.Count).And.GreaterThan(2000));
                float3x3 back = math.transpose(turn);
                return Enumerable.Range(0, state.Count).OrderBy(i => state.ids[i]).Select(i => (math.mul(back, state.positions[i].xyz - center),
                    math.mul(back, state.velocities[i].xyz))).ToArray();
            }

            float3 Put(float3 p) => center + math.mul(turn, p);

            ColliderMotion Moved(ColliderMotion collider, int step, float by)
            {
                float3 shift = by * math.mul(turn, new float3(1f, 0.6f, 0.4f)), begin = collider.end.position;
                collider.start.position = begin + step * shift;
                collider.end.position = begin + (step + 1) * shift;
                return collider;
            }

            double Away(in ColliderMotion collider, float3 p) => Reference.Shapes.Distance(collider, Put(p));
        }

        // By number, turned back; d and d/s.
        static (float3 position, float3 velocity)[] Run(Law law, quaternion rotation)
        {
            var random = new Unity.Mathematics.Random(71u);
            float3[] positions = new float3[100], velocities = new float3[positions.Length];
            for (int i = 0; i < positions.Length; i++)
            {
                positions[i] = new float3(i % 5 - 2f, i / 25 + 0.6f, i / 5 % 5 - 2f) + random.NextFloat3(-0.2f, 0.2f);
                // turning, shearing and stretching alike
                velocities[i] = math.mul(new float3x3(0.2f, 0.5f, -0.3f, -0.2f, -0.1f, 0.4f, 0.6f, 0.1f, -0.1f), positions[i])
                    + random.NextFloat3(-0.2f, 0.2f);
                velocities[i] *= 5f;
            }
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.Off;
            settings.numericalDamping = law == Law.Extrapolated ? 0f : 1f;
            using (var fluid = new TestFluid(32f * Spacing, Spacing, positions.Length, settings))
            {
                FluidMaterial material = fluid.Input.material;
                material.velocitySmoothing = law == Law.Water ? 0.05f : 0f;
                material.wallFriction = 0f;
                material.dynamicViscosity = law == Law.Viscous || law == Law.ViscousTurningPlate || law == Law.Corner
                    ? 0.4f * Spacing * Spacing / TimeStep * material.density : 0f;
                material.shearModulus = law == Law.Elastic ? 200f : 0f;
                material.relaxationTime = 0.2f;
                material.vorticity = law == Law.Vortices ? 1f : 0f;
                material.allowedTension = law == Law.Tension ? 0.05f : 0f;
                material.artificialPressure = law == Law.Tension ? 0.2f : 0f;
                fluid.Input.material = material;
                fluid.Input.timeStep = TimeStep;
                fluid.Input.gravity = math.mul(rotation, new float3(2f, -9f, 1f));
                fluid.Add(positions.Select(p => (Center + math.mul(rotation, p)) * Spacing).ToArray(), velocities.Select(v => math.mul(rotation, v)
                    * Spacing).ToArray());
                for (int step = 0; step < Steps; step++)
                {
                    ColliderMotion floor = Plate(new float3(6f, 3f, 6f), new float3(0f, -3f, 0f), rotation);
                    if (law == Law.TurningPlate || law == Law.ViscousTurningPlate)
                    {
                        floor.start = Turned(floor.start, rotation, 0.03f * step);
                        floor.end = Turned(floor.end, rotation, 0.03f * (step + 1));
                    }
                    floor.friction = law == Law.Water ? 0f : 1f;
                    ColliderMotion side = Plate(new float3(3f, 6f, 6f), new float3(-5.6f, 3f, 0f), rotation);
                    side.friction = 0.5f;
                    if (law == Law.Corner)
                        ColliderTests.Use(fluid, floor, side);
                    else
                        ColliderTests.Use(fluid, floor);
                    fluid.Step();
                }
                ParticleState state = fluid.Read();
                Assert.That(state.Count, Is.EqualTo(positions.Length));
                quaternion back = math.inverse(rotation);
                return Enumerable.Range(0, state.Count).OrderBy(i => state.ids[i]).Select(i => (math.mul(back, state.positions[i].xyz - Center),
                    math.mul(back, state.velocities[i].xyz))).ToArray();
            }
        }

        static ColliderMotion Plate(float3 size, float3 position, quaternion rotation)
            => ColliderTests.Still(ColliderShape.Box, size, Center + math.mul(rotation, position), rotation);

        // About an axis that lies across the plate's center and through it, all of it turned.
        static RigidPose Turned(RigidPose pose, quaternion rotation, float angle)
        {
            quaternion turn = quaternion.AxisAngle(math.mul(rotation, math.normalize(new float3(0.5f, 1f, 0.2f))), angle);
            return new RigidPose(Center + math.mul(turn, pose.position - Center), math.mul(turn, pose.rotation));
        }
    }
}
