namespace Rill
{
    /// <summary>Whether the pressure of deep water is also solved for on a coarse grid.</summary>
    public enum DeepWater
    {
        /// <summary>Where the water is more than ten particle layers deep.</summary>
        Automatic,
        On,
        Off,
    }
}
