namespace Rill
{
    /// <summary>Where a budget's GPU time comes from.</summary>
    public enum GpuTimeKind
    {
        /// <summary>Nothing tells: no budget can be held.</summary>
        None,
        /// <summary>Particles x passes by a cost model, scaled by the whole frame's GPU time or by the device factor.</summary>
        Modeled,
        /// <summary>Time stamps around the steps themselves.</summary>
        Measured,
    }
}
