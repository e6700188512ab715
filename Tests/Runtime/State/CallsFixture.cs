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
    /// <summary>A fluid with all that a script can call between two steps. What a test made is destroyed after it.</summary>
    public abstract class CallsFixture
    {
        protected const int Before = 10, Asleep = 56, After = 6;

        public enum Call
        {
            Nothing, AddParticles, FillShape, FillVolume, RemoveInside, Clear, StartEmission, StopEmission, TeleportFluid, TeleportFluidAlone,
            TeleportCollider, TeleportEmitter, TeleportDrain, Recenter, DisableAndEnable, Pause, AddCollider, RemoveCollider, RemoveEmitter,
            RemoveDrain, RemoveField, Gravity, StartEmissionAgain, Settings, Material, MoveCollider, TurnCollider, ResizeCollider, ChangeField
        }

        private protected SourceScene scene;
        FluidEmitter emitter;
        FluidDrain drain;
        FluidForceField field;
        protected FluidCollider collider;
        FluidCollider late;
        readonly List<GameObject> made = new List<GameObject>();
        Vector3 shift, colliderShift, emitterShift, drainShift;
        Quaternion turn = Quaternion.identity;
        protected int frame;
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

        protected void Do(Call call)
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
                    fluid.Recenter(FluidPosition);
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
                case Call.Settings:
                    SolverSettings settings = fluid.Settings;
                    settings.iterations++;
                    fluid.Settings = settings;
                    break;
                case Call.Material:
                    FluidMaterial material = fluid.Material;
                    material.velocitySmoothing = 0.3f;
                    fluid.Material = material;
                    break;
                case Call.MoveCollider:
                    colliderShift += new Vector3(0.02f, 0f, 0f);
                    Move();
                    break;
                case Call.TurnCollider:
                    turn *= Quaternion.Euler(0f, 20f, 40f);
                    Move();
                    break;
                case Call.ResizeCollider: collider.Size = new Vector3(0.3f, 0.2f, 0.1f); break;
                case Call.ChangeField: field.Strength = 2f; break;
            }
        }

        protected void Make(bool sleeps)
        {
            stands = sleeps;
            frame = 0;
            shift = colliderShift = emitterShift = drainShift = Vector3.zero;
            turn = Quaternion.identity;
            scene = new SourceScene(new Vector3(1f, 1f, 0.8f), 0.05f, 6000);
            SolverSettings settings = scene.Fluid.Settings;
            settings.sleepSpeed = sleeps ? 0.5f : 0f;
            scene.Fluid.Settings = settings;
            collider = AddCollider("Paddle");
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
            added.Shape = ColliderShape.Box;
            added.Size = new Vector3(0.25f, 0.2f, 0.15f);
            added.MeasuresForce = true;
            return added;
        }

        GameObject MakeObject(string name)
        {
            var thing = new GameObject(name);
            made.Add(thing);
            return thing;
        }

        Vector3 FluidPosition => shift + (stands ? Vector3.zero : new Vector3(0.05f * math.sin(7f * frame / 60f), 0f, 0f));

        protected void GoTo(int toFrame)
        {
            frame = toFrame;
            Move();
        }

        /// <summary>Puts all objects elsewhere in the world, without a word of it.</summary>
        protected void PutElsewhere(Vector3 by)
        {
            shift += by;
            colliderShift += by;
            Move();
        }

        /// <summary>Puts all objects where they were before calls.</summary>
        protected void GoBack()
        {
            shift = colliderShift = emitterShift = drainShift = Vector3.zero;
            turn = Quaternion.identity;
            Move();
        }

        protected void Run(int frames)
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
            scene.Fluid.transform.position = FluidPosition;
            collider.transform.rotation = turn * Quaternion.Euler(0f, 90f * time, 20f);
            collider.transform.position = colliderShift + new Vector3(0.25f * math.cos(4f * time), -0.3f, 0.2f * math.sin(3f * time));
            if (emitter != null)
                emitter.transform.localPosition = emitterShift + new Vector3(0.1f + 0.1f * math.sin(5f * time), 0.4f, 0f);
            if (drain != null)
                drain.transform.localPosition = drainShift + new Vector3(-0.3f + 0.1f * math.sin(5f * time), -0.4f, 0f);
        }

        protected uint[] RegionStates()
        {
            RestingRegions resting = scene.Fluid.Solver.Resting;
            return resting == null ? Array.Empty<uint>() : GpuTest.Read<uint>(resting.States, resting.States.count);
        }

        protected FluidSnapshot Take()
        {
            FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(request.Problem, Is.Null);
            return request.Snapshot;
        }
    }
}
