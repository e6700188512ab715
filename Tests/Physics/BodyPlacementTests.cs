using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A body goes along with a box that moved and turned since a snapshot: pose, motion, and what acts on it.</summary>
    public class BodyPlacementTests
    {
        static readonly Vector3 Position = new Vector3(0.3f, -0.2f, 0.5f), Velocity = new Vector3(0.4f, 0.1f, -0.6f),
            Spin = new Vector3(-0.5f, 0.7f, 0.2f), Force = new Vector3(3f, -1f, 2f), Torque = new Vector3(-2f, 4f, 1f);
        static readonly Quaternion Rotation = Quaternion.Euler(10f, 50f, -30f);

        Rigidbody body;

        [SetUp]
        public void MakeABody()
        {
            body = GameObject.CreatePrimitive(PrimitiveType.Cube).AddComponent<Rigidbody>();
            body.useGravity = false;
        }

        [TearDown]
        public void LeaveNone() => Object.DestroyImmediate(body.gameObject);

        [Test]
        public void A_body_turns_along_with_a_box_in_pose_motion_and_what_acts_on_it([Values] bool isTurned)
        {
            BodyRecord record = Saved();
            var from = new RigidPose(new float3(1f, 2f, 3f), Quaternion.Euler(0f, 20f, 0f));
            Quaternion turn = isTurned ? Quaternion.Euler(0f, 90f, 30f) : Quaternion.identity;
            var to = new RigidPose(new float3(-4f, 0f, 8f), turn * (Quaternion)from.rotation);
            body.rotation = Quaternion.identity;
            body.angularVelocity = Vector3.one;
            Assert.That(BodyPlacement.Restore(body, record, new BoxMotion(from, to)));
            BodyRecord placed = default;
            BodyPlacement.Save(body, ref placed);
            Vector3 position = (Vector3)to.position + turn * (Position - (Vector3)from.position);
            AssertNear(placed.pose.position, position, "m");
            AssertNear(placed.shown.position, position, "m, of the object");
            AssertSame(placed.pose.Pose.rotation, turn * Rotation, "of the body");
            AssertSame(placed.shown.Pose.rotation, turn * Rotation, "of the object");
            AssertNear(placed.velocity, turn * Velocity, "m/s");
            AssertNear(placed.angularVelocity, turn * Spin, "rad/s");
            AssertNear(placed.force, turn * Force, "N");
            AssertNear(placed.torque, turn * Torque, "N m");
        }

        // A body whose object is shown between two steps of the physics.
        [Test]
        public void A_body_and_the_object_that_stays_behind_it_keep_their_own_poses()
        {
            BodyRecord record = Saved();
            Quaternion behind = Quaternion.Euler(5f, 45f, -28f);
            body.transform.SetPositionAndRotation(Position - 0.1f * Vector3.right, behind);
            UnityEngine.Physics.SyncTransforms();
            body.position = Position;
            body.rotation = Rotation;
            BodyPlacement.Save(body, ref record);
            BodyPlacement.Restore(body, record, new BoxMotion(new RigidPose(0f, quaternion.identity), new RigidPose(0f, quaternion.identity)));
            AssertNear(body.transform.position, Position - 0.1f * Vector3.right, "m, of the object");
            AssertSame(body.transform.rotation, behind, "of the object");
            AssertNear(body.position, Position, "m");
            AssertSame(body.rotation, Rotation, "of the body");
        }

        [Test]
        public void A_body_that_sleeps_sleeps_again_and_nothing_acts_on_it()
        {
            BodyRecord record = Saved();
            record.flags = BodyRecord.Sleeps;
            BodyPlacement.Restore(body, record, new BoxMotion(new RigidPose(0f, quaternion.identity), new RigidPose(0f, quaternion.identity)));
            Assert.That(body.IsSleeping());
            Assert.That((body.GetAccumulatedForce(), body.GetAccumulatedTorque()), Is.EqualTo((Vector3.zero, Vector3.zero)));
        }

        BodyRecord Saved()
        {
            body.transform.SetPositionAndRotation(Position, Rotation);
            UnityEngine.Physics.SyncTransforms();
            body.angularVelocity = Spin;
            body.AddForce(Velocity, ForceMode.VelocityChange);
            UnityEngine.Physics.simulationMode = SimulationMode.Script;
            UnityEngine.Physics.Simulate(1e-4f);
            UnityEngine.Physics.simulationMode = SimulationMode.FixedUpdate;
            body.position = Position;
            body.rotation = Rotation;
            body.transform.SetPositionAndRotation(Position, Rotation);
            body.angularVelocity = Spin;
            body.AddForce(Force);
            body.AddTorque(Torque);
            BodyRecord record = default;
            BodyPlacement.Save(body, ref record);
            AssertNear(record.angularVelocity, Spin, "rad/s");
            AssertNear(record.velocity, Velocity, "m/s");
            AssertNear(record.force, Force, "N");
            AssertNear(record.torque, Torque, "N m");
            return record;
        }

        static void AssertSame(Quaternion found, Quaternion expected, string what)
            => Assert.That(Mathf.Abs(Quaternion.Dot(found, expected)), Is.GreaterThan(1f - 1e-6f), $"{what}: {found}, not {expected}");

        static void AssertNear(Vector3 found, Vector3 expected, string unit)
            => Assert.That(Vector3.Distance(found, expected), Is.LessThan(1e-3f), $"{found}, not {expected} {unit}");
    }
}
