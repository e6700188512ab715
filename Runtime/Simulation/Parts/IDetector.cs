namespace Rill
{
    /// <summary>Measures the water in a shape; a <see cref="FluidQuery"/>.</summary>
    interface IDetector
    {
        /// <summary>Distances of a mesh; null for another shape.</summary>
        SignedDistanceField MeshField { get; }

        /// <summary>Gives what is asked of the state of this frame.</summary>
        /// <param name="frame">Frame of the fluid's box.</param>
        /// <param name="spacing">m.</param>
        /// <returns>Whether there is anything to ask.</returns>
        bool TryGetRegion(in DomainFrame frame, float spacing, out DetectorRegion region, out DetectorPose pose);

        /// <param name="frame">State that was asked.</param>
        /// <param name="pose">Where it asked.</param>
        /// <param name="index">Its number among the detectors of the question in this slot.</param>
        void SetResult(in QueryFrame frame, in DetectorPose pose, Queries queries, int slot, int index);
    }
}
