using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Pressure on the faces of a body that solids cover, against that of still water.</summary>
    public class BodySurroundingsTests
    {
        const float Spacing = 0.05f, Level = 0.4f, PerDepth = 1000f * 9.81f;      // m; of the water over the origin; Pa/m
        static readonly Vector3 Half = new Vector3(0.1f, 0.15f, 0.12f);             // of the body, m

        readonly List<GameObject> made = new List<GameObject>();

        [TearDown]
        public void LeaveNothing()
        {
            foreach (GameObject thing in made)
                Object.DestroyImmediate(thing);
            made.Clear();
        }

        // A gap of 1.5 d has no water, one of 2.5 d has all of it. The other faces press on nothing there: near as they are, they do not face it.
        [Test]
        public void A_solid_before_a_face_covers_that_face_and_no_other([Values(1f, 2f, 3f)] float gap, [Values] bool byCollider,
            [Values(0f, 35f)] float turn)
        {
            Quaternion rotation = Quaternion.Euler(0f, turn, 0f);
            FluidSimulation fluid = Fluid(rotation);
            Vector3 wall = fluid.transform.TransformPoint(new Vector3(byCollider ? 0.2f : 0.5f, 0f, 0f)), along = rotation * Vector3.right;
            if (byCollider)
            {
                FluidCollider solid = Make("Wall").AddComponent<FluidCollider>();
                solid.Size = new Vector3(0.3f, 2f, 2f);
                solid.transform.SetPositionAndRotation(wall + 0.15f * along, rotation);
                solid.gameObject.SetActive(true);
            }
            fluid.Advance(fluid.FixedStep);
            Vector3 center = wall - (gap * Spacing + Half.x) * along;
            StillWater still = Look(fluid, center, rotation);

            float depth = Level - center.y, covered = gap < 1.5f ? 1f : gap > 2.5f ? 0f : 2.5f - gap;
            float force = covered * PerDepth * depth * 4f * Half.y * Half.z;
            TestContext.Out.WriteLine($"{still.coveredPush} N of {force:0.0} N, {still.coveredMoment} N m");
            Assert.That(Vector3.Distance(still.coveredPush, -force * along), Is.LessThan(0.02f * PerDepth * depth * 4f * Half.y * Half.z));
            // The center of pressure lies below that of the face.
            Vector3 arm = Half.x * along - Half.y * Half.y / (3f * depth) * Vector3.up, moment = Vector3.Cross(arm, -force * along);
            Assert.That(Vector3.Distance(still.coveredMoment, moment), Is.LessThan(0.1f * Mathf.Max(moment.magnitude, 0.1f)));
        }

        [Test]
        public void A_body_among_nothing_is_covered_nowhere_and_what_lies_on_the_floor_below()
        {
            FluidSimulation fluid = Fluid(Quaternion.identity);
            fluid.Advance(fluid.FixedStep);
            Assert.That(Look(fluid, Vector3.zero, Quaternion.identity).coveredPush, Is.EqualTo(Vector3.zero));
            var onFloor = new Vector3(0f, -0.5f + Half.y, 0f);
            float lift = PerDepth * (Level + 0.5f) * 4f * Half.x * Half.z;
            Assert.That(Vector3.Distance(Look(fluid, onFloor, Quaternion.identity).coveredPush, lift * Vector3.up), Is.LessThan(0.02f * lift));
        }

        // With a level that is known before the first answer of the water.
        static StillWater Look(FluidSimulation fluid, Vector3 center, Quaternion rotation)
        {
            float volume = 8f * Half.x * Half.y * Half.z;
            var shape = new ColliderMotion { shape = ColliderShape.Box, size = Half };
            shape.start = shape.end = new RigidPose(center, rotation);
            using (var around = new BodySurroundings(fluid))
                return around.Look(new List<BodyPart> { new BodyPart { shape = shape, volume = volume } }, 0.9f * 1000f * volume, center, true,
                    1f / 60f, Level);
        }

        FluidSimulation Fluid(Quaternion rotation)
        {
            FluidSimulation fluid = Make("Fluid").AddComponent<FluidSimulation>();
            fluid.transform.rotation = rotation;
            fluid.Configure(Vector3.one, Spacing, 100);
            fluid.gameObject.SetActive(true);
            return fluid;
        }

        GameObject Make(string name)
        {
            var thing = new GameObject(name);
            thing.SetActive(false);
            made.Add(thing);
            return thing;
        }
    }
}
