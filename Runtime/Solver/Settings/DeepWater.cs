namespace Rill
{
    /// <summary>Whether the pressure of deep water is also solved for on a coarse grid.</summary>
    public enum DeepWater
    {
        /// <summary>Where the fluid can be more than four layers of particles deep along gravity: by what was put in, and by how high
        /// emitters stand. Once on, it stays on above three.</summary>
        Automatic,
        /// <summary>Always, whatever the depth.</summary>
        On,
        /// <summary>Never: the iterations alone carry the pressure.</summary>
        Off,
    }
}
