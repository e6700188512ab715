namespace Rill
{
    /// <summary>A component beside a <see cref="FluidSimulation"/> that draws it.</summary>
    interface IDrawsFluid
    {
        /// <summary>Returns what drawing costs, and why.</summary>
        StageDescription Describe();
    }
}
