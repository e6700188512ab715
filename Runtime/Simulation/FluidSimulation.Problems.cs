using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // What is wrong, in the words in which it is logged.
    public sealed partial class FluidSimulation
    {
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] string failure;     // what stopped it

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            if (pbf == null)
            {
                problems.AddIfAny(DeviceProblem ?? NoPoseProblem ?? LayoutProblem ?? failure);
                return;
            }
            problems.AddIfAny(poseIsLost ? LostPoseProblem : null);
            problems.AddIfAny(colliders.LeftOutCount > 0 ? TooManyProblem : null);
            problems.AddIfAny(Gate.MissingProblem);
            problems.AddIfAny(StartStateProblem);
            problems.AddIfAny(pbf.RefusedOfScripts > 0 ? RefusedProblem : null);
            problems.AddIfAny(pbf.RefusedToKeep > 0 ? KeptFullProblem : null);
            problems.AddIfAny(pbf.RefusedToHandOver > 0 ? HandOverFullProblem : null);
            problems.AddIfAny(isTooViscous ? TooViscousProblem : null);
            foreach ((Feature _, string refusal) in Gate.Refusals)
                problems.Add(refusal);
            for (ReadbackKinds lost = pbf.ReadbackErrors.Lost; ReadbackErrors.TryTake(ref lost, out ReadbackKinds kind);)
                problems.Add(ReadbackErrors.Problem(kind));
        }

        string NoPoseProblem => Limit.IsPose(transform.position, transform.rotation) ? null
            : Invariant($"its transform is not finite (position {transform.position}, rotation {transform.rotation}). Set position and ") +
            "rotation to numbers.";

        string LostPoseProblem => Invariant($"its transform is not finite (position {transform.position}, rotation ") +
            Invariant($"{transform.rotation}). The fluid goes on where it last was, at {lastPlace}. Set position, rotation and scale of ") +
            "this object and its parents to numbers that multiply to a place.";

        string TooManyProblem => Invariant($"takes {ColliderSet.Most} colliders at a time; {colliders.LeftOutCount} more are in its box ") +
            $"and left out, '{(colliders.FirstLeftOut.IsThere ? colliders.FirstLeftOut.Name : "")}' first. Merge meshes into one field, " +
            "or disable colliders that the fluid does not reach.";

        string LayoutProblem
        {
            get
            {
                TryMakeLayout(out _, out string problem);
                return problem;
            }
        }

        /// <summary>What its buffers will take on the GPU, without optional stages; 0 where it cannot run.</summary>
        internal long EstimatedBytes => TryMakeLayout(out SolverLayout layout, out _) ? layout.EstimatedBytes : 0;

        bool TryMakeLayout(out SolverLayout layout, out string problem)
        {
            layout = null;
            problem = null;
            try
            {
                layout = MakeLayout();
            }
            catch (ArgumentException refusal)
            {
                problem = refusal.Message;
            }
            return problem == null;
        }
    }
}
