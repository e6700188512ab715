namespace Rill
{
    /// <summary>Shows frames instead of a fluid's steps.</summary>
    interface IFluidPlayback
    {
        /// <summary>Layout of its frames.</summary>
        FrameLayout Layout { get; }

        /// <summary>Whether its frames have the particles' ids.</summary>
        bool HasIds { get; }

        /// <summary>Time by which the shown state lags the frame, s.</summary>
        double Lag { get; }

        /// <summary>Goes on by some time.</summary>
        /// <param name="seconds">s.</param>
        /// <param name="frame">The frame to show.</param>
        /// <param name="follows">Whether it goes on from the frame before.</param>
        /// <returns>Whether there is another frame to show.</returns>
        bool Advance(float seconds, PbfSolver solver, out RecordedFrame frame, out bool follows);
    }
}
