using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Water that Unity's own colliders hold.</summary>
    public class PhysicsPoolTests
    {
        const int Layer = 8;
        const float Spacing = 0.05f, Inner = 0.5f, Thick = 0.1f;

        readonly List<GameObject> made = new List<GameObject>();

        [UnitySetUp]
        public IEnumerator OneStepAFrame() => PhysicsClock.Begin(1f / 60f);

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Destroy();
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        [UnityTest]
        public IEnumerator A_pool_in_box_colliders_moves_as_one_in_fluid_colliders_to_the_bit()
        {
            float4[] byLayer = null, byComponent = null;
            yield return Play(wall => wall.AddComponent<BoxCollider>(), true, state => byLayer = state);
            Destroy();
            yield return null;
            yield return Play(wall => wall.AddComponent<FluidCollider>(), false, state => byComponent = state);
            Assert.That(byLayer.Length, Is.EqualTo(600));
            Assert.That(byLayer, Is.EqualTo(byComponent));
        }

        [UnityTest]
        public IEnumerator Nothing_passes_a_sphere_or_capsule_collider_that_sweeps_through_water()
        {
            FluidSimulation fluid = Fluid(new Vector3(1f, 0.6f, 0.4f), new Vector3(1f, 0.3f, 0.4f), true);
            GameObject ball = Make("Ball", new Vector3(-0.3f, -0.15f, 0f)), bar = Make("Bar", new Vector3(0.3f, -0.1f, 0f));
            ball.AddComponent<SphereCollider>().radius = 0.12f;
            var capsule = bar.AddComponent<CapsuleCollider>();
            capsule.direction = 2;
            capsule.radius = 0.06f;
            capsule.height = 0.5f;
            for (int frame = 0; frame < 40; frame++)
            {
                ball.transform.position = new Vector3(-0.3f + 0.015f * frame, -0.15f, 0f);
                bar.transform.position = new Vector3(0.3f - 0.015f * frame, -0.1f, 0f);
                yield return null;
            }
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(2));
            float3 center = ball.transform.position, axis = bar.transform.position;
            float nearest = float.PositiveInfinity;
            foreach (float4 particle in State(fluid))
            {
                float3 position = fluid.DomainToWorld.MultiplyPoint3x4((Vector3)particle.xyz);
                nearest = math.min(nearest, math.min(math.distance(position, center) - 0.12f, math.distance(position.xy, axis.xy) - 0.06f));
            }
            // A particle keeps half a spacing from a surface; the moving one may be met within a step.
            Assert.That(nearest, Is.GreaterThan(0.25f * Spacing));
        }

        // Four walls, one of which moves.
        IEnumerator Play(Action<GameObject> makeSolid, bool byLayer, Action<float4[]> done)
        {
            FluidSimulation fluid = Fluid(new Vector3(1.2f, 0.8f, 1.2f), new Vector3(Inner, 0.3f, Inner), byLayer);
            float out0 = 0.5f * (Inner + Thick);
            GameObject mover = null;
            foreach (Vector3 side in new[] { Vector3.right, Vector3.left, Vector3.forward, Vector3.back })
            {
                mover = Make("Wall", side * out0);
                mover.transform.localScale = side.x != 0f ? new Vector3(Thick, 0.8f, Inner + 2f * Thick)
                    : new Vector3(Inner + 2f * Thick, 0.8f, Thick);
                makeSolid(mover);
            }
            for (int frame = 0; frame < 45; frame++)
            {
                mover.transform.position = Vector3.back * (out0 - 0.04f * Mathf.Sin(0.2f * frame));
                yield return null;
            }
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(4));
            float4[] state = State(fluid);
            float half = 0.5f * Inner / Spacing, center = 0.6f / Spacing;
            foreach (float4 particle in state)
                Assert.That(math.all(math.abs(particle.xz - center) < half), $"a particle is at {particle.xyz}");
            done(state);
        }

        FluidSimulation Fluid(Vector3 box, Vector3 water, bool byLayer)
        {
            var gameObject = new GameObject("Pool");
            made.Add(gameObject);
            gameObject.SetActive(false);
            var fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(box, Spacing, 2000);
            var child = new GameObject("Water");
            child.transform.SetParent(gameObject.transform, false);
            child.transform.localPosition = new Vector3(0f, 0.5f * (water.y - box.y), 0f);
            child.AddComponent<FluidVolume>().Size = water;
            if (byLayer)
                gameObject.AddComponent<FluidPhysicsColliders>().ColliderLayers = 1 << Layer;
            gameObject.SetActive(true);
            return fluid;
        }

        static float4[] State(FluidSimulation fluid)
        {
            var counters = new uint[ParticleBuffers.CounterCount];
            fluid.Solver.Counters.GetData(counters);
            var state = new float4[counters[(int)ParticleCounter.Alive]];
            fluid.Solver.Positions.GetData(state, 0, 0, state.Length);
            return state;
        }

        GameObject Make(string name, Vector3 position)
        {
            var thing = new GameObject(name) { layer = Layer };
            thing.transform.position = position;
            made.Add(thing);
            return thing;
        }

        void Destroy()
        {
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
            made.Clear();
        }
    }
}
