using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>A small fluid with one of each that acts on it or draws it. It is the same in play and in edit mode.</summary>
    sealed class EditModeScene
    {
        public readonly FluidSimulation Fluid;
        public readonly FluidVolume Volume;
        public readonly FluidEmitter Emitter;
        public readonly FluidCollider Collider;

        /// <param name="plays">In play mode rather than in edit mode.</param>
        /// <param name="surface">Drawn as a surface too.</param>
        public EditModeScene(bool plays = false, int capacity = 2000, bool surface = true)
        {
            EditMode.IsOn = !plays;
            var root = new GameObject("Fluid");
            root.SetActive(false);
            Fluid = root.AddComponent<FluidSimulation>();
            Fluid.Configure(new Vector3(1f, 1f, 0.8f), 0.1f, capacity);
            root.AddComponent<ParticleRenderer>();
            if (surface)
                root.AddComponent<FluidSurface>();
            Volume = Add<FluidVolume>(new Vector3(-0.2f, -0.2f, 0f), Vector3.forward);
            Volume.Size = new Vector3(0.5f, 0.6f, 0.8f);
            Emitter = Add<FluidEmitter>(new Vector3(0.3f, 0.4f, 0f), Vector3.down);
            Emitter.Radius = 0.15f;
            Emitter.Rate = 0.02f;
            Add<FluidDrain>(new Vector3(0.4f, -0.45f, 0f), Vector3.forward).Size = new Vector3(0.2f, 0.1f, 0.8f);
            Add<FluidForceField>(Vector3.zero, Vector3.right).Strength = 1f;
            Collider = Add<FluidCollider>(new Vector3(0.2f, -0.3f, 0f), Vector3.forward);
            Collider.Shape = ColliderShape.Sphere;
            Collider.Radius = 0.2f;
            root.SetActive(true);
            PlayerLoop.Frame(0f);       // the scene is open
        }

        T Add<T>(Vector3 position, Vector3 forward) where T : Component
        {
            var child = new GameObject(typeof(T).Name);
            child.transform.SetParent(Fluid.transform, false);
            child.transform.position = position;
            child.transform.rotation = Quaternion.LookRotation(forward, forward == Vector3.down ? Vector3.right : Vector3.up);
            return child.AddComponent<T>();
        }

        /// <summary>Begins to simulate it without Play, which must succeed; paused, so that a test gives the time.</summary>
        public SceneSimulation Simulate()
        {
            SceneSimulation.Start(Fluid);
            Assert.That(SceneSimulation.Problem, Is.Null);
            SceneSimulation.Current.IsPaused = true;
            return SceneSimulation.Current;
        }

        /// <summary>Takes fixed steps without Play, one to an update of the editor.</summary>
        public static void Step(int count)
        {
            for (int i = 0; i < count; i++)
            {
                SceneSimulation.Current.Step();
                EditorTick.Run();
            }
        }

        /// <summary>Takes fixed steps in play mode, one to a frame.</summary>
        public static void Play(int count)
        {
            for (int i = 0; i < count; i++)
                PlayerLoop.Frame(1f / 60f);
        }

        /// <summary>Reads all particles in the order of the buffers: position and velocity, spacings, and id.</summary>
        public static List<(float4 position, float4 velocity, uint id)> Particles(FluidSimulation fluid)
        {
            PbfSolver solver = fluid.Solver;
            int count = (int)Read<uint>(solver.Counters, solver.Counters.count)[(int)ParticleCounter.Alive];
            float4[] positions = Read<float4>(solver.Positions, count), velocities = Read<float4>(solver.Velocities, count);
            uint[] ids = Read<uint>(solver.ParticleIds, count);
            return Enumerable.Range(0, count).Select(i => (positions[i], velocities[i], ids[i])).ToList();
        }

        static T[] Read<T>(GraphicsBuffer buffer, int count) where T : struct
        {
            var read = new T[count];
            buffer.GetData(read);
            return read;
        }

        /// <summary>All that the scene would store, and how often it was marked as changed.</summary>
        public static List<string> Stored()
        {
            var stored = new List<string>();
            foreach (Transform at in Resources.FindObjectsOfTypeAll<Transform>())
            {
                stored.Add($"{at.name} {at.gameObject.activeSelf} {at.localPosition} {at.localRotation} {at.localScale}");
                foreach (MonoBehaviour script in at.GetComponents<MonoBehaviour>())
                {
                    int marks = EditorUtility.GetDirtyCount(script);
                    stored.Add($"{script.GetType().Name} {script.enabled} {JsonUtility.ToJson(script)} {marks}");
                }
            }
            return stored;
        }
    }
}
