namespace Rill
{
    /// <summary>Decides whether the pressure of deep water is also solved for on a coarse grid.</summary>
    public enum DeepWater
    {
        /// <summary>Solves on the coarse grid if the fluid can be more than four layers of particles deep along gravity: by its particles, and by
        /// how high emitters stand. Once on, it stays on above three.</summary>
        Automatic,
        /// <summary>Always, whatever the depth.</summary>
        On,
        /// <summary>Never: the iterations alone carry the pressure.</summary>
        Off,
    }
}
