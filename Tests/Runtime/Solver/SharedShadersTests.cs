using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Fluids have their kernels in common, and each leaves them on its own variants: no fluid finds those of another.</summary>
    public class SharedShadersTests
    {
        const float Spacing = 0.05f;
        const int Steps = 3, StepsToSleep = 32;     // of what is slower than the sleep speed for half a second

        public enum Kind { Densities, Asleep, TwoLists, Deep, Balls }

        [Test]
        public void A_plain_fluid_and_one_of_another_kind_do_by_turns_what_each_does_alone([Values] Kind kind)
        {
            using (TestFluid plainAlone = Make(null), plain = Make(null))
            {
                for (int step = 0; step < Steps; step++)
                    Add(plainAlone, step).Step();       // before the other kind's first step
                using (TestFluid otherAlone = Make(kind), other = Make(kind))
                {
                    int before = kind == Kind.Asleep ? StepsToSleep : 0;
                    otherAlone.Step(before + Steps);
                    other.Step(before);
                    for (int step = 0; step < Steps; step++)
                    {
                        other.Step();
                        Add(plain, step).Step();
                    }
                    if (kind == Kind.Asleep)
                        Assert.That(GpuTest.Read<uint>(other.Solver.Resting.States, 1), Is.All.EqualTo((uint)RegionState.Asleep));
                    TestFluid.AssertSame(plain.Read(), plainAlone.Read());
                    TestFluid.AssertSame(other.Read(), otherAlone.Read());
                    if (kind == Kind.Densities)
                        Assert.That(Tags(other), Is.EqualTo(Tags(otherAlone)));
                }
                TestFluid.AssertSame(plain.Step().Read(), plainAlone.Step().Read());        // without the other's buffers
            }
        }

        static TestFluid Make(Kind? kind)
        {
            SolverSettings settings = SolverStages.Roomy;
            settings.deepWater = kind == Kind.Deep ? DeepWater.On : DeepWater.Off;
            settings.sleepSpeed = kind == Kind.Asleep ? 10f : 0f;
            var fluid = new TestFluid(new float3(20f, 16f, 8f) * Spacing, Spacing, 1000, settings, kind == Kind.TwoLists ? 96 * 4 * 512 : 0);
            fluid.Input.material.contacts = kind == Kind.Balls;
            if (kind == Kind.Densities)
            {
                fluid.Input.phases.Set(1, 500f, 0f);
                fluid.AddPhase(1, ParticleState.Lattice(0f, 0.5f, 8, 0.1f).positions.Select(p => p.xyz));
                return fluid.AddBlock(new float3(8f, 0f, 0f) * Spacing, 7f * Spacing);
            }
            if (kind == Kind.Asleep)
                return fluid.AddBlock(0f, new float3(8f, 4f, 8f) * Spacing);
            return fluid.AddBlock(0f, 8f * Spacing, new float3(1f, 0f, 0f));
        }

        // The upload has a variant too.
        static TestFluid Add(TestFluid fluid, int step)
            => fluid.Add(new[] { new float3(3f + step, 12f, 4f) * Spacing, new float3(4f, 14f, 3f + step) * Spacing });

        static uint[] Tags(TestFluid fluid) => GpuTest.Read<uint>(fluid.Solver.Tags, fluid.Alive);
    }
}
