using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Drafts in deep water, against the mean level of the tank: in a lock the same setting serves water and boats.</summary>
    [Category("LongRun")]
    public class DeepDraftTests
    {
        const float Spacing = 0.05f, Density = 483f;

        readonly List<GameObject> made = new List<GameObject>();
        TankLevel tank;
        FluidSimulation fluid;
        Rigidbody body;
        float width, half;         // m: of the tank, of the body's height

        [UnitySetUp]
        public IEnumerator OneStepAFrame() => PhysicsClock.Begin(1f / 60f);

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            tank?.Dispose();
            tank = null;
            foreach (GameObject thing in made)
                Object.DestroyImmediate(thing);
            made.Clear();
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        // Over gaps of half a spacing to two, in which most of its lower face takes the level's pressure. Not held: just after it floated off, over
        // a gap of 0.3 spacings, it was 0.23 spacings too high.
        [UnityTest]
        public IEnumerator A_boat_that_floated_off_the_ground_has_its_draft()
        {
            var hull = new Vector3(0.6f, 0.3f, 0.4f);
            float draft = Density / 1000f * hull.y;
            Make(hull, Density, 0.5f * hull.y, 22, 0.9f, 3f * Spacing);
            yield return Play(15);
            int afloat = 0;
            for (int layer = 0; layer < 3; layer++)
            {
                fluid.Fill(FluidShape.Box(new Vector3(0f, tank.Mean() + 0.5f * Spacing, 0f), new Vector3(width, 1.01f * Spacing, width)));
                yield return Play(50);
                float bottom = 0f;
                yield return Average(40, () => bottom += (body.position.y - half) / 40f);
                TestContext.Out.WriteLine($"level {average / Spacing:0.00}, bottom {bottom / Spacing:0.00}, draft " +
                    $"{(average - bottom) / Spacing:0.00} of {draft / Spacing:0.00} d");
                if (bottom < 0.5f * Spacing)
                    continue;
                afloat++;
                Assert.That((average - bottom) / Spacing, Is.EqualTo(draft / Spacing).Within(0.15f), "spacings");
            }
            Assert.That(afloat, Is.GreaterThanOrEqualTo(2));
        }

        float average;      // level, m

        IEnumerator Average(int frames, System.Action eachFrame = null)
        {
            average = 0f;
            for (int i = 0; i < frames; i++)
            {
                yield return Play(1);
                eachFrame?.Invoke();
                average += tank.Mean() / frames;
            }
        }

        // On a floor: the fluid's box has none for bodies.
        IEnumerator Play(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                yield return null;
                if (body.position.y >= half)
                    continue;
                body.position = new Vector3(body.position.x, half, body.position.z);
                body.AddForce(-body.GetPointVelocity(body.worldCenterOfMass), ForceMode.VelocityChange);
            }
        }

        void Make(Vector3 size, float density, float at, int across, float high, float depth = 0f)
        {
            width = across * Spacing;
            half = 0.5f * size.y;
            fluid = MakeObject("Fluid").AddComponent<FluidSimulation>();
            fluid.transform.position = new Vector3(0f, high / 2f, 0f);
            fluid.Configure(new Vector3(width, high, width), Spacing, 12000);
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            fluid.Settings = settings;
            fluid.StatisticsInterval = 0;
            if (depth > 0f)
            {
                GameObject water = MakeObject("Water");
                water.transform.SetParent(fluid.transform, false);
                water.transform.localPosition = new Vector3(0f, (depth - high) / 2f, 0f);
                water.AddComponent<FluidVolume>().Size = new Vector3(width, depth, width);
            }
            GameObject box = MakeObject("Box");
            box.transform.position = new Vector3(0f, at, 0f);
            box.AddComponent<FluidCollider>().Size = size;
            body = box.AddComponent<Rigidbody>();
            body.mass = density * size.x * size.y * size.z;
            Vector3 squares = Vector3.Scale(size, size) * (body.mass / 12f);
            body.inertiaTensor = new Vector3(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
            body.inertiaTensorRotation = Quaternion.identity;
            body.interpolation = RigidbodyInterpolation.Interpolate;
            body.constraints = RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezePositionZ;
            box.AddComponent<FluidBuoyancy>();
            for (int i = made.Count - 1; i >= 0; i--)       // the fluid after its water
                made[i].SetActive(true);
            tank = new TankLevel(fluid, width, 0.5f * high, size);
        }

        GameObject MakeObject(string name)
        {
            var gameObject = new GameObject(name);
            gameObject.SetActive(false);
            made.Add(gameObject);
            return gameObject;
        }
    }
}
