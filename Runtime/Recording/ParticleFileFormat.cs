namespace Rill
{
    /// <summary>Formats of files of particles.</summary>
    public enum ParticleFileFormat
    {
        /// <summary>Polygon file format, binary, little endian: Blender, MeshLab, Houdini and most tools for point clouds.</summary>
        Ply,
        /// <summary>Legacy VTK file with poly data, binary, big endian: ParaView, VisIt.</summary>
        Vtk,
    }
}
