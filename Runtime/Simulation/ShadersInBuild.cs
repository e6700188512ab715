namespace Rill
{
    /// <summary>Which stages a <see cref="FluidSimulation"/> brings into a build.</summary>
    public enum ShadersInBuild
    {
        /// <summary>Those that its settings use as they are stored. Colliders, emitters, drains, force fields and renderers bring their
        /// own.</summary>
        UsedBySettings,
        /// <summary>All that a script can switch on or add while the player runs.</summary>
        AllFeatures,
    }
}
