using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Free bodies in a tank.</summary>
    public class FluidBuoyancyTests
    {
        FloatingScene scene;

        [SetUp]
        public void OneStepAFrame() => Time.captureDeltaTime = FloatingScene.Frame;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        [UnityTest]
        public IEnumerator Explore([Values(ColliderShape.Sphere, ColliderShape.Box)] ColliderShape shape, [Values(0.1f, 0.5f, 0.9f, 2f, 10f)] float ratio)
        {
            Vector3 size = shape == ColliderShape.Sphere ? Vector3.one * 0.4f : new Vector3(0.5f, 0.3f, 0.5f);
            scene = new FloatingScene(shape, size, ratio, (ratio > 0.7f ? 1f : 0.6f) + size.y * 0.5f, ratio > 0.7f ? 20 : 12);
            string text = $"{shape} {ratio} level {scene.Level(Mathf.Min(ratio, 1f))}\n";
            int n = int.Parse(System.Environment.GetEnvironmentVariable("FN") ?? "16");
            float dt = float.Parse(System.Environment.GetEnvironmentVariable("FDT") ?? "0.25");
            for (int i = 0; i < n; i++)
            {
                yield return scene.Play(dt);
                scene.Obstacle.TryGetForce(out Vector3 f, out Vector3 t);
                text += $"t {(i + 1) * dt:F2} y {scene.Heights.Last():F4} v {scene.Speeds.Last():F3} F {f.y / (9.81f * 1000 * scene.Volume):F3} s {scene.Buoyancy.SubmergedShare:F2} x {scene.Body.position.x:F3} z {scene.Body.position.z:F3} tilt {Vector3.Angle(scene.Body.rotation * Vector3.up, Vector3.up):F1} aw {(scene.Obstacle.Forces.Count > 0 ? scene.Obstacle.Forces[0].Motion.Acceleration.y : 0f) / 9.81f:F2} vy {scene.Body.GetPointVelocity(scene.Body.worldCenterOfMass).y:F2} amax {scene.LargestAcceleration:F1}\n";
            }
            System.IO.File.AppendAllText("/tmp/floating-trace.txt", text);
        }

        [UnityTest]
        public IEnumerator Shake([Values(ColliderShape.Sphere, ColliderShape.Box)] ColliderShape shape, [Values(DeepWater.On, DeepWater.Off)] DeepWater deep)
        {
            Vector3 size = shape == ColliderShape.Sphere ? Vector3.one * 0.4f : new Vector3(0.5f, 0.3f, 0.5f);
            scene = new FloatingScene(shape, size, 1f, 0.45f, 18, 26, deep);
            scene.Body.isKinematic = true;
            scene.Obstacle.MeasuresForce = true;
            yield return scene.Play(1f);
            string text = "";
            Transform t = scene.Body.transform;
            for (int i = 0; i < 75; i++)
            {
                float time = i / 60f;
                t.position = new Vector3(0f, 0.45f + 0.05f * Mathf.Sin(10f * time), 0f);
                yield return scene.Play(1f / 60f);
                scene.Obstacle.TryGetForce(out Vector3 f, out Vector3 q);
                text += $"{shape} {deep} {time:F3} {f.y / (9.81f * 1000 * scene.Volume):F4} {scene.Obstacle.Forces[0].Motion.Acceleration.y / 9.81f:F4} {scene.Obstacle.Forces[0].Motion.Position.y:F4} {q.magnitude/ (9.81f * 1000 * scene.Volume*0.2f):F4}\n";
            }
            System.IO.File.AppendAllText("/tmp/floating-shake.txt", text);
        }

        [UnityTest]
        public IEnumerator Rise([Values(DeepWater.On, DeepWater.Off)] DeepWater deep)
        {
            scene = new FloatingScene(ColliderShape.Sphere, Vector3.one * 0.4f, 1f, 0.3f, 12, 26, deep);
            scene.Body.isKinematic = true;
            scene.Obstacle.MeasuresForce = true;
            yield return scene.Play(1.5f);
            string text = "";
            Transform t = scene.Body.transform;
            for (int i = 0; i < 45; i++)
            {
                t.position = new Vector3(0f, 0.3f + 1.5f * Mathf.Max(0, i - 4) / 60f, 0f);
                yield return scene.Play(1f / 60f);
                scene.Obstacle.TryGetForce(out Vector3 f, out Vector3 q);
                text += $"{deep} F {f.y / (9.81f * 1000 * scene.Volume):F3} a {scene.Obstacle.Forces[0].Motion.Acceleration.y / 9.81f:F3} y {scene.Obstacle.Forces[0].Motion.Position.y:F3}\n";
            }
            System.IO.File.AppendAllText("/tmp/floating-rise.txt", text);
        }
    }
}
