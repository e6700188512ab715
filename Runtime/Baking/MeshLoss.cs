namespace Rill
{
    /// <summary>Something of a mesh that a bake would not represent; see <see cref="MeshReport.LossesOf"/>.</summary>
    public readonly struct MeshLoss
    {
        internal MeshLoss(string text, MeshSdfSettings? remedy = null) => (Text, Remedy) = (text, remedy);

        /// <summary>Describes the lost part, the reason and the remedy, in sentences.</summary>
        public string Text { get; }

        /// <summary>Settings that represent it; null where none do, or where one must choose.</summary>
        public MeshSdfSettings? Remedy { get; }
    }
}
