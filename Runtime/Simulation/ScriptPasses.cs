using System;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Passes of scripts, which are recorded before each step of a fluid.</summary>
    sealed class ScriptPasses
    {
        readonly FluidSimulation fluid;
        Delegates<Action<CommandBuffer, FluidParticles>> passes;
        bool isRecording;

        public ScriptPasses(FluidSimulation fluid) => this.fluid = fluid;

        public bool IsEmpty => passes.IsEmpty;

        public void Add(Action<CommandBuffer, FluidParticles> pass) => passes.Add(pass);

        public void Remove(Action<CommandBuffer, FluidParticles> pass) => passes.Remove(pass);

        /// <summary>Records the passes before a step.</summary>
        /// <returns>Whether there is still a step to take.</returns>
        public bool Record(CommandBuffer commands, ref StepInput input)
        {
            input.removesKilled = false;
            if (passes.IsEmpty)
                return true;
            PbfSolver before = fluid.Solver;
            before.PreparePhases(input);
            isRecording = true;
            foreach (Action<CommandBuffer, FluidParticles> pass in passes.All)
            {
                try
                {
                    pass(commands, new FluidParticles(fluid));
                }
                catch (Exception problem)       // of a script, as in any of its messages
                {
                    fluid.Inputs.Thrown.Log(problem, pass, fluid);
                }
                if (fluid.Solver != before)     // disabled by the pass
                    break;
            }
            isRecording = false;
            if (fluid.Solver != before)
                return false;
            input.removesKilled = fluid.Support.Gate.IsLoaded(Features.ParticleAccess);
            return true;
        }

        /// <exception cref="InvalidOperationException">Called in a pass.</exception>
        public void ThrowInPass(string act)
        {
            if (isRecording)
                throw new InvalidOperationException(
                    $"FluidSimulation '{fluid.name}' is recording a step in this pass of BeforeStep, where {act} is not allowed: do it in Update.");
        }

        /// <exception cref="InvalidOperationException">Called in a pass.</exception>
        public void ThrowInPass()
        {
            if (isRecording)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' cannot start again in a pass of BeforeStep, whose step " +
                    $"is being recorded: call Restart or Restore in Update.");
        }
    }
}
