using System;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>State of a simulation that a budget has to know.</summary>
    struct BudgetScene
    {
        public SolverSettings asked;
        public bool deepWater, elastic;
        /// <summary>Whether it has a surface tension.</summary>
        public bool hasTension;
        /// <summary>|g| Δt² of a fixed step, d.</summary>
        public float gravityStep;
        public float particles;
        /// <summary>C+; NaN where none was measured.</summary>
        public float densityError;
    }

    /// <summary>A simulation's budget while it runs: the ladder of its scene, the controller and the source of time together.</summary>
    sealed class BudgetedSolver : IDisposable
    {
        /// <summary>Weight of a new frame in the running mean of steps in a frame.</summary>
        const float StepsGain = 0.05f;

        readonly IGpuTimeSource source;
        readonly BudgetLadder ladder = new BudgetLadder();
        readonly BudgetController controller = new BudgetController();
        readonly WorkHistory work = new WorkHistory();
        BudgetState state;
        float stepsPerFrame = 1f, stepCost;
        bool isStarted;

        public BudgetedSolver(IGpuTimeSource source)
        {
            this.source = source;
        }

        public ref readonly BudgetState State => ref state;

        public void BeginStep(CommandBuffer commands) => source.BeginStep(commands);
        public void EndStep(CommandBuffer commands) => source.EndStep(commands);

        /// <summary>Once a frame, before its steps.</summary>
        /// <param name="seconds">Since the last call, s.</param>
        /// <returns>The settings for the frame's steps.</returns>
        public SolverSettings BeginFrame(float seconds, in SolverBudget budget, in BudgetScene scene)
        {
            SolverSettings asked = scene.asked;
            SolverBudget bounds = budget;
            // With fewer substeps than it was given it would be softer, or have less tension: see FluidMaterial.MaxShearModulus.
            if (scene.elastic || scene.hasTension)
                bounds.minSubsteps = Math.Max(budget.minSubsteps, Math.Min(asked.substeps, budget.maxSubsteps));
            if (scene.hasTension)
                bounds.minIterations = Math.Max(budget.minIterations, Math.Min(SurfaceTension.MinIterations, budget.maxIterations));
            ladder.IsElastic = scene.elastic;
            if (ladder.Build(scene.deepWater, scene.gravityStep, bounds))
                Continue(isStarted ? state.substeps : asked.substeps, isStarted ? state.iterations : asked.iterations, scene.particles);

            StepTime time = source.Read(seconds, work);
            var reading = new BudgetReading
            {
                seconds = seconds,
                milliseconds = time.Milliseconds,
                modeled = time.Modeled,
                source = source.Kind,
                stepsPerFrame = Math.Max(stepsPerFrame, 1f),
                particles = scene.particles,
                densityError = scene.densityError,
            };
            float target = budget.FrameMilliseconds;
            BudgetRung rung = ladder[controller.Update(reading, ladder, target, budget.targetError)];

            // Before anything is known of the time there is nothing to choose by.
            bool chooses = controller.Factor > 0f;
            SolverSettings settings = chooses ? rung.Apply(asked) : asked;
            settings.substeps = settings.StableSubsteps(scene.gravityStep);
            stepCost = StepCost.Milliseconds(settings.substeps, settings.iterations, scene.particles, scene.deepWater, scene.elastic);
            state = new BudgetState
            {
                reason = controller.Reason,
                source = source.Kind,
                targetMilliseconds = target,
                milliseconds = controller.Milliseconds,
                nextMilliseconds = controller.NextMilliseconds,
                substeps = settings.substeps,
                iterations = settings.iterations,
                relaxation = settings.relaxation,
                densityError = scene.densityError,
                deviceFactor = controller.Factor,
                changes = controller.Changes,
            };
            return settings;
        }

        /// <summary>After the frame's steps were recorded; also after a frame without any.</summary>
        public void EndFrame(int steps)
        {
            work.Add(steps, stepCost);
            if (steps > 0)
                stepsPerFrame += StepsGain * (steps - stepsPerFrame);
        }

        /// <summary>Whether the bounds leave nothing that is stable, so that they are exceeded.</summary>
        public bool BoundsGaveWay => ladder.BoundsGaveWay;

        public void Dispose() => source.Dispose();

        void Continue(int substeps, int iterations, float particles)
        {
            int rung = ladder.Nearest(substeps, iterations, particles);
            if (isStarted)
                controller.MoveTo(rung);
            else
                controller.Restart(rung);
            isStarted = true;
        }
    }
}
