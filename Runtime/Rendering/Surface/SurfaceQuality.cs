namespace Rill
{
    /// <summary>How fine the water's surface is found and drawn.</summary>
    public enum SurfaceQuality
    {
        /// <summary>Nodes of the mesh are one spacing apart, and textures have half the picture's width and height: for mobile devices and untethered
        /// headsets.</summary>
        Low,
        /// <summary>Nodes of the mesh are 0.75 spacings apart.</summary>
        Medium,
        /// <summary>Nodes of the mesh are 0.5 spacings apart, and rays are as fine as the largest pictures.</summary>
        High,
    }
}
