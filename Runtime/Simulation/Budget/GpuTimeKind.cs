namespace Rill
{
    /// <summary>Source of a budget's GPU time.</summary>
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
