namespace Rill
{
    /// <summary>Treatment of particles that lie outside of a box that was put elsewhere.</summary>
    public enum LeavingParticles
    {
        /// <summary>They are removed and count as drained.</summary>
        Remove,
        /// <summary>They stay in the world, at rest in time, up to <see cref="FluidSimulation.KeptCapacity"/>, and come back as the box
        /// covers their place again.</summary>
        Keep,
    }
}
