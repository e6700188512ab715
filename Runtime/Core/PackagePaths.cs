namespace Rill
{
    /// <summary>Paths at which a project finds files of this package.</summary>
    static class PackagePaths
    {
        public const string Root = "Packages/com.rill.fluids/";

        public const string Manual = Root + "Documentation~/";

        /// <summary>Icon of all components and assets.</summary>
        public const string Icon = Root + "Editor/Icons/Drop.png";
    }
}
