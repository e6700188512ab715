namespace Rill
{
    /// <summary>A part that asks the water after each frame's steps: the answer comes two or three frames later, without waiting.</summary>
    public abstract class FluidQuery : FluidPart
    {
        /// <summary>Waits for the GPU until the newest step's sample is there. For tests and tools in the Editor: see
        /// <see cref="FluidSimulation.FlushQueries"/>.</summary>
        public void Flush()
        {
            if (Simulation != null)
                Simulation.FlushQueries();
        }

        /// <summary>Calls what the newest result has changed; after all results of a frame are set.</summary>
        internal abstract void RaiseEvents();

        private protected void Measure()
        {
            if (Simulation != null)
                Simulation.MeasureQueriesNow();
        }

        /// <summary>Whether the fluid runs and has room for this one.</summary>
        private protected bool IsAnswered => Simulation != null && Simulation.IsRunning && Number >= 0;

        /// <summary>Fluid time from then to the current frame, s.</summary>
        private protected float AgeOf(double time) => (float)(Simulation.FrameTime - time);

        private protected sealed override FeatureSet UsedFeatures => Features.Queries;
    }
}
