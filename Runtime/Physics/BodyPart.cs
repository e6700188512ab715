namespace Rill
{
    /// <summary>A collider of a body that can float, where it is in this step.</summary>
    struct BodyPart
    {
        public IFluidCollider collider;
        /// <summary>World space, m.</summary>
        public ColliderMotion shape;
        /// <summary>Distance field of a mesh; null for other shapes.</summary>
        public SignedDistanceField field;
        /// <summary>m³, above 0.</summary>
        public float volume;
    }
}
