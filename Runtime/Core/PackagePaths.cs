namespace Rill
{
    /// <summary>Where a project finds files of this package.</summary>
    static class PackagePaths
    {
        public const string Root = "Packages/com.rill.fluids/";

        public const string Manual = Root + "Documentation~/";

        /// <summary>Of all components and assets.</summary>
        public const string Icon = Root + "Editor/Icons/Drop.png";
    }
}
