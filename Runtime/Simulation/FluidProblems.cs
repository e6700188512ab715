using System.Collections.Generic;

namespace Rill
{
    /// <summary>Lists what is wrong with a fluid, in the words in which it is logged.</summary>
    static class FluidProblems
    {
        /// <param name="settingsProblem">What a check of the settings changed; null for nothing.</param>
        public static void List(FluidSimulation fluid, string settingsProblem, List<string> problems)
        {
            problems.AddIfAny(settingsProblem);
            PbfSolver solver = fluid.Solver;
            if (solver == null)
            {
                problems.AddIfAny(FeatureSupport.DeviceProblem ?? fluid.Box.StartProblem ?? fluid.SolverOwner.LayoutProblem ?? fluid.Failure);
                return;
            }
            FeatureGate gate = fluid.Support.Gate;
            problems.AddIfAny(fluid.Box.IsPoseLost ? fluid.Box.LostPoseProblem : null);
            problems.AddIfAny(fluid.Inputs.Colliders.Problem);
            problems.AddIfAny(gate.MissingProblem);
            problems.AddIfAny(fluid.Snapshots.StartStateProblem);
            problems.AddIfAny(fluid.Phases.Problem);
            problems.AddIfAny(fluid.Editing.Problem);
            problems.AddIfAny(fluid.Editing.Recentering.OutsideProblem);
            problems.AddIfAny(fluid.Editing.Recentering.TakerProblem);
            problems.AddIfAny(fluid.Steps.Problem);
            problems.AddIfAny(fluid.Steps.BordersProblem);
            problems.AddIfAny(fluid.Steps.GrainsProblem);
            fluid.Steps.Tension.List(problems);
            foreach ((Feature _, string refusal) in gate.Refusals)
                problems.Add(refusal);
            for (ReadbackKinds lost = solver.ReadbackErrors.Lost; ReadbackErrors.TryTake(ref lost, out ReadbackKinds kind);)
                problems.Add(ReadbackErrors.Problem(kind));
        }
    }
}
