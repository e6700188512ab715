using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Particles that a box leaves behind as it moves, and finds again.</summary>
    public class OutsideParticlesTests
    {
        const float Spacing = 0.1f;

        static readonly Vector3 Box = new Vector3(1f, 1f, 0.5f);

        // Water 4 particles deep, at rest: 200.
        static SourceScene Basin(float turn = 0f)
        {
            SourceScene scene = new SourceScene(Box, Spacing, 2000).Fill(0.4f);
            scene.Fluid.transform.SetPositionAndRotation(new Vector3(12f, -2f, 5f), Quaternion.Euler(0f, turn, 0f));
            scene.Fluid.Restart();
            return scene.Step(5);
        }

        [Test]
        public void A_box_that_walks_away_and_back_finds_its_water_where_it_was([Values(0f, 35f)] float turn)
        {
            using (SourceScene scene = Basin(turn))
            {
                FluidSimulation fluid = scene.Fluid;
                fluid.Paused = true;
                Vector3 home = fluid.transform.position, along = fluid.transform.right;
                Vector3[] before = Positions(fluid);
                uint[] ids = Ids(fluid);
                for (int i = 1; i <= 6; i++)
                {
                    fluid.Recenter(home + 0.25f * i * along, LeavingParticles.Keep);
                    Assert.That(Positions(fluid).Length + Outside(fluid), Is.EqualTo(before.Length), $"in the box and outside after move {i}");
                }
                Assert.That(Positions(fluid), Is.Empty, "in a box beyond the water");
                for (int i = 5; i >= 0; i--)
                {
                    fluid.Recenter(home + 0.25f * i * along, LeavingParticles.Keep);
                    Assert.That(Positions(fluid).Length + Outside(fluid), Is.EqualTo(before.Length), $"in the box and outside after move {i} back");
                }
                Assert.That(Outside(fluid), Is.Zero);
                Vector3[] after = Positions(fluid);
                foreach (Vector3 position in before)
                    Assert.That(after.Min(other => Vector3.Distance(position, other)), Is.LessThan(0.26f * Spacing), $"something at {position}");
                Assert.That(Ids(fluid), Is.EquivalentTo(ids));
                fluid.Paused = false;
                FluidStatistics statistics = scene.Step().AssertConserved();
                Assert.That(statistics.drained, Is.Zero);
                Assert.That(statistics.handedOut, Is.EqualTo(statistics.handedIn).And.GreaterThanOrEqualTo(before.Length));
                Assert.That(statistics.coincident, Is.Zero);
            }
        }

        // In the frame of the box it went as far as the box did.
        [Test]
        public void A_collider_that_stands_in_the_world_pushes_nothing_as_the_box_moves([Values] LeavingParticles leaving)
        {
            var post = new GameObject("Post");
            try
            {
                using (SourceScene scene = Basin(0f))
                {
                    FluidSimulation fluid = scene.Fluid;
                    post.transform.position = fluid.transform.position + 0.3f * Vector3.down;
                    var collider = post.AddComponent<FluidCollider>();
                    collider.Shape = ColliderShape.Sphere;
                    collider.Radius = 0.15f;
                    fluid.Restart();
                    scene.Step(60);
                    float before = scene.Measure().speedMax;
                    fluid.Recenter(fluid.transform.position + 0.25f * Vector3.right, leaving);
                    Assert.That(scene.Step().Measure().speedMax, Is.LessThan(before + 0.5f), "m/s; it would sweep at 15");
                }
            }
            finally
            {
                Object.DestroyImmediate(post);
            }
        }

        [Test]
        public void Told_to_remove_it_finds_none()
        {
            using (SourceScene scene = Basin())
            {
                FluidSimulation fluid = scene.Fluid;
                Vector3 home = fluid.transform.position;
                fluid.Recenter(home + 1.5f * Vector3.right);
                fluid.Recenter(home);
                Assert.That(Positions(fluid), Is.Empty);
                Assert.That(scene.Step().AssertConserved().drained, Is.EqualTo(200));
            }
        }

        [Test]
        public void Beyond_its_kept_capacity_particles_are_removed_and_that_is_told_once()
        {
            using (SourceScene scene = Basin())
            {
                FluidSimulation fluid = scene.Fluid;
                fluid.KeptCapacity = 70;
                Vector3 home = fluid.transform.position;
                fluid.Recenter(home + 1.5f * Vector3.right, LeavingParticles.Keep);
                Assert.That(Outside(fluid), Is.EqualTo(70));
                LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidSimulation 'Fluid' removed 130 particles that its box left behind: its " +
                    "kept capacity of 70 is full. Raise it"));
                scene.Step(3);
                LogAssert.NoUnexpectedReceived();
                fluid.Recenter(home, LeavingParticles.Keep);
                Assert.That(Positions(fluid).Length, Is.EqualTo(70));
                FluidStatistics statistics = scene.Step().AssertConserved();
                Assert.That((statistics.drained, statistics.handedOut, statistics.handedIn), Is.EqualTo((130, 70, 70)));
            }
        }

        [Test]
        public void Water_that_comes_back_keeps_its_phase_and_a_restart_forgets_what_was_kept()
        {
            using (SourceScene scene = Basin())
            {
                FluidSimulation fluid = scene.Fluid;
                Vector3 home = fluid.transform.position;
                fluid.Clear();
                fluid.Fill(FluidShape.Box(home + 0.3f * Vector3.down, new Vector3(1f, 0.4f, 0.5f)), default, 2);
                int filled = Positions(fluid).Length;
                fluid.Recenter(home + 1.5f * Vector3.right, LeavingParticles.Keep);
                scene.Step(2);
                fluid.Recenter(home, LeavingParticles.Keep);
                Assert.That(Positions(fluid).Length, Is.EqualTo(filled).And.GreaterThan(100));
                scene.Step();
                Assert.That(GpuTest.Read<uint>(fluid.Solver.Tags, filled), Is.All.EqualTo(2u << ParticleTags.PhaseShift));
                fluid.Recenter(home + 1.5f * Vector3.right, LeavingParticles.Keep);
                fluid.Restart();
                Assert.That(fluid.KeptParticleCount, Is.Zero);
                Assert.That(fluid.Solver.KeepsOutside, Is.False);
            }
        }

        [Test]
        public void A_snapshot_without_what_is_kept_says_so()
        {
            using (SourceScene scene = Basin())
            {
                scene.Fluid.Recenter(scene.Fluid.transform.position + 0.4f * Vector3.right, LeavingParticles.Keep);
                scene.Step();
                LogAssert.Expect(LogType.Warning, new Regex("takes a snapshot without the particles that are kept outside its box"));
                scene.Fluid.RequestSnapshot();
                scene.Fluid.RequestSnapshot();
                AsyncGPUReadback.WaitAllRequests();
                LogAssert.NoUnexpectedReceived();
            }
        }

        // In world space.
        static Vector3[] Positions(FluidSimulation fluid)
        {
            Matrix4x4 toWorld = fluid.DomainToWorld;
            return TestFluid.Read(fluid.Solver).positions.Where(p => math.all(math.isfinite(p.xyz)))
                .Select(p => toWorld.MultiplyPoint3x4(p.xyz)).ToArray();
        }

        static uint[] Ids(FluidSimulation fluid)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            return state.ids.Where((_, i) => math.all(math.isfinite(state.positions[i].xyz))).ToArray();
        }

        static int Outside(FluidSimulation fluid)
        {
            AsyncGPUReadback.WaitAllRequests();
            fluid.Solver.RequestTransferred();
            AsyncGPUReadback.WaitAllRequests();
            return fluid.KeptParticleCount;
        }
    }
}
