namespace UnityEngine.Headless
{
    /// <summary>A collider among the shapes of the physics.</summary>
    sealed class QueriedShape : PhysicsShape
    {
        public readonly Collider Owner;

        public QueriedShape(Collider owner) => Owner = owner;

        public override GameObject Object => Owner.gameObject;

        public override void Sync() => Owner.Sync();
    }
}
