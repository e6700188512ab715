using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>A volume over a solid begins around it.</summary>
    public class CoveredVolumeTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void A_volume_leaves_out_the_solids_in_it([Values(ColliderShape.Box, ColliderShape.Sphere, ColliderShape.Capsule)] ColliderShape shape,
            [Values("still", "moving", "restart")] string what)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000, DeepWater.On))
            {
                FluidCollider solid = Solid(scene, shape);
                scene.Fill(0.6f);
                if (what == "restart")
                {
                    scene.Step(5);
                    solid.transform.localPosition += new Vector3(0.1f, 0f, 0f);
                    scene.Fluid.Restart();
                }
                float fastest = 0f;
                for (int i = 0; i < 20; i++)
                {
                    if (what == "moving")
                        solid.transform.localPosition += new Vector3(0.002f, 0f, 0f);
                    scene.Step();
                    if (i == 0)
                        AssertOutside(scene, solid);
                    fastest = math.max(fastest, scene.Read().velocities.Max(v => math.length(v.xyz)) * Spacing);
                }
                FluidStatistics statistics = scene.AssertConserved();
                TestContext.Out.WriteLine($"{statistics.particles} of {20 * 20 * 12}, added {statistics.added}, fastest {fastest:0.00} m/s");
                Assert.That(statistics.drained + statistics.nonFinite, Is.Zero, "never added");
                Assert.That(statistics.added, Is.EqualTo(statistics.particles));
                Assert.That(statistics.particles, Is.LessThan(20 * 20 * 12 - 200));
                Assert.That(fastest, Is.LessThan(1.5f), "4.5 m/s where it burst out");
            }
        }

        // Works like a script's Start.
        [Test]
        public void A_fill_before_the_first_step_leaves_out_the_solids_in_it([Values] bool afterRestart)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000))
            {
                FluidCollider solid = Solid(scene, ColliderShape.Box);
                if (afterRestart)
                {
                    scene.Step(2);
                    scene.Fluid.Restart();
                }
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0f, -0.2f, 0f), new Vector3(1f, 0.6f, 1f)));
                scene.Step();
                AssertOutside(scene, solid);
                Assert.That(scene.AssertConserved().particles, Is.InRange(3000, 20 * 20 * 12 - 200));
            }
        }

        [Test]
        public void A_volume_without_solids_keeps_every_particle_and_its_step()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000).Fill(0.6f))
            {
                scene.Step();
                Assert.That(scene.AssertConserved().particles, Is.EqualTo(20 * 20 * 12));
            }
        }

        [Test]
        public void What_scripts_add_between_is_not_left_out()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000).Fill(0.2f))
            {
                Solid(scene, ColliderShape.Box);
                scene.Step();
                int before = scene.Count(ParticleCounter.Alive);
                using (var positions = new Unity.Collections.NativeArray<float3>(1, Unity.Collections.Allocator.Persistent))
                using (var velocities = new Unity.Collections.NativeArray<float3>(1, Unity.Collections.Allocator.Persistent))
                    scene.Fluid.AddParticles(positions, velocities);
                scene.Step();
                Assert.That(scene.Count(ParticleCounter.Alive), Is.EqualTo(before + 1));
            }
        }

        [Test]
        public void A_snapshot_between_the_fill_and_the_first_step_leaves_the_solids_out_too()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 9000, DeepWater.On))
            {
                FluidCollider solid = Solid(scene, ColliderShape.Box);
                scene.Fill(0.6f);
                FluidSnapshotRequest request = scene.Fluid.RequestSnapshot();
                AsyncGPUReadback.WaitAllRequests();
                FluidSnapshot snapshot = FluidSnapshot.FromBytes(request.Snapshot.ToBytes());
                ParticleState expected = scene.Step(3).Read();
                scene.Fluid.Restore(snapshot);
                scene.Step();
                AssertOutside(scene, solid);
                TestFluid.AssertSame(scene.Step(2).Read(), expected);
            }
        }

        static FluidCollider Solid(SourceScene scene, ColliderShape shape)
        {
            var gameObject = new GameObject("Solid");
            gameObject.transform.SetParent(scene.Fluid.transform, false);
            gameObject.transform.localPosition = new Vector3(0.02f, -0.25f, 0f);
            var collider = gameObject.AddComponent<FluidCollider>();
            collider.Shape = shape;
            collider.Size = 0.36f * Vector3.one;
            collider.Radius = 0.2f;
            collider.Height = 0.5f;
            return collider;
        }

        static void AssertOutside(SourceScene scene, FluidCollider solid)
        {
            Assert.That(solid.Describe(out ColliderMotion motion), Is.Null);
            float3 center = (float3)scene.Fluid.DomainSize * 0.5f;
            Assert.That(scene.Read().positions.Min(p => Reference.Shapes.Distance(motion, p.xyz * Spacing - center)), Is.GreaterThan(0.3 * Spacing));
        }
    }
}
