namespace Rill
{
    /// <summary>A collider's surface that changes.</summary>
    interface IDeformingShape
    {
        /// <summary>Its newest two fields; null until <see cref="Follow"/> was called.</summary>
        DeformingField Field { get; }

        /// <summary>Bakes what this frame's budget allows. Called by each fluid that it reaches into, before the steps of a frame.</summary>
        /// <param name="reached">Fraction of the time since the frame with steps before that the steps come to, 0 to 1.</param>
        /// <returns>How far the surface has then come from the older to the newer field, 0 to 1.</returns>
        float Follow(float reached);
    }
}
