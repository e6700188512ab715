namespace Rill
{
    /// <summary>How a bake tells inside from outside.</summary>
    public enum MeshSdfSign
    {
        /// <summary><see cref="WindingNumber"/> for meshes that are closed or have holes of at most a tenth of their surface,
        /// <see cref="OpenShell"/> for the others.</summary>
        Automatic,

        /// <summary>Inside is where the generalized winding number (Jacobson et al. 2013) is above one half; holes are closed smoothly.</summary>
        WindingNumber,

        /// <summary>No inside: the surface becomes a shell of a thickness.</summary>
        OpenShell,
    }
}
