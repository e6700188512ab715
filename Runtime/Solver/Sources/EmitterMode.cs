namespace Rill
{
    /// <summary>How an emitter puts particles there.</summary>
    public enum EmitterMode
    {
        /// <summary>A closed stream from the center of the shape's cross-section, as wide as rate and speed make it.</summary>
        Jet,
        /// <summary>Particles from all positions of the cross-section in turn: a low rate is drops.</summary>
        Spray,
        /// <summary>Into the shape's volume, from its bottom up, where there is room.</summary>
        Fill,
    }
}
