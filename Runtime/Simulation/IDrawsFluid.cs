namespace Rill
{
    /// <summary>A component beside a <see cref="FluidSimulation"/> that draws it, or what it has wetted.</summary>
    interface IDrawsFluid
    {
        /// <summary>Returns what drawing costs, and why.</summary>
        StageDescription Describe();
    }
}
