using System;
using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Settings that a game changes while the water runs.</summary>
    public class SettingsAtRunTimeTests : PlayedFluidFixture
    {
        FluidSimulation fluid;
        int particles;

        IEnumerator Play()
        {
            fluid = Fluid("Fluid", new Vector3(0.6f, 0.6f, 0.6f), 0.05f, 1000, new Vector3(0.6f, 0.3f, 0.3f));
            yield return Frames(5);
            particles = Rill.Testing.FluidAssert.Measure(fluid).particles;
        }

        [UnityTest]
        public IEnumerator A_setting_that_is_written_in_place_is_that_of_the_struct_and_the_water_goes_on()
        {
            yield return Play();
            (string name, Action write, Func<object> inStruct, object expected)[] all =
            {
                ("iterations", () => fluid.Iterations = 2, () => fluid.Settings.iterations, 2),
                ("substeps", () => fluid.Substeps = 3, () => fluid.Settings.substeps, 3),
                ("relaxation", () => fluid.Relaxation = 0.5f, () => fluid.Settings.relaxation, 0.5f),
                ("deep water", () => fluid.DeepWater = DeepWater.On, () => fluid.Settings.deepWater, DeepWater.On),
                ("sleep speed", () => fluid.SleepSpeed = 0.02f, () => fluid.Settings.sleepSpeed, 0.02f),
                ("numerical damping", () => fluid.NumericalDamping = 0.25f, () => fluid.Settings.numericalDamping, 0.25f),
                ("viscosity", () => fluid.DynamicViscosity = 5f, () => fluid.Material.dynamicViscosity, 5f),
                ("material", () => fluid.Material = FluidMaterial.Honey, () => fluid.Material.density, 1420f),
            };
            foreach ((string name, Action write, Func<object> inStruct, object expected) in all)
            {
                int step = fluid.StepCount;
                write();
                Assert.That(inStruct(), Is.EqualTo(expected), name);
                yield return Frames(2);
                Assert.That(fluid.StepCount, Is.EqualTo(step + 2), $"{name}: it went on");
                Assert.That(Rill.Testing.FluidAssert.Measure(fluid).particles, Is.EqualTo(particles), name);
            }
            Assert.That((fluid.Iterations, fluid.Substeps, fluid.Relaxation, fluid.DeepWater, fluid.SleepSpeed, fluid.NumericalDamping),
                Is.EqualTo((2, 3, 0.5f, DeepWater.On, 0.02f, 0.25f)));
        }

        // A menu of quality levels: all that one sets, and back again.
        [UnityTest]
        public IEnumerator Another_quality_keeps_the_water()
        {
            yield return Play();
            var low = new SolverSettings
            {
                iterations = 1, substeps = 1, relaxation = 0.3f, softness = 0.01f, listMargin = 1f, neighborCapacity = 64,
                sleepSpeed = 0.01f, numericalDamping = 1f, deepWater = DeepWater.On
            };
            foreach (SolverSettings settings in new[] { low, SolverSettings.Default, low })
            {
                int step = fluid.StepCount;
                fluid.Settings = settings;
                yield return Frames(3);
                Assert.That(fluid.StepCount, Is.EqualTo(step + 3));
                FluidStatistics now = Rill.Testing.FluidAssert.Measure(fluid);
                Assert.That((now.particles, now.refused), Is.EqualTo((particles, 0)));
                Assert.That(now.speedMax, Is.LessThan(3f), "no burst");
            }
        }

        [UnityTest]
        public IEnumerator A_value_out_of_range_is_clamped_and_said_once()
        {
            yield return Play();
            LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': iterations 99 is outside 1 to 50"));
            fluid.Iterations = 99;
            Assert.That(fluid.Iterations, Is.EqualTo(50));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_budget_chooses_within_its_own_bounds_and_leaves_the_iterations_of_the_settings_alone()
        {
            yield return Play();
            fluid.Iterations = 20;
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            budget.minIterations = 2;
            budget.maxIterations = 4;
            fluid.Steps.Budget.TimeSource = new Unhurried();
            fluid.Budget = budget;
            yield return Frames(5);
            Assert.That(fluid.BudgetState.iterations, Is.InRange(2, 4));
            fluid.Iterations = 30;
            yield return Frames(5);
            Assert.That(fluid.BudgetState.iterations, Is.InRange(2, 4), "not those of the settings");
            Assert.That(fluid.Iterations, Is.EqualTo(30));
            budget.mode = BudgetMode.Off;
            fluid.Budget = budget;
            yield return Frames(1);
            Assert.That((fluid.Iterations, fluid.BudgetState.iterations), Is.EqualTo((30, 0)), "back to the settings");
            Assert.That(Rill.Testing.FluidAssert.Measure(fluid).particles, Is.EqualTo(particles));
        }

        // A GPU that always takes half a millisecond.
        sealed class Unhurried : IGpuTimeSource
        {
            public GpuTimeKind Kind => GpuTimeKind.Measured;
            public StepTime Read(float seconds, WorkHistory work) => new StepTime(0.5f, 0.5f);
            public void BeginStep(UnityEngine.Rendering.CommandBuffer commands) { }
            public void EndStep(UnityEngine.Rendering.CommandBuffer commands) { }
            public void Dispose() { }
        }
    }
}
