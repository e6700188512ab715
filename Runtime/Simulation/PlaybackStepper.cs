using System;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Shows the frames of a recording instead of the steps of a fluid.</summary>
    sealed class PlaybackStepper
    {
        readonly FluidSimulation fluid;
        IFluidPlayback source;

        public PlaybackStepper(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Playback whose frames replace the steps; null for none. The fluid then goes on from what is shown.</summary>
        public IFluidPlayback Source
        {
            get => source;
            set
            {
                source = value;
                if (value != null || fluid.Solver == null)
                    return;
                fluid.Clock.ContinueFromShown();
                fluid.Solver.ReleasePacking();
            }
        }

        /// <summary>Whether the shaders of recordings are there, which is logged once where not.</summary>
        public bool IsSupported => fluid.Support.HasBesideSteps(Features.Recording);

        /// <summary>Shows the frame that is due.</summary>
        /// <param name="frameTime">s.</param>
        public void Advance(float frameTime)
        {
            fluid.Clock.BeginFrame();
            fluid.Box.Follow();
            fluid.ResetMotion();
            bool shows = source.Advance(frameTime, fluid.Solver, out RecordedFrame frame, out bool follows);
            if (shows && IsSupported)
                Show(frame, follows);
            fluid.Clock.EndShown(source.Lag, follows);
        }

        void Show(RecordedFrame frame, bool follows)
        {
            fluid.Steps.PrepareStill();
            CommandBuffer commands = fluid.Commands;
            commands.Clear();
            try
            {
                fluid.Solver.ShowFrame(commands, fluid.Steps.Input, source.Layout, frame, follows && source.HasIds);
            }
            catch (ArgumentException problem)       // more than the device holds
            {
                fluid.Fail(problem.Message);
                return;
            }
            fluid.Clock.Show(frame.step, frame.time);
            fluid.Results.Measurements.Count(1);
            fluid.Results.Execute(commands);
        }
    }
}
