namespace Rill
{
    /// <summary>Whether the pressure of deep water is also solved for on a coarse grid.</summary>
    public enum DeepWater
    {
        /// <summary>Where the fluid that was put in reaches more than four layers of particles along gravity. Once on, it stays on above three.</summary>
        Automatic,
        On,
        Off,
    }
}
