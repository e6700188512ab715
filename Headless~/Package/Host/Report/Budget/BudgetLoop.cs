using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Report.Budget
{
    /// <summary>Plays a dam with a budget that changes, and the number of steps in a frame with it, and notes what each frame took.</summary>
    sealed class BudgetLoop
    {
        public static readonly string[] Columns = { "time_s", "target_ms", "ms", "told_ms", "iterations", "substeps", "error", "steps",
            "phase", "why" };

        const float StepTime = 1f / 60f;

        // Budget as a multiple of what a step with two iterations takes by this device's own time, and fixed steps in a frame.
        static readonly (double ofTwo, int steps)[] Phases = { (1.1, 1), (2.2, 1), (2.2, 2), (2.2, 1), (0.4, 1), (1.4, 1) };

        readonly ExperimentScene scene;
        readonly double phaseSeconds;

        public BudgetLoop(bool quick)
        {
            phaseSeconds = quick ? 2.5 : 5;
            scene = ExperimentScene.Dam(quick ? 512 : 1_000_000);
        }

        public List<object[]> Measure()
        {
            var rows = new List<object[]>();
            FluidSimulation fluid = Make();
            try
            {
                double two = TimeOfTwo(fluid);
                for (int phase = 0; phase < Phases.Length; phase++)
                    Play(fluid, phase, two * Phases[phase].ofTwo, Phases[phase].steps, rows);
            }
            finally
            {
                Object.DestroyImmediate(fluid.gameObject);
            }
            return rows;
        }

        void Play(FluidSimulation fluid, int phase, double target, int steps, List<object[]> rows)
        {
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            budget.milliseconds = (float)target;
            budget.targetError = 0f;
            fluid.Budget = budget;
            for (int frame = 0; frame < (int)(phaseSeconds / StepTime); frame++)
            {
                double milliseconds = Frame(steps);
                BudgetState state = fluid.BudgetState;
                rows.Add(new object[] { rows.Count * StepTime, target, milliseconds, state.milliseconds, state.iterations, state.substeps,
                    state.densityError, steps, phase, state.reason.ToString() });
            }
        }

        static double TimeOfTwo(FluidSimulation fluid)
        {
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            budget.milliseconds = 1000f;
            budget.minIterations = budget.maxIterations = 2;
            fluid.Budget = budget;
            var times = new List<double>();
            for (int frame = 0; frame < 120; frame++)
                times.Add(Frame(steps: 1));
            times.RemoveRange(0, 60);
            return times.OrderBy(time => time).ElementAt(times.Count / 2);
        }

        // A frame as long as its steps; returns what those took, ms.
        static double Frame(int steps)
        {
            Player.Device.Timing = true;
            PlayerLoop.Frame(steps * StepTime);
            Player.Device.Timing = false;
            return Player.Device.CollectSamples().Where(sample => sample.Name.StartsWith("Rill.Steps", StringComparison.Ordinal))
                .Sum(sample => sample.Milliseconds);
        }

        FluidSimulation Make()
        {
            var gameObject = new GameObject("Budget");
            gameObject.SetActive(false);
            var fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(scene.Domain, scene.Spacing, scene.Particles);
            SolverSettings settings = fluid.Settings;
            settings.deepWater = DeepWater.On;
            settings.iterations = 2;
            fluid.Settings = settings;
            fluid.StatisticsInterval = 10;
            gameObject.SetActive(true);
            scene.Fill(fluid.Solver);
            return fluid;
        }
    }
}
