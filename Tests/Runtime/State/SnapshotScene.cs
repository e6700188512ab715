using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A fluid with all that acts on it, whose objects are where a step of the script has them: another made likewise does the
    /// same.</summary>
    sealed class SnapshotScene : IDisposable
    {
        const float Step60 = 1f / 60f;

        readonly SourceScene scene;
        readonly List<GameObject> colliders = new List<GameObject>();
        readonly SnapshotCase made;
        FluidMaterialAsset oil;
        int frame;

        public SnapshotScene(SnapshotCase made)
        {
            this.made = made;
            scene = new SourceScene(new Vector3(1f, 1f, 0.8f), 0.05f, 6000, made.deepWater);
            SolverSettings settings = scene.Fluid.Settings;
            settings.substeps = made.substeps;
            settings.sleepSpeed = made.sleepSpeed;
            settings.numericalDamping = made.numericalDamping;
            scene.Fluid.Settings = settings;
            scene.Fluid.StatisticsInterval = made.draws ? 2 : 0;
            FluidMaterial material = scene.Fluid.Material;
            material.dynamicViscosity = made.dynamicViscosity;
            material.shearModulus = made.shearModulus;
            material.relaxationTime = 0.5f;
            material.frictionAngle = made.frictionAngle;
            material.vorticity = made.vorticity;
            material.contacts = made.contacts;
            scene.Fluid.Material = material;
            if (made.colliders)
            {
                AddCollider(ColliderShape.Sphere);
                AddCollider(ColliderShape.Box);
            }
            if (made.density > 0f)
                scene.Fluid.PhaseMaterials = new[] { null, oil = FluidMaterialAsset.Create("Oil", made.density, made.dynamicViscosity) };
            if (made.diffusion > 0f)
                scene.Fluid.MaterialPairs = new[] { FluidMaterialPair.Mixing(oil, null, made.diffusion) };
            FluidEmitter emitter = null;
            if (made.emitter)
                emitter = scene.Add<FluidEmitter>(new Vector3(0.1f, 0.4f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.004f;
                    e.Speed = 1.5f;
                    e.Radius = 0.1f;
                    e.Phase = 2;
                    e.Lifetime = 0.25f;
                });
            if (made.drain)
                scene.Add<FluidDrain>(new Vector3(-0.3f, -0.4f, 0f), Vector3.forward, d =>
                {
                    d.Size = new Vector3(0.3f, 0.2f, 0.8f);
                    d.RateLimit = 0.01f;
                    d.RecycleTo = emitter;
                });
            if (made.field)
                scene.Add<FluidForceField>(new Vector3(0.2f, -0.2f, 0f), Vector3.up, f =>
                {
                    f.Kind = ForceFieldKind.Vortex;
                    f.Strength = 0.2f;
                });
            scene.Fill(made.depth);
            Move();
        }

        public FluidSimulation Fluid => scene.Fluid;

        public int Count(ParticleCounter counter) => scene.Count(counter);

        /// <summary>Frames as they come, not of a step each; objects move in each.</summary>
        public SnapshotScene Run(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                frame++;
                Move();
                if (made.draws)
                {
                    Fluid.Steps.NeedsFoam = FoamSettings.Default;
                    Fluid.Results.Surface.IsNeeded = true;
                }
                Fluid.Advance(made.FrameTime(frame));
            }
            return this;
        }

        /// <summary>Puts the objects where they are in a frame.</summary>
        public SnapshotScene GoTo(int toFrame)
        {
            frame = toFrame;
            Move();
            return this;
        }

        public int Frame => frame;

        public ParticleState Read() => scene.Read();

        public uint[] RegionStates()
        {
            GraphicsBuffer states = Fluid.Solver.Resting.States;
            return GpuTest.Read<uint>(states, states.count);
        }

        /// <summary>Waits for the device, as only a test does.</summary>
        public FluidSnapshot Take()
        {
            FluidSnapshotRequest request = Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(request.IsDone, "it has come");
            Assert.That(request.Problem, Is.Null);
            return request.Snapshot;
        }

        public void Dispose()
        {
            foreach (GameObject collider in colliders)
                Object.DestroyImmediate(collider);
            scene.Dispose();
            if (oil != null)
                Object.DestroyImmediate(oil);
        }

        void AddCollider(ColliderShape shape)
        {
            var made = new GameObject(shape.ToString());
            colliders.Add(made);
            FluidCollider collider = made.AddComponent<FluidCollider>();
            collider.Shape = shape;
            collider.Radius = 0.12f;
            collider.Size = 0.2f * Vector3.one;
            collider.Friction = 0.3f;
            collider.MeasuresForce = true;
        }

        void Move()
        {
            float time = made.stands ? 0f : frame * Step60;
            for (int i = 0; i < colliders.Count; i++)
            {
                colliders[i].transform.position = new Vector3(0.25f * math.cos(4f * time + 2f * i), -0.3f + 0.1f * i, 0.2f * math.sin(3f * time));
                colliders[i].transform.rotation = Quaternion.Euler(0f, 90f * time, 30f * i);
            }
            if (made.moves)
            {
                Fluid.transform.position = new Vector3(0.05f * math.sin(7f * time), 0f, 0f);
                Fluid.transform.rotation = Quaternion.Euler(0f, 0f, 6f * math.sin(5f * time));
            }
        }
    }

    /// <summary>Content of a scene of a snapshot test.</summary>
    public sealed class SnapshotCase
    {
        public string name;
        public DeepWater deepWater = DeepWater.Off;
        public int substeps = 1;
        public float depth = 0.3f, sleepSpeed, numericalDamping = 1f, dynamicViscosity, shearModulus, vorticity, frictionAngle,
            frameSteps = 1f, density, diffusion;
        public bool contacts, colliders, emitter, drain, field, moves, stands, draws;
        public int steps = 12;

        /// <summary>s; frames that are not whole steps differ from each other, too.</summary>
        public float FrameTime(int frame) => frameSteps == 1f ? 1f / 60f : frameSteps / 60f * (1f + 0.3f * (frame % 3));

        public override string ToString() => name;
    }
}
