namespace Rill
{
    /// <summary>How the last request of a <see cref="ParticleReadback"/> ended.</summary>
    public enum ReadbackOutcome
    {
        /// <summary>None has ended yet.</summary>
        None,
        /// <summary>The particles came back.</summary>
        Arrived,
        /// <summary>The fluid was started again, disabled or destroyed in between: what came back was left out.</summary>
        Dropped,
        /// <summary>The graphics device reported an error, which the fluid logs, or the stage ParticleAccess is not in this build.</summary>
        Failed,
    }
}
