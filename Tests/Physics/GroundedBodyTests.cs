using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Bodies whose faces lie against solids, where no particle comes between.</summary>
    [Category("LongRun")]
    public class GroundedBodyTests
    {
        const float Spacing = FloatingScene.Spacing, Draft = 0.145f, Side = 22 * Spacing;
        static readonly Vector3 Hull = new Vector3(0.6f, 0.3f, 0.4f);

        public enum Ground { Box, Collider, OtherBody, Slope, Heights }

        readonly List<GameObject> made = new List<GameObject>();
        HeightField heights;
        FluidSimulation fluid;
        TankLevel tank;
        Rigidbody body;
        float meanLevel;        // of the water, m
        Func<Vector3, Vector3> keepOut;     // where solids let the body be; the physics here has none

        [UnitySetUp]
        public IEnumerator OneStepAFrame() => PhysicsClock.Begin(FloatingScene.Frame);

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            tank?.Dispose();
            tank = null;
            foreach (GameObject thing in made)
                Object.Destroy(thing);
            made.Clear();
            Time.captureDeltaTime = 0f;
            yield return null;
            heights?.Dispose();
            heights = null;
        }

        // The boat becomes lighter over water that stands: filling raises the level by jumps. From gravities that differ by 1e-5 to 3e-5 it is held
        // by 0.13 to 0.19 spacings under plain iterations, each ground by 0.01 apart; in deep water by 0.07 to 0.43, up to 0.16 apart.
        [UnityTest]
        public IEnumerator A_body_on_the_ground_floats_off_at_its_draft([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater,
            [Values] Ground ground)
        {
            float top = MakeGround(ground, out float lowest);
            MakeTank(deepWater);
            MakeBoat(new Vector3(0f, top + 0.5f * Hull.y, 0f), Hull);
            body.constraints |= RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezePositionZ;
            keepOut = at => new Vector3(at.x, Mathf.Max(at.y, top + 0.5f * Hull.y), at.z);
            Begin();
            tank = new TankLevel(fluid, Side, 0.4f, Hull);
            yield return null;      // a step, so that what is filled is left out of the ground
            SetDraft(0.9f * Hull.y);
            for (float level = lowest; level < top + 0.13f; level = Mathf.Max(meanLevel, lowest))
            {
                fluid.Fill(FluidShape.Box(new Vector3(0f, level + 0.5f * Spacing, 0f), new Vector3(Side, 1.01f * Spacing, Side)));
                yield return Play(level < top ? 15 : 25);
            }
            yield return Play(45);
            float draft = meanLevel - top + 0.7f * Spacing;
            for (; Bottom - top < 0.3f * Spacing && draft > 2f * Spacing; draft -= 0.012f * Spacing)
            {
                SetDraft(draft);
                yield return Play(1);
            }
            float heldBy = meanLevel - Bottom - draft;
            SetDraft(draft -= 0.3f * Spacing);
            yield return Play(25);
            float immersed = 0f;
            for (int i = 0; i < 25; i++)
            {
                yield return Play(1);
                immersed += (meanLevel - Bottom) / 25f;
            }
            TestContext.Out.WriteLine($"level {meanLevel - top:0.000}, held by {heldBy:0.0000}, draft then {immersed:0.0000} for {draft:0.000}");
            Assert.That(heldBy, Is.EqualTo(0f).Within((deepWater == DeepWater.On ? 0.7f : 0.3f) * Spacing), "nothing but its weight holds it");
            Assert.That(immersed, Is.EqualTo(draft).Within(0.5f * Spacing), "then it floats");
        }

        [UnityTest]
        public IEnumerator A_body_at_a_wall_or_in_a_corner_is_not_held_there([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater,
            [Values(true, false)] bool inCorner)
        {
            MakeTank(deepWater);
            GameObject pier = Make("Pier");
            pier.AddComponent<FluidCollider>().Size = new Vector3(0.4f, 2f, 2f);
            float quay = -0.5f * Side + 0.1f, limit = quay + 0.5f * Hull.x, wall = -0.5f * Side + 0.5f * Hull.z;
            pier.transform.position = new Vector3(quay - 0.2f, 0.5f, 0f);
            MakeBoat(new Vector3(limit, 0.36f, inCorner ? wall : 0f), Hull);
            if (!inCorner)
                body.constraints |= RigidbodyConstraints.FreezePositionZ;
            keepOut = at => new Vector3(Mathf.Max(at.x, limit), at.y, Mathf.Max(at.z, inCorner ? wall : -1f));
            Begin();
            yield return null;
            fluid.Fill(FluidShape.Box(new Vector3(0f, 0.175f, 0f), new Vector3(Side, 0.351f, Side)));
            yield return Play(60);
            float weight = body.mass * FloatingScene.Gravity;
            for (int i = 0; i < 90; i++)
            {
                body.AddForce(0.05f * weight * new Vector3(1f, 0f, inCorner ? 1f : 0f));
                yield return Play(1);
            }
            TestContext.Out.WriteLine($"{body.position.x - limit:0.000} m off the pier, {body.position.z - wall:0.000} m off the wall");
            Assert.That(body.position.x - limit, Is.GreaterThan(Spacing), "5 % of its weight take it off");
            if (inCorner)
                Assert.That(body.position.z - wall, Is.GreaterThan(Spacing));
        }

        // Returns the height at which the boat lies on it, m.
        float MakeGround(Ground ground, out float lowest)
        {
            lowest = 0f;
            if (ground == Ground.Box)
                return 0f;
            GameObject solid = Make("Ground");
            var collider = solid.AddComponent<FluidCollider>();
            switch (ground)
            {
                case Ground.Collider:
                    collider.Size = new Vector3(2f, 1f, 2f);
                    solid.transform.position = new Vector3(0f, -0.4f, 0f);
                    return lowest = 0.1f;
                case Ground.OtherBody:
                    collider.Size = new Vector3(0.7f, 0.15f, 0.5f);
                    solid.transform.position = new Vector3(0f, 0.075f, 0f);
                    return 0.15f;
                case Ground.Slope:
                    collider.Shape = ColliderShape.Plane;
                    solid.transform.position = new Vector3(0f, 0.12f, 0f);
                    solid.transform.rotation = Quaternion.Euler(0f, 0f, 4f);
                    lowest = 0.12f;      // in the center: a layer there lies on its lower half
                    return 0.12f + Mathf.Tan(4f * Mathf.Deg2Rad) * 0.5f * Hull.x;       // its lower edge hangs over the slope
                default:
                    heights = new HeightField(new float[8, 8], 2f, 2f, new Vector3(-1f, 0f, -1f));
                    collider.Shape = ColliderShape.HeightField;
                    collider.Heights = heights;
                    solid.transform.position = new Vector3(0f, 0.1f, 0f);
                    return lowest = 0.1f;
            }
        }

        void MakeTank(DeepWater deepWater)
        {
            var tank = new Vector3(Side, 1.2f, Side);
            fluid = Make("Fluid").AddComponent<FluidSimulation>();
            fluid.transform.position = new Vector3(0f, tank.y / 2f, 0f);
            fluid.Configure(tank, Spacing, 12000);
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            fluid.Settings = settings;
            fluid.StatisticsInterval = 0;
        }

        void MakeBoat(Vector3 at, Vector3 size)
        {
            GameObject boat = Make("Boat");
            boat.transform.position = at;
            boat.AddComponent<FluidCollider>().Size = size;
            body = boat.AddComponent<Rigidbody>();
            SetDraft(Draft);
            body.constraints = RigidbodyConstraints.FreezeRotation;
            boat.AddComponent<FluidBuoyancy>();
        }

        float Bottom => body.position.y - 0.5f * Hull.y;

        void SetDraft(float draft) => body.mass = FloatingScene.Density * Hull.x * Hull.z * draft;

        void Begin()
        {
            foreach (GameObject thing in made)
                thing.SetActive(true);
        }

        IEnumerator Play(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                yield return null;
                meanLevel = tank != null ? tank.Mean() : 0f;
                Vector3 kept = keepOut(body.position);
                Vector3 moved = kept - body.position;
                if (moved == Vector3.zero)
                    continue;
                Vector3 normal = moved.normalized, velocity = body.GetPointVelocity(body.worldCenterOfMass);
                body.position = kept;
                body.AddForce(-Mathf.Min(Vector3.Dot(velocity, normal), 0f) * normal, ForceMode.VelocityChange);
            }
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
