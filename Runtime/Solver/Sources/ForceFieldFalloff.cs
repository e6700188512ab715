namespace Rill
{
    /// <summary>How a field's strength falls from its center to its bounds.</summary>
    [GenerateHlsl("ForceFields")]
    public enum ForceFieldFalloff
    {
        /// <summary>Not at all.</summary>
        None,
        /// <summary>1 − t, with t = 0 at the center and 1 at the bounds.</summary>
        Linear,
        /// <summary>(0.1 / t)², and 1 below t = 0.1.</summary>
        InverseSquare,
        /// <summary>(1 − t²)².</summary>
        Smooth,
    }
}
