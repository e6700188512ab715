using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A box that moves and hands what it leaves behind to another fluid.</summary>
    public class RecenterHandOverTests
    {
        const float Spacing = 0.1f;

        static readonly Vector3 Box = new Vector3(1f, 1f, 0.5f), Home = new Vector3(12f, -2f, 5f);

        SourceScene basin, lake;

        [TearDown]
        public void LeaveNothing()
        {
            basin?.Dispose();
            lake?.Dispose();
            basin = lake = null;
        }

        [Test]
        public void What_leaves_the_box_is_where_it_was_in_the_other_fluid([Values(0f, 35f)] float turn)
        {
            MakeBoth(2000, turn);
            FluidSimulation fluid = basin.Fluid, other = lake.Fluid;
            fluid.Clear();
            fluid.Fill(FluidShape.Box(Home + 0.3f * Vector3.down, new Vector3(1f, 0.4f, 0.5f)), new Vector3(0.3f, -0.2f, 0.1f), 3);
            other.Fill(FluidShape.Box(Home + new Vector3(0f, 0.8f, 0f), 0.3f * Vector3.one));
            Vector3[] before = Positions(fluid);
            int others = Positions(other).Length;
            Assert.That(before.Length, Is.GreaterThan(150));
            Assert.That(others, Is.GreaterThan(0));
            float end = Home.x + 0.6f - 0.5f * Box.x;
            fluid.Recenter(Home + 0.6f * Vector3.right, LeavingParticles.Remove, other);
            Vector3[] left = Positions(fluid), over = Positions(other);
            Assert.That(left.Length, Is.InRange(1, before.Length - 1));
            Assert.That(left.Length + over.Length, Is.EqualTo(before.Length + others));
            Assert.That(left.Min(p => p.x), Is.GreaterThan(end));
            foreach (Vector3 position in before.Where(p => p.x < end - 0.5f * Spacing))
                Assert.That(over.Min(p => Vector3.Distance(position, p)), Is.LessThan(1e-3f * Spacing), $"something at {position}");
            ParticleState state = lake.Read();
            Assert.That(state.ids.Distinct().Count(), Is.EqualTo(over.Length), "different ids");
            float3 velocity = (float3)(other.transform.rotation * (Vector3)state.velocities.Last().xyz) * Spacing;
            Assert.That(math.distance(velocity, new float3(0.3f, -0.2f, 0.1f)), Is.LessThan(1e-3f));
            Assert.That(GpuTest.Read<uint>(other.Solver.Tags, over.Length)[over.Length - 1] >> ParticleTags.PhaseShift, Is.EqualTo(3u));
            FluidStatistics given = basin.Step().AssertConserved(), taken = lake.Step().AssertConserved();
            Assert.That((given.drained, given.handedOut, taken.handedIn), Is.EqualTo((200, over.Length - others, over.Length - others)),
                "but for what was cleared, nothing is removed");
        }

        [Test]
        public void What_lies_in_neither_box_is_removed_or_kept_as_asked([Values] LeavingParticles leaving)
        {
            MakeBoth(2000);
            lake.Fluid.transform.position += 1.5f * Vector3.right;      // it begins at the center of the basin
            Vector3[] before = Positions(basin.Fluid);
            basin.Fluid.Recenter(Home + 3f * Vector3.right, leaving, lake.Fluid);
            int over = Positions(lake.Fluid).Length;
            Assert.That(over, Is.EqualTo(before.Count(p => p.x > Home.x)).Within(20).And.GreaterThan(0));
            Assert.That(Positions(basin.Fluid), Is.Empty);
            Assert.That(Outside(basin.Fluid), Is.EqualTo(leaving == LeavingParticles.Keep ? before.Length - over : 0));
            FluidStatistics given = basin.Step().AssertConserved();
            Assert.That(given.drained, Is.EqualTo(leaving == LeavingParticles.Keep ? 0 : before.Length - over));
        }

        [Test]
        public void What_finds_the_other_fluid_full_is_kept_or_removed_and_told_once([Values] LeavingParticles leaving)
        {
            MakeBoth(50);
            FluidSimulation fluid = basin.Fluid;
            fluid.Recenter(Home + 1.5f * Vector3.right, leaving, lake.Fluid);
            Assert.That(Positions(lake.Fluid).Length, Is.EqualTo(50));
            int rest = 150;
            if (leaving == LeavingParticles.Remove)
                LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidSimulation 'Fluid' removed 150 particles that its box left behind: the " +
                    "capacity of 'Lake', which was to get them, is full. Raise it, or keep them"));
            AsyncGPUReadback.WaitAllRequests();
            basin.Step(3);
            LogAssert.NoUnexpectedReceived();
            FluidStatistics given = basin.AssertConserved();
            Assert.That(given.drained, Is.EqualTo(leaving == LeavingParticles.Remove ? rest : 0));
            Assert.That(Outside(fluid), Is.EqualTo(leaving == LeavingParticles.Keep ? rest : 0));
            fluid.Recenter(Home, leaving);
            Assert.That(Positions(fluid).Length, Is.EqualTo(leaving == LeavingParticles.Keep ? rest : 0), "found again");
        }

        [Test]
        public void A_fluid_that_does_not_run_takes_nothing_and_one_that_comes_back_does()
        {
            MakeBoth(2000);
            lake.Fluid.gameObject.SetActive(false);
            basin.Fluid.Recenter(Home + 0.5f * Vector3.right, LeavingParticles.Keep, lake.Fluid);
            int kept = Outside(basin.Fluid), left = Positions(basin.Fluid).Length;
            Assert.That(kept + left, Is.EqualTo(200));
            lake.Fluid.gameObject.SetActive(true);
            Assert.That(Positions(lake.Fluid), Is.Empty);
            basin.Fluid.Recenter(Home + 1.5f * Vector3.right, LeavingParticles.Keep, lake.Fluid);
            Assert.That(Positions(lake.Fluid).Length, Is.EqualTo(left));
            Assert.That(Outside(basin.Fluid), Is.EqualTo(kept), "what was kept before stays");
        }

        [Test]
        public void A_fluid_that_cannot_take_the_particles_is_refused_with_what_to_do()
        {
            MakeBoth(2000);
            Vector3 home = basin.Fluid.transform.position;
            void Refuses(FluidSimulation to, string message)
            {
                var refusal = Assert.Throws<ArgumentException>(() =>
                    basin.Fluid.Recenter(home + Vector3.right, LeavingParticles.Remove, to));
                Assert.That(refusal.Message, Does.Contain(message));
                Assert.That(basin.Fluid.transform.position, Is.EqualTo(home));
            }
            Refuses(basin.Fluid, "cannot hand particles over to itself. Name another fluid.");
            lake.Fluid.StepRate = 120f;
            Refuses(lake.Fluid, "'Lake' 120. Make their Step Rates equal.");
            lake.Fluid.StepRate = basin.Fluid.StepRate;
            FluidMaterial material = lake.Fluid.Material;
            material.density = 900f;
            lake.Fluid.Material = material;
            Refuses(lake.Fluid, "different materials. Make them equal.");
            lake.Fluid.Configure(lake.Fluid.DomainSize, 0.05f, lake.Fluid.Capacity);
            Refuses(lake.Fluid, "'Lake' one of 0.05 m. Make them equal.");
        }

        // A basin with water 4 particles deep, 200 of them, and a larger empty fluid around it.
        void MakeBoth(int lakeCapacity, float lakeTurn = 0f)
        {
            basin = new SourceScene(Box, Spacing, 2000).Fill(0.4f);
            basin.Fluid.transform.position = Home;
            basin.Fluid.Restart();
            basin.Step(5);
            lake = new SourceScene(new Vector3(3f, 3f, 3f), Spacing, lakeCapacity);
            lake.Fluid.name = "Lake";
            lake.Fluid.transform.SetPositionAndRotation(Home, Quaternion.Euler(0f, lakeTurn, 0f));
            lake.Step();
        }

        // In world space.
        static Vector3[] Positions(FluidSimulation fluid)
        {
            Matrix4x4 toWorld = fluid.DomainToWorld;
            return TestFluid.Read(fluid.Solver).positions.Where(p => math.all(math.isfinite(p.xyz)))
                .Select(p => toWorld.MultiplyPoint3x4(p.xyz)).ToArray();
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
