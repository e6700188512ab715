namespace Rill
{
    /// <summary>Looks that go by a name, see <see cref="SurfaceLook.Of"/>.</summary>
    public enum SurfacePreset
    {
        /// <summary>The values as they stand.</summary>
        Custom,
        /// <summary>Clear water.</summary>
        Water,
        /// <summary>Water with much in it, such as that of a pond.</summary>
        MurkyWater,
        /// <summary>Red wine.</summary>
        Wine,
        /// <summary>Milk, which scatters nearly all light.</summary>
        Milk,
        /// <summary>Olive oil.</summary>
        Oil,
        /// <summary>Clear honey.</summary>
        Honey,
    }
}
