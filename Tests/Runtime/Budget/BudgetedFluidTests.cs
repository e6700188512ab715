using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A playing fluid under a budget, with a source of time that the test holds.</summary>
    public class BudgetedFluidTests
    {
        const int Second = 60;

        readonly List<GameObject> made = new List<GameObject>();
        readonly List<string> warnings = new List<string>();

        [SetUp]
        public void OneStepAFrame()
        {
            Time.captureDeltaTime = 1f / Second;
            warnings.Clear();
            Application.logMessageReceived += Hear;
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Application.logMessageReceived -= Hear;
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
            made.Clear();
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        [UnityTest]
        public IEnumerator The_settings_follow_the_load_within_a_second_and_go_back_when_the_budget_is_switched_off()
        {
            // ms of a step of so few particles at this factor: 1.1, 1.38, 1.66, 1.95 for 2, 4, 6, 8 iterations.
            var time = new HeldTime { Factor = 20f };
            FluidSimulation fluid = Dam(time, Milliseconds(1.86f));
            SolverSettings asked = fluid.Settings;
            yield return Frames(Second);
            Assert.That(Used(fluid), Is.EqualTo("1 x 6"));
            Assert.That(fluid.BudgetState.reason, Is.EqualTo(BudgetReason.TimeIsSpent));
            Assert.That(fluid.BudgetState.source, Is.EqualTo(GpuTimeKind.Measured));
            Assert.That(fluid.BudgetState.milliseconds, Is.EqualTo(1.66f).Within(3).Percent);
            Assert.That(fluid.BudgetState.iterations, Is.EqualTo(6));

            time.Factor = 33f;
            yield return Frames(Second);
            Assert.That(Used(fluid), Is.EqualTo("1 x 2"));
            Assert.That(fluid.BudgetState.milliseconds, Is.LessThanOrEqualTo(1.86f * 1.1f));

            time.Factor = 20f;
            yield return Frames(Second);
            Assert.That(Used(fluid), Is.EqualTo("1 x 6"));

            fluid.Budget = SolverBudget.Default;
            yield return null;
            Assert.That(fluid.Input.settings, Is.EqualTo(asked));
            Assert.That(fluid.Settings, Is.EqualTo(asked));
            Assert.That(fluid.BudgetState.reason, Is.EqualTo(BudgetReason.Off));
            Assert.That(time.IsDisposed);
        }

        // Uses the same device as above, which takes 1.1 ms with 2 iterations and 1.66 with 6: the stretch costs in addition,
        // 0.54 ms at this factor.
        [UnityTest]
        public IEnumerator What_an_elastic_fluid_costs_is_known()
        {
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, Milliseconds(1.7f), MakeElastic);
            yield return Frames(Second);
            Assert.That(Used(fluid), Is.EqualTo("1 x 2"));
            Assert.That(fluid.BudgetState.milliseconds, Is.EqualTo(1.64f).Within(3).Percent);
        }

        // With fewer it would be softer.
        [UnityTest]
        public IEnumerator An_elastic_fluid_keeps_its_substeps_as_far_as_the_bounds_let_it()
        {
            SolverBudget budget = Milliseconds(1.7f), bounded = budget;
            bounded.maxSubsteps = 2;
            FluidSimulation free = Dam(new HeldTime { Factor = 20f }, budget, Elastic), bound = Dam(new HeldTime { Factor = 20f }, bounded, Elastic);
            yield return Frames(Second);
            Assert.That(Used(free), Is.EqualTo("3 x 2"));
            Assert.That(Used(bound), Is.EqualTo("2 x 2"));

            void Elastic(FluidSimulation fluid)
            {
                MakeElastic(fluid);
                SolverSettings settings = fluid.Settings;
                settings.substeps = 3;
                fluid.Settings = settings;
            }
        }

        [UnityTest]
        public IEnumerator Without_a_known_time_the_fluid_runs_as_it_was_set_bit_for_bit()
        {
            FluidSimulation fluid = Dam(new HeldTime(), Milliseconds(0.1f)), plain = Dam(null, SolverBudget.Default);
            yield return Frames(20);
            TestFluid.AssertSame(TestFluid.Read(fluid.Solver), TestFluid.Read(plain.Solver));
            Assert.That(fluid.BudgetState.reason, Is.EqualTo(BudgetReason.TimeUnknown));
            Assert.That(fluid.BudgetState.iterations, Is.EqualTo(plain.Settings.iterations));
            Assert.That(warnings, Is.Empty);
        }

        [UnityTest]
        public IEnumerator A_budget_that_cannot_be_met_keeps_the_least_stable_settings_and_says_so_once_by_name()
        {
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, Milliseconds(0.5f));
            yield return Frames(2 * Second);
            Assert.That(Used(fluid), Is.EqualTo("1 x 2"));
            Assert.That(fluid.BudgetState.reason, Is.EqualTo(BudgetReason.MinStable));
            Assert.That(warnings, Has.Count.EqualTo(1));
            Assert.That(warnings[0], Does.Contain("FluidSimulation 'Budgeted'").And.Contain("budget of 0.5 ms").And.Contain(
                "1 substeps x 2 iterations"));
        }

        [UnityTest]
        public IEnumerator Another_budget_that_cannot_be_met_is_told_too_and_the_same_one_is_not()
        {
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, Milliseconds(0.5f));
            yield return Frames(2 * Second);
            Assert.That(warnings, Has.Count.EqualTo(1));
            fluid.Budget = Milliseconds(0.5f);
            yield return Frames(Second);
            Assert.That(warnings, Has.Count.EqualTo(1), "the same");
            fluid.Budget = Milliseconds(0.4f);
            yield return Frames(Second);
            Assert.That(warnings, Has.Count.EqualTo(2), "another time");
            SolverBudget fraction = Milliseconds(0.4f);
            fraction.mode = BudgetMode.FrameFraction;
            fraction.fraction = 0.024f;     // of 16.7 ms
            Assert.That(fraction.FrameMilliseconds, Is.EqualTo(0.4f).Within(1e-6f));
            fluid.Budget = fraction;
            yield return Frames(Second);
            Assert.That(warnings, Has.Count.EqualTo(3), "another mode");
            fluid.Budget = SolverBudget.Default;
            yield return null;
            fluid.Steps.Budget.TimeSource = new HeldTime { Factor = 20f };
            fluid.Budget = fraction;
            yield return Frames(Second);
            Assert.That(warnings, Has.Count.EqualTo(4), "switched off and on");
        }

        // Half a second of room is ten of these frames, each of three steps; eight pass until the time is known.
        [UnityTest]
        public IEnumerator Times_that_the_budget_waits_are_seconds_and_not_frames()
        {
            Time.captureDeltaTime = 1f / 20f;
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, Milliseconds(50f));
            SolverSettings settings = fluid.Settings;
            settings.iterations = 2;
            fluid.Settings = settings;
            yield return Frames(14);
            Assert.That(Used(fluid), Is.EqualTo("1 x 2"));
            yield return Frames(10);
            Assert.That(Used(fluid), Is.EqualTo("1 x 16"));
        }

        [UnityTest]
        public IEnumerator Bounds_that_leave_nothing_stable_give_way_and_say_so_once()
        {
            SolverBudget budget = Milliseconds(5f);
            budget.maxIterations = 1;
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, budget);
            yield return Frames(Second);
            Assert.That(Used(fluid), Is.EqualTo("1 x 2"));
            Assert.That(warnings, Has.Count.EqualTo(1));
            Assert.That(warnings[0], Does.Contain("'Budgeted'").And.Contain("bounds"));
        }

        [UnityTest]
        public IEnumerator An_error_target_that_is_met_leaves_the_least_that_meets_it()
        {
            SolverBudget budget = Milliseconds(100f);
            budget.targetError = 0.1f;
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, budget, f => f.StatisticsInterval = 5);
            yield return Frames(4 * Second);
            Assert.That(fluid.BudgetState.densityError, Is.InRange(1e-6f, 0.1f));
            Assert.That(fluid.BudgetState.reason, Is.EqualTo(BudgetReason.ErrorIsReached));
            Assert.That(Used(fluid), Is.EqualTo("1 x 2"));
        }

        [UnityTest]
        public IEnumerator A_restart_keeps_what_is_known_of_the_time_and_drops_the_error()
        {
            FluidSimulation fluid = Dam(new HeldTime { Factor = 20f }, Milliseconds(1.86f), f => f.StatisticsInterval = 5);
            yield return Frames(Second);
            fluid.Restart();
            yield return null;
            Assert.That(Used(fluid), Is.EqualTo("1 x 6"));
            Assert.That(fluid.BudgetState.densityError, Is.NaN);
            Assert.That(fluid.BudgetState.deviceFactor, Is.EqualTo(20f).Within(1).Percent);
        }

        [UnityTest]
        public IEnumerator A_budget_out_of_range_is_clamped_with_a_message()
        {
            SolverBudget budget = Milliseconds(-2f);
            FluidSimulation fluid = Dam(null, SolverBudget.Default);
            fluid.Budget = budget;
            yield return null;
            Assert.That(fluid.Budget.milliseconds, Is.EqualTo(0.01f));
            Assert.That(warnings.Single(), Does.Contain("budget milliseconds -2 is outside 0.01 to 1000; using 0.01."));
        }

        FluidSimulation Dam(IGpuTimeSource time, SolverBudget budget, Action<FluidSimulation> setUp = null)
        {
            var gameObject = new GameObject("Budgeted");
            made.Add(gameObject);
            gameObject.SetActive(false);
            var fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(new Vector3(0.4f, 0.4f, 0.3f), 0.05f, 96);
            SolverSettings settings = fluid.Settings;
            settings.deepWater = DeepWater.Off;
            fluid.Settings = settings;
            fluid.Steps.Budget.TimeSource = time;
            fluid.Budget = budget;
            fluid.StatisticsInterval = 0;
            gameObject.AddComponent<FluidVolume>().Size = new Vector3(0.2f, 0.3f, 0.2f);
            setUp?.Invoke(fluid);
            gameObject.SetActive(true);
            return fluid;
        }

        static void MakeElastic(FluidSimulation fluid)
        {
            FluidMaterial material = fluid.Material;
            material.shearModulus = 50f;
            fluid.Material = material;
        }

        static SolverBudget Milliseconds(float milliseconds)
        {
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            budget.milliseconds = milliseconds;
            budget.targetError = 0f;
            return budget;
        }

        static string Used(FluidSimulation fluid) => $"{fluid.Input.settings.substeps} x {fluid.Input.settings.iterations}";

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }

        void Hear(string message, string stackTrace, LogType type)
        {
            if (type == LogType.Warning)
                warnings.Add(message);
        }

        /// <summary>Says that steps take the model's time by a factor, three frames late; nothing at factor 0.</summary>
        sealed class HeldTime : IGpuTimeSource
        {
            public float Factor;
            public bool IsDisposed { get; private set; }

            public GpuTimeKind Kind => Factor > 0f ? GpuTimeKind.Measured : GpuTimeKind.None;

            public void BeginStep(CommandBuffer commands) { }
            public void EndStep(CommandBuffer commands) { }
            public StepTime Read(float seconds, WorkHistory work) => new StepTime(work.StepCost(3) * Factor, work.StepCost(3));
            public void Dispose() => IsDisposed = true;
        }
    }
}
