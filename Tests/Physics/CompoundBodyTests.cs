using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Bodies of several colliders, by layer and with a Fluid Buoyancy.</summary>
    [Category("LongRun")]
    public class CompoundBodyTests
    {
        const int Layer = 8;
        const float Spacing = FloatingScene.Spacing, Density = FloatingScene.Density;
        static readonly Vector3 BoxSize = new Vector3(0.4f, 0.3f, 0.4f);

        readonly List<GameObject> made = new List<GameObject>();
        FluidSimulation fluid;
        Rigidbody body;
        float fixedDeltaTime, meanHeight;
        Vector3 meanUp;

        public enum Split { Whole, SideBySide, OneOverTheOther }

        [UnitySetUp]
        public IEnumerator OneStepAFrame()
        {
            fixedDeltaTime = Time.fixedDeltaTime;
            Time.fixedDeltaTime = FloatingScene.Frame;      // of the physics too
            yield return PhysicsClock.Begin(FloatingScene.Frame);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Clear();
            Time.captureDeltaTime = 0f;
            Time.fixedDeltaTime = fixedDeltaTime;
            yield return null;
        }

        [UnityTest]
        public IEnumerator A_box_in_two_halves_floats_as_deep_as_the_one_box([Values(true, false)] bool byLayer)
        {
            var drafts = new float[3];
            foreach (Split split in new[] { Split.Whole, Split.SideBySide, Split.OneOverTheOther })
            {
                Tank(16, 8, byLayer);
                Body(BoxSize, 0.5f, 0.45f, byLayer, Halves(split));
                body.centerOfMass = 0.05f * Vector3.down;       // ballast: without it the metacenter lies 1.4 cm above the center of mass
                Begin();
                yield return Frames(75);
                yield return MeasurePose(45);
                drafts[(int)split] = meanHeight;
                float tilt = Vector3.Angle(meanUp, Vector3.up);
                TestContext.Out.WriteLine($"{split}: {tilt:0.0}° off upright");
                Assert.That(tilt, Is.LessThan(10f), $"{split} stays upright, but for the sway of the water");
                Clear();
                yield return null;
            }
            TestContext.Out.WriteLine(string.Join(" ", drafts.Select(draft => $"{draft:0.000}")) + " m over the floor");
            Assert.That(drafts[0], Is.InRange(0.3f, 0.5f), "afloat");
            Assert.That(drafts[1], Is.EqualTo(drafts[0]).Within(0.05f * BoxSize.y), "side by side");
            Assert.That(drafts[2], Is.EqualTo(drafts[0]).Within(0.05f * BoxSize.y), "one over the other");
        }

        // Each hull by itself is higher than wide: upright it stands by the distance between them alone.
        [UnityTest]
        public IEnumerator A_tilted_catamaran_rights_itself_and_a_single_hull_of_it_does_not([Values(true, false)] bool both)
        {
            var hull = new Vector3(0.15f, 0.3f, 0.5f);
            float apart = both ? 0.2f : 0f;
            Tank(22, 8, byLayer: true);
            var parts = new List<(Vector3, Vector3)> { (new Vector3(-apart, 0f, 0f), hull) };
            if (both)
                parts.Add((new Vector3(apart, 0f, 0f), hull));
            Body(new Vector3(0.15f + 2f * apart, 0.3f, 0.5f), 0.5f, 0.45f, true, parts.ToArray());
            body.transform.rotation = Quaternion.Euler(0f, 0f, 20f);
            body.centerOfMass = new Vector3(0f, 0.1f, 0f);
            Begin();
            yield return Frames(150);
            float tilt = Vector3.Angle(body.rotation * Vector3.up, Vector3.up);
            TestContext.Out.WriteLine($"{tilt:0.0}° off upright, {body.position.y:0.00} m over the floor");
            Assert.That(body.position.y, Is.InRange(0.2f, 0.6f), "afloat");
            Assert.That(tilt, both ? Is.LessThan(6f) : Is.GreaterThan(30f));
        }

        [UnityTest]
        public IEnumerator A_body_that_loses_a_part_floats_by_the_rest([Values(true, false)] bool byLayer)
        {
            Tank(16, 8, byLayer);
            Body(BoxSize, 0.4f, 0.43f, byLayer, Halves(Split.SideBySide));
            body.constraints = RigidbodyConstraints.FreezeRotation | RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezePositionZ;
            Begin();
            yield return Frames(75);
            yield return MeasurePose(45);
            float before = meanHeight;
            Object.Destroy(body.transform.GetChild(0).gameObject);
            yield return Frames(75);
            yield return MeasurePose(45);
            float after = meanHeight;
            TestContext.Out.WriteLine($"{before:0.000}, {after:0.000} m over the floor");
            Assert.That(before - after, Is.EqualTo(0.4f * BoxSize.y).Within(0.12f * BoxSize.y), "0.4 of its height are under water, then 0.8");
        }

        [UnityTest]
        public IEnumerator Parts_of_other_bodies_and_those_without_volume_are_left_out()
        {
            Tank(8, 4, byLayer: false);
            Body(0.2f * Vector3.one, 0.5f, 0.2f, false, (Vector3.zero, 0.2f * Vector3.one), (0.1f * Vector3.up, 0.2f * Vector3.one));
            Transform towed = body.transform.GetChild(1);
            towed.gameObject.AddComponent<Rigidbody>().isKinematic = true;
            var plane = new GameObject("Sole").AddComponent<FluidCollider>();
            plane.Shape = ColliderShape.Plane;
            plane.transform.SetParent(body.transform, false);
            plane.transform.localPosition = 100f * Vector3.down;
            LogAssert.Expect(LogType.Error, new Regex("FluidBuoyancy 'Body' leaves out 'Sole': its FluidCollider is a plane"));
            Begin();
            yield return Frames(4);
            Assert.That(towed.GetComponent<FluidCollider>().IsCarried, Is.False, "it has a body of its own");
            Assert.That(body.transform.GetChild(0).GetComponent<FluidCollider>().IsCarried, Is.True);
            Object.DestroyImmediate(towed.GetComponent<Rigidbody>());
            yield return Frames(2);
            Assert.That(towed.GetComponent<FluidCollider>().IsCarried, Is.True);
            body.GetComponent<FluidBuoyancy>().enabled = false;
            Assert.That(towed.GetComponent<FluidCollider>().IsCarried, Is.False);
        }

        static (Vector3, Vector3)[] Halves(Split split)
        {
            if (split == Split.Whole)
                return new[] { (Vector3.zero, BoxSize) };
            Vector3 axis = split == Split.SideBySide ? Vector3.right : Vector3.up;
            Vector3 half = BoxSize - 0.5f * Vector3.Scale(axis, BoxSize), off = 0.25f * Vector3.Scale(axis, BoxSize);
            return new[] { (-off, half), (off, half) };
        }

        void Tank(int side, int layers, bool byLayer)
        {
            var tank = new Vector3(side, 24, side) * Spacing;
            fluid = Make("Fluid").AddComponent<FluidSimulation>();
            fluid.transform.position = new Vector3(0f, tank.y / 2f, 0f);
            fluid.Configure(tank, Spacing, side * side * layers);
            fluid.StatisticsInterval = 0;
            var water = new GameObject("Water");
            water.transform.SetParent(fluid.transform, false);
            water.transform.localPosition = new Vector3(0f, (layers * Spacing - tank.y) / 2f, 0f);
            water.AddComponent<FluidVolume>().Size = new Vector3(tank.x, layers * Spacing, tank.z);
            if (!byLayer)
                return;
            var colliders = fluid.gameObject.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = colliders.FloatingLayers = 1 << Layer;
        }

        /// <param name="size">Of the box that has its inertia, m.</param>
        /// <param name="parts">Positions in the body's frame and sides of boxes, m; each on a child.</param>
        void Body(Vector3 size, float ratio, float height, bool byLayer, params (Vector3, Vector3)[] parts)
        {
            GameObject thing = Make("Body");
            thing.transform.position = new Vector3(0f, height, 0f);
            float volume = 0f;
            foreach ((Vector3 position, Vector3 side) in parts)
            {
                var part = new GameObject("Part") { layer = Layer };
                part.transform.SetParent(thing.transform, false);
                part.transform.localPosition = position;
                if (byLayer)
                    part.AddComponent<BoxCollider>().size = side;
                else
                    part.AddComponent<FluidCollider>().Size = side;
                volume += side.x * side.y * side.z;
            }
            body = thing.AddComponent<Rigidbody>();
            body.mass = ratio * Density * volume;
            BoxInertia.Set(body, size);
            body.interpolation = RigidbodyInterpolation.Interpolate;
            if (byLayer)
                return;
            thing.AddComponent<FluidBuoyancy>();
        }

        void Begin()
        {
            for (int i = made.Count - 1; i >= 0; i--)       // the fluid after the body
                made[i].SetActive(true);
        }

        GameObject Make(string name)
        {
            var thing = new GameObject(name);
            thing.SetActive(false);
            made.Add(thing);
            return thing;
        }

        void Clear()
        {
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
            made.Clear();
        }

        IEnumerator MeasurePose(int frames)
        {
            meanHeight = 0f;
            meanUp = Vector3.zero;
            for (int i = 0; i < frames; i++)
            {
                yield return null;
                meanHeight += body.position.y / frames;
                meanUp += body.rotation * Vector3.up / frames;
            }
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }
    }
}
