using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A snapshot puts floating bodies back: bodies and water go on bit for bit as those that never stopped, at a fixed frame rate
    /// whose frames are steps of the physics.</summary>
    public class FloatingSnapshotTests
    {
        const float Frame = 1f / 60f, Spacing = 0.05f, Side = 0.9f;
        const int Before = 50, After = 30, Layer = 8;

        public enum Bodies { One, ByLayer, Light, Grounded, Jointed, Several }

        readonly List<GameObject> made = new List<GameObject>();
        readonly List<Rigidbody> bodies = new List<Rigidbody>();
        FluidSimulation fluid;
        float fixedStep;

        [UnitySetUp]
        public IEnumerator AStepAFrame()
        {
            fixedStep = Time.fixedDeltaTime;
            Time.fixedDeltaTime = Frame;
            yield return PhysicsClock.Begin(Frame);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Destroy();
            Time.captureDeltaTime = 0f;
            Time.fixedDeltaTime = fixedStep;
            Time.timeScale = 1f;
            yield return null;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Restored_bodies_go_on_as_those_that_never_stopped([Values] Bodies which, [Values(DeepWater.Off, DeepWater.On)]
            DeepWater deepWater)
        {
            Make(which, deepWater);
            yield return Play(Before + 1);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            var expected = new List<float[]>();
            yield return Play(After, expected);
            Assert.That(request.Problem, Is.Null);
            Assert.That(Spread(expected), Is.GreaterThan(1e-4f), "something moves");
            yield return AssertGoesOn(request.Snapshot, expected, "in memory");
            yield return Play(1);       // between the same frames of a body that is asked for every second one
            yield return AssertGoesOn(FluidSnapshot.FromBytes(request.Snapshot.ToBytes()), expected, "from bytes");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Bodies_that_stand_in_a_pause_go_on_as_those_that_never_stopped([Values(true, false)] bool byTimeScale)
        {
            Make(Bodies.Several, DeepWater.Off);
            yield return Play(Before);
            Stop(byTimeScale);
            yield return Play(3);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Play(3);
            Go();
            var expected = new List<float[]>();
            yield return Play(After, expected);
            Stop(byTimeScale);
            yield return Play(1);
            fluid.Restore(request.Snapshot);
            yield return Play(3);
            Go();
            yield return AssertGoesOn(null, expected, "after the pause");
        }

        void Stop(bool byTimeScale)
        {
            if (byTimeScale)
                Time.timeScale = 0f;
            else
                fluid.Paused = true;
        }

        void Go()
        {
            Time.timeScale = 1f;
            fluid.Paused = false;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_box_that_was_put_elsewhere_takes_its_bodies_along()
        {
            Make(Bodies.One, DeepWater.Off);
            yield return Play(Before);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            Vector3 then = bodies[0].position, shift = new Vector3(32f, 0f, -64f);
            yield return Play(After);
            Vector3 expected = bodies[0].position;
            float submerged = bodies[0].GetComponent<FluidBuoyancy>().SubmergedFraction;
            fluid.transform.position += shift;
            bodies[0].transform.position += shift;
            fluid.Teleport();
            yield return Play(5);
            fluid.Restore(request.Snapshot);
            Assert.That((bodies[0].position - shift - then).magnitude, Is.LessThan(1e-4f));
            yield return Play(After);
            Assert.That((bodies[0].position - shift - expected).magnitude, Is.LessThan(0.01f), "it goes on floating, but for rounding");
            Assert.That(bodies[0].GetComponent<FluidBuoyancy>().SubmergedFraction, Is.EqualTo(submerged).Within(0.1f));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Bodies_that_are_gone_new_or_kinematic_are_named()
        {
            Make(Bodies.Several, DeepWater.Off);
            yield return Play(Before);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Play(4);
            Vector3 second = bodies[1].position;
            Object.DestroyImmediate(bodies[2].gameObject);
            bodies[0].isKinematic = true;
            bodies[0].gameObject.name = "Raft";
            bodies.RemoveAt(2);
            MakeBody("Buoy", new Vector3(-0.2f, 0.5f, -0.2f), 0.3f * Vector3.one, 300f);
            made[made.Count - 1].SetActive(true);
            bodies[1].position += Vector3.up;
            yield return Play(1);
            var said = new List<string>();
            Application.LogCallback hear = (text, trace, type) => said.Add(text);
            Application.logMessageReceived += hear;
            fluid.Restore(request.Snapshot);
            Application.logMessageReceived -= hear;
            foreach (string expected in new[] { "The snapshot has floating bodies that the scene has not: 'Float'",
                "Bodies that floated in the snapshot are kinematic: 'Box'", "Bodies float in the fluid that the snapshot has not: 'Buoy'" })
                Assert.That(said.Count(text => text.Contains("'Fluid' was restored. " + expected)), Is.EqualTo(1), expected);
            Assert.That(said, Has.Count.EqualTo(3));
            Assert.That(bodies[1].position, Is.Not.EqualTo(second), "where it was at the snapshot");
            yield return Play(2);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator From_bytes_bodies_of_one_name_are_told_apart_by_their_order()
        {
            Make(Bodies.Several, DeepWater.Off);
            yield return Play(Before);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            Vector3[] then = bodies.Select(body => body.position).ToArray();
            yield return Play(4);
            byte[] bytes = request.Snapshot.ToBytes();
            Destroy();
            Make(Bodies.Several, DeepWater.Off);
            yield return Play(2);
            fluid.Restore(FluidSnapshot.FromBytes(bytes));
            Assert.That(bodies.Select(body => body.position), Is.EqualTo(then));
            Assert.That(fluid.StepCount, Is.EqualTo(request.Snapshot.StepCount));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_game_can_leave_its_bodies_where_they_are()
        {
            Make(Bodies.One, DeepWater.Off);
            yield return Play(Before);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Play(After);
            Vector3 now = bodies[0].position;
            fluid.Restore(request.Snapshot, false);
            Assert.That(bodies[0].position, Is.EqualTo(now));
            yield return Play(10);
            Assert.That(bodies[0].position.y, Is.EqualTo(now.y).Within(0.1f));
        }

        // Between FixedUpdate and the step of the physics, as by SimulationMode.Script or by an impulse of the game.
        [UnityTest]
        public IEnumerator What_pushes_a_body_in_the_coming_step_is_in_the_snapshot()
        {
            Make(Bodies.One, DeepWater.Off);
            yield return Play(Before);
            bodies[0].AddForce(new Vector3(40f, 0f, 0f), ForceMode.Impulse);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Play(4);
            float expected = bodies[0].position.x;
            fluid.Restore(request.Snapshot);
            yield return Play(4);
            Assert.That(bodies[0].position.x, Is.EqualTo(expected).Within(1e-5f));
        }

        [UnityTest]
        public IEnumerator Damaged_bodies_are_refused()
        {
            Make(Bodies.Light, DeepWater.Off);
            yield return Play(Before);
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return Play(4);
            byte[] whole = SnapshotBodies.Write(request.Snapshot.Contents.Bodies);
            Assert.That(SnapshotBodies.Write(SnapshotBodies.Read(whole)), Is.EqualTo(whole));
            int refused = 0;
            for (int length = 0; length < whole.Length; length += 3)
                Assert.Throws<System.IO.InvalidDataException>(() => SnapshotBodies.Read(whole.Take(length).ToArray()), $"{length} bytes");
            for (int at = 0; at < whole.Length; at++)
                foreach (byte value in new byte[] { 0xFF, 0x7F })
                {
                    byte[] changed = whole.ToArray();
                    changed[at] = value;
                    try
                    {
                        SnapshotBodies.Read(changed);
                    }
                    catch (System.IO.InvalidDataException)
                    {
                        refused++;      // and no other exception
                    }
                }
            Assert.That(refused, Is.GreaterThan(20));
        }

        IEnumerator AssertGoesOn(FluidSnapshot snapshot, List<float[]> expected, string how)
        {
            if (snapshot != null)
                fluid.Restore(snapshot);
            var found = new List<float[]>();
            yield return Play(After, found);
            for (int frame = 0; frame < After; frame++)
                for (int i = 0; i < expected[frame].Length; i++)
                    Assert.That(found[frame][i], Is.EqualTo(expected[frame][i]), $"{how}, frame {frame}, value {i} of {expected[frame].Length}");
        }

        IEnumerator Play(int frames, List<float[]> states = null)
        {
            for (int i = 0; i < frames; i++)
            {
                yield return null;
                states?.Add(State());
            }
        }

        // State of all bodies, and of the water.
        float[] State()
        {
            var values = new List<float>();
            foreach (Rigidbody body in bodies)
            {
                Vector3 v = body.GetPointVelocity(body.worldCenterOfMass), w = body.angularVelocity, p = body.position,
                    s = body.transform.position;
                Quaternion q = body.rotation;
                values.AddRange(new[] { p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z, s.x, s.y, s.z });
            }
            var counters = new uint[1];
            fluid.Solver.Counters.GetData(counters, 0, (int)ParticleCounter.Alive, 1);
            var positions = new float4[counters[0]];
            fluid.Solver.Positions.GetData(positions);
            foreach (float4 position in positions)
                values.AddRange(new[] { position.x, position.y, position.z });
            return values.ToArray();
        }

        static float Spread(List<float[]> states)
            => states[0].Zip(states[states.Count - 1], (a, b) => Mathf.Abs(a - b)).Max();

        void Make(Bodies which, DeepWater deepWater)
        {
            fluid = MakeObject("Fluid").AddComponent<FluidSimulation>();
            fluid.transform.position = new Vector3(0f, 0.6f, 0f);
            fluid.Configure(new Vector3(Side, 1.2f, Side), Spacing, 4000);
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            fluid.Settings = settings;
            fluid.StatisticsInterval = 0;
            float depth = which == Bodies.Grounded ? 0.2f : 0.45f;
            GameObject water = MakeObject("Water");
            water.transform.SetParent(fluid.transform, false);
            water.transform.localPosition = new Vector3(0f, 0.5f * depth - 0.6f, 0f);
            water.AddComponent<FluidVolume>().Size = new Vector3(Side, depth, Side);
            switch (which)
            {
                case Bodies.One:
                    MakeBody("Box", new Vector3(0.02f, 0.6f, 0f), 0.4f * Vector3.one, 500f);
                    break;
                case Bodies.ByLayer:
                    MakeBody("Box", new Vector3(0.02f, 0.6f, 0f), 0.4f * Vector3.one, 500f, true);
                    break;
                case Bodies.Light:
                    MakeBody("Plank", new Vector3(0.02f, 0.6f, 0f), new Vector3(0.5f, 0.2f, 0.4f), 60f);
                    break;
                case Bodies.Grounded:
                    MakeBody("Boat", new Vector3(0.02f, 0.2f, 0f), 0.4f * Vector3.one, 700f);
                    bodies[0].constraints = RigidbodyConstraints.FreezePositionY;
                    break;
                case Bodies.Jointed:
                    MakeBody("Left", new Vector3(-0.2f, 0.6f, 0f), 0.3f * Vector3.one, 400f);
                    MakeBody("Right", new Vector3(0.2f, 0.6f, 0f), 0.3f * Vector3.one, 600f);
                    var hinge = bodies[0].gameObject.AddComponent<HingeJoint>();
                    hinge.connectedBody = bodies[1];
                    hinge.anchor = new Vector3(0.2f, 0f, 0f);
                    hinge.axis = Vector3.forward;
                    break;
                default:
                    MakeBody("Box", new Vector3(-0.2f, 0.6f, 0.2f), 0.3f * Vector3.one, 500f);
                    MakeBody("Box", new Vector3(0.2f, 0.6f, -0.2f), 0.3f * Vector3.one, 700f);
                    MakeBody("Float", new Vector3(0.2f, 0.55f, 0.2f), 0.3f * Vector3.one, 30f);
                    break;
            }
            for (int i = made.Count - 1; i >= 0; i--)       // the fluid after its water
                made[i].SetActive(true);
        }

        void MakeBody(string name, Vector3 at, Vector3 size, float density, bool byLayer = false)
        {
            GameObject made = MakeObject(name);
            made.transform.position = at;
            var body = made.AddComponent<Rigidbody>();
            body.interpolation = RigidbodyInterpolation.Interpolate;
            body.mass = density * size.x * size.y * size.z;
            BoxInertia.Set(body, size);
            if (byLayer)
            {
                made.layer = Layer;
                made.AddComponent<BoxCollider>().size = size;
                var colliders = fluid.gameObject.AddComponent<FluidPhysicsColliders>();
                colliders.ColliderLayers = colliders.FloatingLayers = 1 << Layer;
            }
            else
            {
                made.AddComponent<FluidCollider>().Size = size;
                made.AddComponent<FluidBuoyancy>();
            }
            bodies.Add(body);
        }

        GameObject MakeObject(string name)
        {
            var gameObject = new GameObject(name);
            gameObject.SetActive(false);
            made.Add(gameObject);
            return gameObject;
        }

        void Destroy()
        {
            foreach (GameObject thing in made)
                Object.DestroyImmediate(thing);
            made.Clear();
            bodies.Clear();
        }
    }
}
