namespace Rill
{
    /// <summary>Shape in which an emitter puts particles.</summary>
    public enum EmitterShape
    {
        /// <summary>The inside of a box, or its cross-section for a jet.</summary>
        Box,
        /// <summary>The inside of a sphere, or its cross-section for a jet.</summary>
        Sphere,
        /// <summary>A disc across the forward axis.</summary>
        Disc,
        /// <summary>The surface of a mesh, outwards.</summary>
        MeshSurface,
    }
}
