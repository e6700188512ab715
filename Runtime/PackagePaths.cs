namespace Rill
{
    /// <summary>Where a project finds files of this package.</summary>
    static class PackagePaths
    {
        public const string Root = "Packages/com.rill.fluids/";

        /// <summary>Of all components and assets.</summary>
        public const string Icon = Root + "Editor/Icons/Drop.png";
    }
}
