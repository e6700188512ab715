namespace Rill
{
    /// <summary>Looks that go by a name, see <see cref="SurfaceLook.Of"/>.</summary>
    public enum SurfacePreset { Custom, Water, MurkyWater, Wine, Milk, Oil, Honey }
}
