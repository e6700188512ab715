namespace Rill
{
    /// <summary>What the screen-space passes of the water's surface spend.</summary>
    public enum SurfaceQuality
    {
        /// <summary>Textures of half the screen's width and height: for mobile devices and untethered headsets.</summary>
        Low,
        /// <summary>Textures of the screen's size, filtered once.</summary>
        Medium,
        /// <summary>Textures of the screen's size, filtered twice.</summary>
        High,
    }
}
