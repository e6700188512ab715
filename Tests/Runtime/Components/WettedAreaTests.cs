using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Position and size of the area that a contact wets: in still water, against the geometry.</summary>
    public class WettedAreaTests : PlayedFluidFixture
    {
        const float Spacing = 0.05f, Surface = 0.05f;       // m; of the water, which stands 0.65 m deep

        FluidContact newest;

        // Both sides, the lower edge and half of the two upright edges.
        [UnityTest, Category("LongRun")]
        public IEnumerator A_plate_that_is_half_wetted_tells_half_of_its_surface_and_its_center()
        {
            const float width = 0.5f, height = 0.6f, thickness = 0.1f;
            yield return Settle(collider => collider.Size = new Vector3(width, height, thickness), new Vector3(0f, Surface, 0f), quaternion.identity);
            float sides = 2f * width * 0.5f * height, bottom = width * thickness, edges = 2f * thickness * 0.5f * height;
            float center = (0.25f * -height * (sides + edges) - 0.5f * height * bottom) / (sides + edges + bottom);
            IsNear(sides + bottom + edges, 0.06f);
            Assert.That(Vector3.Distance(newest.Point, new Vector3(0f, Surface + center, 0f)), Is.LessThan(0.3f * Spacing));
            Assert.That(Vector3.Angle(newest.Normal, Vector3.down), Is.LessThan(10f), "the open upper half is dry");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_wall_is_wet_on_the_side_of_the_water_alone()
        {
            yield return Settle(collider => collider.Size = new Vector3(0.4f, 2f, 2f), new Vector3(-0.6f, 0f, 0f), quaternion.identity);
            IsNear(0.65f * 1.2f, 0.06f);
            Assert.That(Vector3.Angle(newest.Normal, Vector3.right), Is.LessThan(1f));
            Assert.That(Vector3.Distance(newest.Point, new Vector3(-0.4f, Surface - 0.325f, 0f)), Is.LessThan(0.5f * Spacing));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_ball_tells_the_cap_that_is_under_water([Values(0f, 0.1f)] float above)
        {
            const float radius = 0.25f;
            FluidSimulation fluid = Water(Vector3.zero, Quaternion.identity);
            var probes = new FluidProbe[8];     // the water around it is a little higher here and lower there
            for (int i = 0; i < probes.Length; i++)
            {
                probes[i] = new GameObject("Probe").AddComponent<FluidProbe>();
                probes[i].transform.SetParent(fluid.transform, false);
                probes[i].transform.localPosition = Quaternion.Euler(0f, 45f * i, 0f) * new Vector3(0.4f, 0f, 0f);
            }
            yield return Settle(fluid, Ball(fluid, radius, new Vector3(0f, Surface + above, 0f)));
            float level = 0f;
            foreach (FluidProbe probe in probes)
                level += probe.Latest.height / probes.Length;
            float depth = level - Surface - above + radius;
            Assert.That(level, Is.EqualTo(Surface).Within(0.5f * Spacing));
            float halfSpacingOfWaterline = math.PI * radius * Spacing;      // a zone's area grows as its height alone
            IsNear(2f * math.PI * radius * depth, 0.03f + halfSpacingOfWaterline / (2f * math.PI * radius * depth));
            Assert.That(Vector3.Angle(newest.Normal, Vector3.down), Is.LessThan(3f));
            // A zone of a sphere has its center halfway between its planes.
            Assert.That(Vector3.Distance(newest.Point, new Vector3(0f, level - 0.5f * depth, 0f)), Is.LessThan(0.5f * Spacing));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_ball_under_water_tells_all_of_its_surface_and_no_normal()
        {
            const float radius = 0.25f;
            FluidSimulation fluid = Water(Vector3.zero, Quaternion.identity);
            yield return Settle(fluid, Ball(fluid, radius, new Vector3(0f, -0.3f, 0f)));
            IsNear(4f * math.PI * radius * radius, 0.08f);
            Assert.That(newest.Normal, Is.EqualTo(Vector3.zero));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_turned_box_under_water_tells_all_of_its_surface_and_no_normal()
        {
            yield return Settle(collider => collider.Size = new Vector3(0.3f, 0.25f, 0.35f), new Vector3(0.05f, -0.25f, 0f),
                quaternion.Euler(0.4f, 0.7f, 0.2f));
            IsNear(2f * (0.3f * 0.25f + 0.25f * 0.35f + 0.3f * 0.35f), 0.06f);
            Assert.That(newest.Normal, Is.EqualTo(Vector3.zero));
            Assert.That(Vector3.Distance(newest.Point, new Vector3(0.05f, -0.25f, 0f)), Is.LessThan(0.3f * Spacing));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator In_a_turned_and_moved_fluid_contacts_are_in_world_space()
        {
            var position = new Vector3(3f, 1f, -2f);
            Quaternion turn = Quaternion.Euler(0f, 35f, 0f);
            yield return Settle(collider => collider.Size = new Vector3(0.4f, 2f, 2f), new Vector3(-0.6f, 0f, 0f), quaternion.identity, position,
                turn);
            IsNear(0.65f * 1.2f, 0.06f);
            Assert.That(Vector3.Angle(newest.Normal, turn * Vector3.right), Is.LessThan(1f));
            Assert.That(Vector3.Distance(newest.Point, position + turn * new Vector3(-0.4f, Surface - 0.325f, 0f)), Is.LessThan(0.5f * Spacing));
        }

        // Two blocks one on the other: the seam between them is dry, and each tells its own part.
        [UnityTest, Category("LongRun")]
        public IEnumerator Colliders_that_touch_tell_their_own_parts_without_what_they_cover()
        {
            var side = new Vector3(0.3f, 0.2f, 0.3f);
            FluidContact upper = default;
            FluidSimulation fluid = Water(Vector3.zero, Quaternion.identity);
            FluidCollider second = Collider(fluid, collider => collider.Size = side, new Vector3(0f, -0.2f, 0f), quaternion.identity);
            second.OnEnter += contact => upper = contact;
            yield return Settle(fluid, Collider(fluid, collider => collider.Size = side, new Vector3(0f, -0.4f, 0f), quaternion.identity));
            float sides = 4f * side.x * side.y, top = side.x * side.z;
            IsNear(sides + top, 0.06f);
            Assert.That(upper.Area, Is.EqualTo(sides + top).Within(0.06f * (sides + top)));
            Assert.That(Vector3.Angle(newest.Normal, Vector3.down), Is.LessThan(5f));
            Assert.That(Vector3.Angle(upper.Normal, Vector3.up), Is.LessThan(5f));
        }

        [UnityTest]
        public IEnumerator Without_a_listener_nothing_is_measured_also_where_forces_are()
        {
            FluidSimulation fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000, new Vector3(0.6f, 0.3f, 0.6f));
            FluidCollider box = Collider(fluid, collider =>
            {
                collider.Size = 0.1f * Vector3.one;
                collider.MeasuresForce = true;
            }, new Vector3(0f, -0.2f, 0f), quaternion.identity);
            yield return Frames(4);
            Assert.That(fluid.Solver.Reactions.HasWettedAreas, Is.False);
            Assert.That(box.TryGetForce(out _, out _));
            void Listen(FluidContact contact) => newest = contact;
            box.OnEnter += Listen;
            yield return Frames(6);
            Assert.That(fluid.Solver.Reactions.HasWettedAreas);
            Assert.That(newest.Area, Is.EqualTo(6f * 0.1f * 0.1f).Within(0.15f * 0.06f), "all of it is under water");
            box.OnEnter -= Listen;
            yield return Frames(2);
            Assert.That(fluid.Solver.Reactions.HasWettedAreas, Is.False);
        }

        [Test]
        public void A_contact_that_has_left_says_where_the_last_water_was()
        {
            var watch = new ContactWatch();
            Assert.That(watch.Follow(default, Vector3.one).Point, Is.EqualTo(Vector3.one), "before any water");
            watch.Follow(new WettedArea(2f, Vector3.up, Vector3.right), Vector3.one);
            WettedArea left = watch.Follow(default, Vector3.one);
            Assert.That((left.Area, left.Point, left.Normal), Is.EqualTo((0f, Vector3.up, Vector3.right)));
        }

        void IsNear(float area, float error)
        {
            TestContext.Out.WriteLine($"{newest}; {100f * (newest.Area / area - 1f):0.0} % of {area:0.0000} m² off");
            Assert.That(newest.Area, Is.EqualTo(area).Within(error * area));
        }

        IEnumerator Settle(Action<FluidCollider> setUp, Vector3 at, Quaternion rotation, Vector3 position = default, Quaternion? turn = null)
        {
            FluidSimulation fluid = Water(position, turn ?? Quaternion.identity);
            return Settle(fluid, Collider(fluid, setUp, at, rotation));
        }

        // The first reading that is listened to is told.
        IEnumerator Settle(FluidSimulation fluid, FluidCollider collider)
        {
            newest = default;
            yield return null;
            fluid.Fill(FluidShape.Box(fluid.transform.TransformPoint(new Vector3(0f, -0.275f, 0f)), new Vector3(1.2f, 0.65f, 1.2f),
                fluid.transform.rotation));
            yield return Frames(60);
            collider.OnEnter += contact => newest = contact;
            yield return Frames(5);
            Assert.That(newest.Collider, Is.SameAs(collider));
        }

        FluidSimulation Water(Vector3 position, Quaternion turn)
        {
            return Fluid("Fluid", new Vector3(1.2f, 1.2f, 1.2f), Spacing, 12000, Vector3.zero, made =>
            {
                made.transform.SetPositionAndRotation(position, turn);
                SolverSettings settings = made.Settings;
                settings.iterations = 6;
                made.Settings = settings;
            });
        }

        FluidCollider Ball(FluidSimulation fluid, float radius, Vector3 at) => Collider(fluid, collider =>
        {
            collider.Shape = ColliderShape.Sphere;
            collider.Radius = radius;
        }, at, quaternion.identity);

        FluidCollider Collider(FluidSimulation fluid, Action<FluidCollider> setUp, Vector3 at, Quaternion rotation)
        {
            var thing = new GameObject("Collider");
            made.Add(thing);
            thing.transform.SetPositionAndRotation(fluid.transform.TransformPoint(at), fluid.transform.rotation * rotation);
            var collider = thing.AddComponent<FluidCollider>();
            setUp(collider);
            return collider;
        }
    }
}
