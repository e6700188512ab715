namespace Rill
{
    /// <summary>Paths at which a project finds files of this package.</summary>
    static class PackagePaths
    {
        public const string Root = "Packages/com.rill.fluids/";

        public const string Manual = Root + "Documentation~/";

        /// <summary>Pages that lead to sections of the manual.</summary>
        public const string Help = Manual + "html/help/";

        /// <summary>Icon of all components and assets.</summary>
        public const string Icon = Root + "Editor/Icons/Drop.png";
    }
}
