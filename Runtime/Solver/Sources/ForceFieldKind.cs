namespace Rill
{
    /// <summary>Effect of a force field.</summary>
    [GenerateHlsl("ForceFields")]
    public enum ForceFieldKind
    {
        /// <summary>Accelerates along the object's forward axis.</summary>
        Direction,
        /// <summary>Accelerates towards the object; away from it with a negative strength.</summary>
        Point,
        /// <summary>Accelerates around the object's forward axis.</summary>
        Vortex,
        /// <summary>Drags the surface along the object's forward axis: the more, the fewer neighbors a particle has.</summary>
        Wind,
    }
}
