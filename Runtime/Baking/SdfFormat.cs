namespace Rill
{
    /// <summary>How a distance field's voxels are stored.</summary>
    public enum SdfFormat
    {
        /// <summary>Half, unless rounding to it costs more than 0.001 voxel within two voxels of the surface or 0.05 voxel anywhere.</summary>
        Automatic,

        /// <summary>16 bits a voxel.</summary>
        Half,

        /// <summary>32 bits a voxel.</summary>
        Float,
    }
}
