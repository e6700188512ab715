namespace Rill
{
    /// <summary>How a <see cref="FluidSurface"/> finds the water's surface.</summary>
    public enum SurfaceMethod
    {
        /// <summary>For each camera, on its picture: one layer of water, with the cost of the pixels that it covers.</summary>
        ScreenSpace,
        /// <summary>Once a frame for all cameras, as a closed mesh: light goes in at one side and out at the other.</summary>
        Mesh,
    }
}
