namespace Rill
{
    /// <summary>What the Editor runs beside a fluid that it simulates without Play. It hears its messages there as in play mode.</summary>
    interface IRunsInEditMode
    {
        /// <summary>Whether it is that fluid, acts on it or draws it.</summary>
        bool BelongsTo(FluidSimulation fluid);
    }
}
