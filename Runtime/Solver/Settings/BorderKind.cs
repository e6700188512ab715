namespace Rill
{
    /// <summary>Kind of a side of a fluid's box.</summary>
    public enum BorderKind
    {
        /// <summary>A wall: waves come back from it.</summary>
        Wall,
        /// <summary>A band beside the side takes the waves that reach it, and no water passes.</summary>
        Absorbing,
        /// <summary>The water goes on beyond the side: in a band its velocity and its level are held, and waves leave.</summary>
        Open,
    }
}
