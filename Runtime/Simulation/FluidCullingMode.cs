namespace Rill
{
    /// <summary>Behavior of a <see cref="FluidSimulation"/> while no camera sees its box.</summary>
    public enum FluidCullingMode
    {
        /// <summary>Goes on as ever.</summary>
        AlwaysSimulate,
        /// <summary>Its time passes more slowly, so that it takes fewer steps.</summary>
        Slow,
        /// <summary>Its time stands still.</summary>
        Pause,
    }
}
