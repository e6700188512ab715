using NUnit.Framework;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>State of a budget from frame to frame, with frames and steps that the test takes.</summary>
    public class BudgetedSolverTests
    {
        const float Frame = 1f / 60f;

        static readonly SolverBudget Budget = new SolverBudget
        {
            mode = BudgetMode.Milliseconds, milliseconds = 2f, minIterations = 1, maxIterations = 16, minSubsteps = 1, maxSubsteps = 4
        };

        Told source;
        BudgetedSolver solver;
        BudgetScene scene;
        float stepTime;     // ms of a step with the chosen settings

        [SetUp]
        public void Make()
        {
            source = new Told();
            solver = new BudgetedSolver(source);
            scene = new BudgetScene
            {
                asked = SolverSettings.Default, deepWater = true, gravityStep = 0.27f, particles = 1e6f, densityError = float.NaN
            };
            scene.asked.iterations = 1;
        }

        [TearDown]
        public void Dispose() => solver.Dispose();

        [Test]
        public void A_surface_tension_keeps_two_iterations_and_its_substeps()
        {
            scene.asked.substeps = 2;
            scene.particles = 1e8f;     // too many for any
            Run(600, frame => 1);
            Assert.That((solver.State.substeps, solver.State.iterations), Is.EqualTo((1, 1)), "without");
            scene.hasTension = true;
            Run(600, frame => 1);
            Assert.That((solver.State.substeps, solver.State.iterations), Is.EqualTo((2, 2)));
        }

        // Every other frame takes two steps.
        [Test]
        public void Frames_without_steps_do_not_count_for_how_many_a_frame_takes()
        {
            Run(600, frame => 2 * (frame % 2));
            Assert.That(solver.State.milliseconds, Is.EqualTo(2f * stepTime).Within(1).Percent);
        }

        [Test]
        public void One_frame_of_many_steps_counts_a_twentieth()
        {
            Run(300, frame => 1);
            float before = solver.State.milliseconds;
            Run(1, frame => 3);
            Run(1, frame => 1);
            Assert.That(solver.State.milliseconds, Is.EqualTo(1.1f * before).Within(1).Percent);
        }

        [Test]
        public void A_frame_without_steps_is_known_as_one_of_no_work_and_of_the_cost_that_a_step_would_have()
        {
            Run(10, frame => 1);
            float cost = source.Work.StepCost(1);
            Run(2, frame => 0);
            Assert.That((source.Work.Steps(1), source.Work.StepCost(1)), Is.EqualTo((0, cost)));
        }

        // 4 iterations fit; one was asked for.
        [Test]
        public void Where_a_scene_needs_another_ladder_what_was_learned_stays_and_it_goes_on_from_what_it_chose()
        {
            Run(300, frame => 1);
            int iterations = solver.State.iterations, changes = solver.State.changes;
            Assert.That(iterations, Is.GreaterThan(2));
            scene.gravityStep = 0.7f;       // two substeps
            SolverSettings settings = Run(1, frame => 1);
            Assert.That(solver.State.reason, Is.Not.EqualTo(BudgetReason.TimeUnknown));
            Assert.That(solver.State.deviceFactor, Is.EqualTo(1f).Within(1).Percent);
            Assert.That(solver.State.changes, Is.EqualTo(changes));
            Assert.That(settings.substeps, Is.EqualTo(2));
            scene.gravityStep = 0.27f;
            scene.deepWater = false;
            settings = Run(1, frame => 1);
            Assert.That(settings.iterations, Is.GreaterThan(2), "none of what was asked for");
        }

        SolverSettings Run(int frames, System.Func<int, int> steps)
        {
            SolverSettings settings = default;
            for (int frame = 0; frame < frames; frame++)
            {
                settings = solver.BeginFrame(Frame, Budget, scene);
                stepTime = StepCost.Milliseconds(settings.substeps, settings.iterations, scene.particles, scene.deepWater, scene.elastic);
                solver.EndFrame(steps(frame));
            }
            return settings;
        }

        /// <summary>Says that steps take what the model says.</summary>
        sealed class Told : IGpuTimeSource
        {
            public WorkHistory Work;

            public GpuTimeKind Kind => GpuTimeKind.Measured;

            public void BeginStep(CommandBuffer commands) { }
            public void EndStep(CommandBuffer commands) { }

            public StepTime Read(float seconds, WorkHistory work)
            {
                Work = work;
                return new StepTime(work.StepCost(3), work.StepCost(3));
            }

            public void Dispose() { }
        }
    }
}
