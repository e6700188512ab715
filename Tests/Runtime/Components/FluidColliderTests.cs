using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Colliders as components: where they are in a simulation's frame, how they move, what is logged of bad ones.</summary>
    [Category("LongRun")]
    public class FluidColliderTests
    {
        GameObject water;
        FluidSimulation simulation;

        [SetUp]
        public void MakeSimulation()
        {
            water = new GameObject("Water");
            water.SetActive(false);
            water.transform.SetPositionAndRotation(new Vector3(3f, 2f, -1f), Quaternion.Euler(0f, 30f, 0f));
            simulation = water.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1f, 1f, 1f), 0.05f, 4000);
            simulation.StatisticsInterval = 0;
            var volume = new GameObject("Volume").AddComponent<FluidVolume>();
            volume.transform.SetParent(water.transform, false);
            volume.transform.localPosition = new Vector3(0f, -0.25f, 0f);
            volume.Size = new Vector3(1f, 0.5f, 1f);
            water.SetActive(true);
        }

        [TearDown]
        public void DestroyAll()
        {
            foreach (FluidCollider collider in SceneColliders.Enabled.ToArray())
                Object.DestroyImmediate(collider.transform.root.gameObject);
            Object.DestroyImmediate(water);
        }

        [Test]
        public void A_collider_is_where_its_object_is_in_the_frame_of_the_domain()
        {
            FluidCollider collider = Make(ColliderShape.Box, simulation.DomainToWorld.MultiplyPoint3x4(new Vector3(4f, 6f, 8f)));
            collider.transform.rotation = water.transform.rotation * Quaternion.Euler(0f, 0f, 20f);
            collider.transform.localScale = new Vector3(0.1f, 0.2f, 0.3f);
            simulation.Advance(simulation.FixedStep);

            ColliderMotion motion = simulation.Input.colliders.Items[0];
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            Assert.That(math.distance(motion.end.position, new float3(4f, 6f, 8f)), Is.LessThan(1e-3f));
            Assert.That(math.distance(motion.size, new float3(1f, 2f, 3f)), Is.LessThan(1e-4f));
            Assert.That(Quaternion.Angle(motion.end.rotation, Quaternion.Euler(0f, 0f, 20f)), Is.LessThan(0.1f));
        }

        [Test]
        public void The_middle_of_a_shape_is_mirrored_with_its_object()
        {
            FluidCollider collider = Make(ColliderShape.Capsule, water.transform.position);
            collider.Center = new Vector3(0.1f, 0.2f, -0.1f);
            collider.transform.localScale = new Vector3(-0.5f, 0.5f, 0.5f);
            Assert.That(collider.TryDescribe(out ColliderMotion motion));
            Assert.That(math.distance(motion.end.position, collider.WorldCenter), Is.LessThan(1e-5f));
        }

        [Test]
        public void What_moves_between_two_frames_moves_over_their_steps()
        {
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position);
            simulation.Advance(simulation.FixedStep);
            collider.transform.position += water.transform.rotation * new Vector3(0.1f, 0f, 0f);
            simulation.Advance(2f * simulation.FixedStep);

            ColliderMotion motion = simulation.Input.colliders.Items[0];
            Assert.That(math.distance(motion.end.position - motion.start.position, new float3(2f, 0f, 0f)), Is.LessThan(1e-3f));
            Assert.That(simulation.Input.frameFrom, Is.EqualTo(0.5f), "the second of two steps");
        }

        // Frames at 144 Hz take a step of 1/60 s every second or third time.
        [Test]
        public void An_even_motion_is_even_in_the_steps_whatever_the_frames_are([Values(144f, 61f, 100f, 45f, 25f)] float rate)
        {
            const float speed = 0.6f, turn = 40f;      // m/s, degrees/s
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position - 0.3f * Vector3.right);
            simulation.Advance(simulation.FixedStep);
            float wanted = speed * simulation.FixedStep / 0.05f;
            var there = (int)rate;
            for (int frame = 0; frame < 2 * there; frame++)
            {
                collider.transform.position += speed / rate * (frame < there ? Vector3.right : Vector3.left);
                collider.transform.Rotate(0f, turn / rate, 0f);
                int before = simulation.StepCount;
                simulation.Advance(1f / rate);
                int steps = simulation.StepCount - before;
                if (steps == 0 || frame < 5 || math.abs(frame - there) < 5)     // where it begins, and turns back
                    continue;
                ColliderMotion motion = simulation.Input.colliders.Items[0];
                Assert.That(math.distance(motion.start.position, motion.end.position) / steps, Is.EqualTo(wanted).Within(0.01f * wanted),
                    $"frame {frame}");
                Assert.That(Quaternion.Angle(motion.start.rotation, motion.end.rotation) / steps,
                    Is.EqualTo(turn * simulation.FixedStep).Within(0.05f), $"frame {frame}");
            }

            for (int frame = 0; frame < 2 * rate / 25f + 2; frame++)
                simulation.Advance(1f / rate);
            ColliderMotion rests = simulation.Input.colliders.Items[0];
            Assert.That(rests.Moves, Is.False, "what stopped rests");
            Assert.That(rests.end.Equals(rests.seen), "where it is");
        }

        // Step rates of 40 and 80 Hz: a frame leaves 0.7 steps, and a short frame later a step of half the time is due, which ends before the
        // frame before.
        [Test]
        public void A_motion_is_even_where_steps_become_shorter_between_frames()
        {
            const float speed = 0.6f, turn = 40f, step = 1f / 40f;      // m/s, degrees/s, s
            simulation.StepRate = 40f;
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position - 0.3f * Vector3.right);
            foreach (float time in new[] { step, 1f * step, 1.7f * step, 0.1f * step })
            {
                collider.transform.position += speed * time * Vector3.right;
                collider.transform.Rotate(0f, turn * time, 0f);
                if (time < step)
                    simulation.StepRate = 80f;
                int before = simulation.StepCount;
                simulation.Advance(time);
                Assert.That(simulation.StepCount, Is.EqualTo(before + 1));
            }
            ColliderMotion motion = simulation.Input.colliders.Items[0];
            Assert.That(math.distance(motion.start.position, motion.end.position), Is.EqualTo(speed * 0.5f * step / 0.05f).Within(1e-3f), "d");
            Assert.That(Quaternion.Angle(motion.start.rotation, motion.end.rotation), Is.EqualTo(turn * 0.5f * step).Within(0.02f), "degrees");
        }

        // A frame takes 4 of 12 steps.
        [Test]
        public void Where_time_is_dropped_a_body_that_is_carried_keeps_its_velocity_and_others_their_path([Values] bool isCarried)
        {
            const float speed = 0.6f, turn = 40f;      // m/s, degrees/s
            simulation.MaxStepsPerFrame = 4;
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position);
            collider.IsCarried = isCarried;
            simulation.Advance(simulation.FixedStep);
            float time = 12f * simulation.FixedStep, seen = isCarried ? time / 3f : time;
            collider.transform.position += speed * time * Vector3.right;
            collider.transform.Rotate(0f, turn * time, 0f);
            simulation.Advance(time);
            ColliderMotion motion = simulation.Input.colliders.Items[0];
            Assert.That(math.distance(motion.start.position, motion.end.position), Is.EqualTo(speed * seen / 0.05f).Within(1e-3f), "d");
            Assert.That(Quaternion.Angle(motion.start.rotation, motion.end.rotation), Is.EqualTo(turn * seen).Within(0.05f), "degrees");
        }

        [Test]
        public void A_teleport_is_no_motion([Values] bool turns)
        {
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position);
            simulation.Advance(simulation.FixedStep);
            collider.transform.position += new Vector3(turns ? 0f : 0.1f, 0f, 0f);
            collider.transform.Rotate(0f, turns ? 30f : 0f, 0f);
            collider.Teleport();
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Input.colliders.Items[0].Moves, Is.False);
        }

        [Test]
        public void What_is_far_from_the_domain_costs_nothing()
        {
            Make(ColliderShape.Sphere, water.transform.position + new Vector3(10f, 0f, 0f));
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.Zero);
            Assert.That(simulation.Results.Describe().Single(stage => stage.Name == "Colliders").IsUsed, Is.False);
        }

        [Test]
        public void Colliders_beyond_the_limit_are_named()
        {
            for (int i = 0; i < ColliderSet.MaxCount + 2; i++)
                Make(ColliderShape.Sphere, water.transform.position).name = "Ball " + i;
            LogAssert.Expect(LogType.Error, new Regex("'Water' takes 256 colliders at a time; 2 more .* 'Ball 256' first"));
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.EqualTo(ColliderSet.MaxCount));
            simulation.Advance(simulation.FixedStep);       // logged once
        }

        [Test]
        public void What_makes_no_collider_is_named_once_and_left_out([Values("radius", "size", "field", "place")] string what)
        {
            FluidCollider collider = Make(what == "size" ? ColliderShape.Box : what == "field" ? ColliderShape.Mesh : ColliderShape.Sphere,
                water.transform.position);
            if (what == "radius")
                collider.Radius = -1f;
            if (what == "size")
                collider.Size = Vector3.zero;
            if (what == "place")
            {
                var parent = new GameObject("Parent");
                collider.transform.SetParent(parent.transform);
                collider.transform.localPosition = 10f * Vector3.one;
                parent.transform.localScale = 3e38f * Vector3.one;
            }
            LogAssert.Expect(LogType.Error, new Regex("FluidCollider 'Collider' is left out: .*("
                + (what == "place" ? "transform is not finite" : what == "field" ? "signed distance field" : what) + ")"));
            simulation.Advance(simulation.FixedStep);
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.Zero);
        }

        [Test]
        public void A_collider_can_come_go_and_change_while_the_fluid_runs()
        {
            FluidCollider first = Make(ColliderShape.Sphere, water.transform.position);
            FluidCollider second = Make(ColliderShape.Box, water.transform.position + new Vector3(0.2f, 0f, 0f));
            simulation.Advance(simulation.FixedStep);
            first.enabled = false;
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            Assert.That(simulation.Input.colliders.Items[0].shape, Is.EqualTo(ColliderShape.Box));
            Assert.That(simulation.Input.colliders.Items[0].Moves, Is.False, "another number is not a motion");
            first.enabled = true;
            second.Shape = ColliderShape.Capsule;
            simulation.Advance(simulation.FixedStep);
            Object.DestroyImmediate(second.gameObject);
            simulation.Advance(simulation.FixedStep);
            simulation.Restart();
            simulation.Advance(simulation.FixedStep);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.EqualTo(1));
        }

        [Test]
        public void The_force_on_a_collider_in_still_water_points_up()
        {
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position + new Vector3(0f, -0.25f, 0f));
            collider.Radius = 0.15f;
            collider.MeasuresForce = true;
            Assert.That(collider.TryGetForce(out _, out _), Is.False, "before the first result");
            for (int i = 0; i < 60; i++)
                simulation.Advance(simulation.FixedStep);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(collider.TryGetForce(out Vector3 force, out _), Is.True);
            Assert.That(force.y, Is.GreaterThan(3f * Mathf.Abs(force.x)));
            Assert.That(force.y, Is.GreaterThan(3f * Mathf.Abs(force.z)));
        }

        [Test]
        public void A_collider_that_is_disabled_feels_nothing_and_nothing_of_before_when_it_is_enabled_again()
        {
            FluidCollider collider = Make(ColliderShape.Sphere, water.transform.position + new Vector3(0f, -0.25f, 0f));
            collider.MeasuresForce = true;
            for (int i = 0; i < 3; i++)
                simulation.Advance(simulation.FixedStep);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(collider.TryGetForce(out Vector3 force, out _), "while it is enabled");
            Assert.That(force.magnitude, Is.GreaterThan(0f));
            simulation.Advance(simulation.FixedStep);
            collider.enabled = false;
            Assert.That(collider.TryGetForce(out force, out _), Is.False, "the last result");
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(collider.TryGetForce(out force, out _), Is.False, "what was pending");
            simulation.Advance(simulation.FixedStep);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(collider.TryGetForce(out force, out Vector3 torque), Is.False, "a step without it");
            Assert.That((force, torque), Is.EqualTo((Vector3.zero, Vector3.zero)));
            collider.enabled = true;
            Assert.That(collider.TryGetForce(out _, out _), Is.False, "of before");
            simulation.Advance(simulation.FixedStep);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(collider.TryGetForce(out _, out _), "of now");
        }

        // Forces that were known or summed are of the pose that the box had. In two steps of which nothing was read back the lump's first
        // and second layer hit; the third one does after the restore.
        [Test]
        public void A_fluid_that_is_restored_turned_tells_only_forces_of_its_own_steps()
        {
            simulation.Gravity = Vector3.zero;
            simulation.Clear();
            FluidCollider plate = Make(ColliderShape.Box, water.transform.position - 0.2f * water.transform.up);
            plate.transform.rotation = water.transform.rotation;
            plate.Size = new Vector3(0.7f, 0.1f, 0.5f);
            plate.MeasuresForce = true;
            Throw(plate.transform, new Vector3(0f, 0.05f, 0f));
            simulation.Advance(simulation.FixedStep);
            AsyncGPUReadback.WaitAllRequests();
            simulation.Advance(simulation.FixedStep);       // of which a result is pending
            simulation.Advance(simulation.FixedStep);
            FluidSnapshotRequest request = simulation.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(request.Problem, Is.Null);
            Assert.That(plate.TryGetForce(out _, out _));

            Vector3 center = water.transform.position;
            Quaternion turn = Quaternion.Euler(0f, 40f, 90f);
            plate.transform.SetPositionAndRotation(center + turn * (plate.transform.position - center), turn * plate.transform.rotation);
            water.transform.rotation = turn * water.transform.rotation;
            simulation.Restore(request.Snapshot);
            Assert.That(plate.TryGetForce(out _, out _), Is.False, "along the axes of before");
            simulation.Advance(simulation.FixedStep);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(plate.TryGetForce(out Vector3 force, out _));
            Assert.That(force.magnitude, Is.GreaterThan(1f), "N");
            Assert.That(Vector3.Angle(force, -plate.transform.up), Is.LessThan(5f), "along the axes of now");
            Assert.That(plate.Forces[0].Duration, Is.EqualTo(simulation.FixedStep).Within(1e-6f), "s, of the step since");
        }

        // A lump that hits a plate beside its center: the plate, the box of the fluid and the world have each their own axes.
        [Test]
        public void The_torque_on_a_collider_is_its_force_times_the_arm_in_world_space()
        {
            simulation.Gravity = Vector3.zero;
            simulation.Clear();
            water.transform.rotation = Quaternion.Euler(20f, 30f, 50f);
            FluidCollider plate = Make(ColliderShape.Box, water.transform.position - 0.2f * water.transform.up);
            plate.transform.rotation = water.transform.rotation * Quaternion.Euler(0f, 25f, 0f);
            plate.Size = new Vector3(0.7f, 0.1f, 0.5f);
            plate.Friction = 0f;
            plate.MeasuresForce = true;
            Transform at = plate.transform;
            Vector3 hit = new Vector3(0.2f, 0.05f, -0.1f);
            Throw(at, hit);
            Vector3 force = Vector3.zero, torque = Vector3.zero;
            for (int i = 0; i < 8; i++)
            {
                simulation.Advance(simulation.FixedStep);
                AsyncGPUReadback.WaitAllRequests();
                if (plate.TryGetForce(out Vector3 found, out Vector3 turning) && found.magnitude > force.magnitude)
                    (force, torque) = (found, turning);
            }
            Assert.That(Vector3.Angle(force, -at.up), Is.LessThan(5f), "pushed down");
            Vector3 expected = Vector3.Cross(at.rotation * hit, force);
            Assert.That(expected.magnitude, Is.GreaterThan(1f), "N m");
            Assert.That(Vector3.Distance(torque, expected), Is.LessThan(0.1f * expected.magnitude), $"{torque}, not {expected} N m");
        }

        [TestCase("Sphere", ColliderShape.Sphere)]
        [TestCase("Capsule", ColliderShape.Capsule)]
        [TestCase("Crate", ColliderShape.Box)]
        public void A_new_collider_fits_the_mesh_that_is_there(string mesh, ColliderShape shape)
        {
            FluidCollider collider = Make(ColliderShape.Box, Vector3.zero);
            ColliderFit.Fit(collider);
            Assert.That(collider.Size, Is.EqualTo(Vector3.one), "as it was: there is nothing to fit");
            var made = new Mesh { name = mesh, bounds = new Bounds(Vector3.up, new Vector3(1f, 3f, 1f)) };
            collider.gameObject.AddComponent<MeshFilter>().sharedMesh = made;
            ColliderFit.Fit(collider);
            Assert.That((collider.Shape, collider.Center, collider.Size), Is.EqualTo((shape, Vector3.up, new Vector3(1f, 3f, 1f))));
            Assert.That((collider.Radius, collider.Height), Is.EqualTo((0.5f, 3f)));
            Object.DestroyImmediate(made);
        }

        // Adds three layers of nine particles from 2 d above a point of an object, which move towards it at 3 m/s.
        void Throw(Transform at, Vector3 point)
        {
            using (var positions = new NativeArray<float3>(27, Allocator.Temp))
            using (var velocities = new NativeArray<float3>(27, Allocator.Temp))
            {
                for (int i = 0; i < 27; i++)
                {
                    var position = new Vector3(i % 3 - 1, i / 9 + 2, i / 3 % 3 - 1);
                    NativeArray<float3> points = positions, speeds = velocities;
                    points[i] = at.position + at.rotation * (point + 0.05f * position);
                    speeds[i] = at.rotation * new Vector3(0f, -3f, 0f);
                }
                simulation.AddParticles(positions, velocities);
            }
        }

        static FluidCollider Make(ColliderShape shape, Vector3 position)
        {
            var obstacle = new GameObject("Collider");
            obstacle.transform.position = position;
            var collider = obstacle.AddComponent<FluidCollider>();
            collider.Shape = shape;
            collider.Size = new Vector3(1f, 1f, 1f);
            collider.Radius = 0.1f;
            return collider;
        }
    }
}
