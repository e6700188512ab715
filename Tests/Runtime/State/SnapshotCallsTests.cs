using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>What a script calls between the last step and a snapshot is in the snapshot: a fluid that is restored goes on as one that
    /// never stopped.</summary>
    public class SnapshotCallsTests
    {
        const int Before = 10, Asleep = 56, After = 6;

        public enum Call
        {
            Nothing, AddParticles, FillShape, FillVolume, RemoveInside, Clear, StartEmission, StopEmission, TeleportFluid, TeleportFluidAlone,
            TeleportCollider, TeleportEmitter, TeleportDrain, Recenter, DisableAndEnable, Pause, AddCollider, RemoveCollider, RemoveEmitter,
            RemoveDrain, RemoveField, Gravity, StartEmissionAgain
        }

        SourceScene scene;
        FluidEmitter emitter;
        FluidDrain drain;
        FluidForceField field;
        FluidCollider collider, late;
        readonly List<GameObject> made = new List<GameObject>();
        Vector3 shift, colliderShift, emitterShift, drainShift;
        int frame;
        bool stands;

        [TearDown]
        public void LeaveNothing()
        {
            foreach (GameObject thing in made)
                Object.DestroyImmediate(thing);
            made.Clear();
            scene?.Dispose();
            scene = null;
        }

        [Test]
        public void A_call_is_in_the_next_snapshot([Values] Call call)
        {
            Make(false);
            Run(Before);
            AssertGoesOn(call);
        }

        [Test]
        public void A_call_after_a_restore_is_in_the_next_snapshot([Values(Call.Nothing, Call.FillShape, Call.RemoveInside, Call.TeleportFluidAlone,
            Call.StartEmission, Call.Recenter)] Call call)
        {
            Make(false);
            Run(Before);
            FluidSnapshot first = Take();
            int at = frame;
            Run(3);
            GoTo(at);
            scene.Fluid.Restore(first);
            AssertGoesOn(call);
        }

        [Test]
        public void What_a_call_wakes_wakes_after_a_restore([Values(Call.Nothing, Call.AddParticles, Call.FillShape, Call.RemoveInside,
            Call.TeleportCollider, Call.AddCollider, Call.RemoveCollider, Call.RemoveField, Call.Gravity)] Call call, [Values] bool afterRestore)
        {
            Make(true);
            Run(Asleep);
            Assert.That(RegionStates(), Does.Contain((uint)RegionState.Asleep), "some of it sleeps");
            if (afterRestore)
                scene.Fluid.Restore(Take());
            AssertGoesOn(call);
        }

        [Test]
        public void A_box_that_has_just_begun_to_move_goes_on_as_it_did([Values(1, 2, 3)] int steps)
        {
            Make(false);
            Run(steps);
            AssertGoesOn(Call.Nothing);
        }

        [Test]
        public void What_is_removed_is_known_as_removed_after_a_restore()
        {
            Make(false);
            Run(Before);
            Do(Call.RemoveInside);
            FluidSnapshot snapshot = FluidSnapshot.FromBytes(Take().ToBytes());
            Run(1);
            scene.Fluid.Restore(snapshot);
            Assert.That(scene.Fluid.Solver.HasMarked, "until the next step, which leaves them out");
            Run(1);
            Assert.That(scene.Fluid.Solver.HasMarked, Is.False);
        }

        [Test]
        public void A_new_layout_acts_before_the_snapshot()
        {
            Make(false);
            Run(2);
            scene.Fluid.Configure(new Vector3(1f, 1f, 0.8f), 0.05f, 7000);
            Assert.That(Take().StepCount, Is.Zero, "it began again");
            Assert.That(scene.Fluid.Solver.Layout.Capacity, Is.EqualTo(7000));
        }

        void AssertGoesOn(Call call)
        {
            Do(call);
            FluidSnapshot snapshot = Take();
            int at = frame;
            Run(After);
            ParticleState expected = scene.Read();
            int steps = scene.Fluid.StepCount;
            uint[] asleep = RegionStates();
            foreach (FluidSnapshot from in new[] { snapshot, FluidSnapshot.FromBytes(snapshot.ToBytes()) })
            {
                GoTo(at);
                scene.Fluid.Restore(from);
                Run(After);
                TestFluid.AssertSame(scene.Read(), expected);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(steps));
                Assert.That(RegionStates(), Is.EqualTo(asleep));
            }
        }

        void Do(Call call)
        {
            FluidSimulation fluid = scene.Fluid;
            var up = new Vector3(0f, 0.3f, 0f);
            switch (call)
            {
                case Call.AddParticles:
                    using (var positions = new NativeArray<float3>(new[] { new float3(0f, 0.4f, 0f), new float3(0.1f, 0.4f, 0f) }, Allocator.Temp))
                    using (var velocities = new NativeArray<float3>(2, Allocator.Temp))
                        fluid.AddParticles(positions, velocities, 1, 0.05f);
                    break;
                case Call.FillShape: fluid.Fill(FluidShape.Box(fluid.transform.position + up, 0.2f * Vector3.one), Vector3.right); break;
                case Call.FillVolume:
                    FluidVolume volume = MakeObject("Volume").AddComponent<FluidVolume>();
                    volume.enabled = false;
                    volume.Size = 0.2f * Vector3.one;
                    volume.transform.position = fluid.transform.position + up;
                    fluid.Fill(volume);
                    break;
                case Call.RemoveInside: fluid.RemoveInside(FluidShape.Sphere(fluid.transform.position - up, 0.2f)); break;
                case Call.Clear: fluid.Clear(); break;
                case Call.StartEmission: emitter.StartEmission(); break;
                case Call.StopEmission: emitter.StopEmission(); break;
                case Call.StartEmissionAgain:
                    emitter.StopEmission();
                    emitter.StartEmission();
                    break;
                case Call.TeleportFluid:
                case Call.TeleportFluidAlone:
                    shift += new Vector3(3f, 0f, 0f);
                    if (call == Call.TeleportFluid)
                        colliderShift += new Vector3(3f, 0f, 0f);
                    else
                        emitterShift -= new Vector3(0.03f, 0f, 0f);
                    Move();
                    fluid.Teleport();
                    break;
                case Call.TeleportCollider:
                    colliderShift += new Vector3(0.2f, 0f, 0f);
                    Move();
                    collider.Teleport();
                    break;
                case Call.TeleportEmitter:
                    emitterShift += new Vector3(0.2f, 0f, 0f);
                    Move();
                    emitter.Teleport();
                    break;
                case Call.TeleportDrain:
                    drainShift += new Vector3(0.2f, 0f, 0f);
                    Move();
                    drain.Teleport();
                    break;
                case Call.Recenter:
                    shift += new Vector3(0.1f, 0f, 0f);
                    fluid.Recenter(PlaceOfFluid);
                    Move();
                    break;
                case Call.DisableAndEnable:
                    fluid.enabled = false;
                    colliderShift += new Vector3(0.1f, 0f, 0f);
                    Move();
                    fluid.enabled = true;
                    break;
                case Call.Pause:
                    fluid.Paused = true;
                    colliderShift += new Vector3(0.1f, 0f, 0f);
                    Move();
                    fluid.Advance(1f / 60f);
                    fluid.Paused = false;
                    break;
                case Call.AddCollider: late.gameObject.SetActive(true); break;
                case Call.RemoveCollider: collider.gameObject.SetActive(false); break;
                case Call.RemoveEmitter: emitter.enabled = false; break;
                case Call.RemoveDrain: drain.enabled = false; break;
                case Call.RemoveField: field.enabled = false; break;
                case Call.Gravity: fluid.Gravity = new Vector3(1f, -9f, 0f); break;
            }
        }

        void Make(bool sleeps)
        {
            stands = sleeps;
            frame = 0;
            shift = colliderShift = emitterShift = drainShift = Vector3.zero;
            scene = new SourceScene(new Vector3(1f, 1f, 0.8f), 0.05f, 6000);
            SolverSettings settings = scene.Fluid.Settings;
            settings.sleepSpeed = sleeps ? 0.5f : 0f;
            scene.Fluid.Settings = settings;
            collider = AddCollider("Ball");
            late = AddCollider("Late");
            late.gameObject.SetActive(false);
            late.transform.position = new Vector3(-0.2f, -0.3f, -0.1f);
            field = scene.Add<FluidForceField>(new Vector3(0.2f, -0.2f, 0f), Vector3.up, f =>
            {
                f.Kind = ForceFieldKind.Vortex;
                f.Strength = 0.2f;
            });
            if (!sleeps)
            {
                emitter = scene.Add<FluidEmitter>(new Vector3(0.1f, 0.4f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.004f;
                    e.Speed = 1.5f;
                    e.Radius = 0.1f;
                });
                drain = scene.Add<FluidDrain>(new Vector3(-0.3f, -0.4f, 0f), Vector3.forward, d =>
                {
                    d.Size = new Vector3(0.3f, 0.2f, 0.8f);
                    d.RateLimit = 0.01f;
                    d.RecycleTo = emitter;
                });
            }
            scene.Fill(0.3f);
            Move();
        }

        FluidCollider AddCollider(string name)
        {
            FluidCollider added = MakeObject(name).AddComponent<FluidCollider>();
            added.Shape = ColliderShape.Sphere;
            added.Radius = 0.12f;
            added.MeasuresForce = true;
            return added;
        }

        GameObject MakeObject(string name)
        {
            var thing = new GameObject(name);
            made.Add(thing);
            return thing;
        }

        Vector3 PlaceOfFluid => shift + (stands ? Vector3.zero : new Vector3(0.05f * math.sin(7f * frame / 60f), 0f, 0f));

        void GoTo(int toFrame)
        {
            frame = toFrame;
            Move();
        }

        void Run(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                frame++;
                Move();
                scene.Fluid.Advance(1f / 60f);
            }
        }

        void Move()
        {
            float time = stands ? 0f : frame / 60f;
            scene.Fluid.transform.position = PlaceOfFluid;
            collider.transform.position = colliderShift + new Vector3(0.25f * math.cos(4f * time), -0.3f, 0.2f * math.sin(3f * time));
            if (emitter != null)
                emitter.transform.localPosition = emitterShift + new Vector3(0.1f + 0.1f * math.sin(5f * time), 0.4f, 0f);
            if (drain != null)
                drain.transform.localPosition = drainShift + new Vector3(-0.3f + 0.1f * math.sin(5f * time), -0.4f, 0f);
        }

        uint[] RegionStates()
        {
            RestingRegions resting = scene.Fluid.Solver.Resting;
            return resting == null ? Array.Empty<uint>() : GpuTest.Read<uint>(resting.States, resting.States.count);
        }

        FluidSnapshot Take()
        {
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(request.Problem, Is.Null);
            return request.Snapshot;
        }
    }
}
