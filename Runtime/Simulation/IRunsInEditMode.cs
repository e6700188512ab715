namespace Rill
{
    /// <summary>A component that the Editor runs beside a fluid that it simulates without Play. It gets its messages as in play mode.</summary>
    interface IRunsInEditMode
    {
        /// <summary>Whether it is that fluid, acts on it or draws it.</summary>
        bool BelongsTo(FluidSimulation fluid);
    }
}
