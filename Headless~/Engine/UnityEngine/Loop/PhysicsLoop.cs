namespace UnityEngine.Headless
{
    /// <summary>Calls of the player's loop and of new objects to the physics, which lies in an assembly of its own.</summary>
    internal abstract class PhysicsLoop
    {
        /// <summary>Null as long as nothing uses the physics.</summary>
        public static PhysicsLoop Current;

        /// <summary>Before the scripts of a fixed step.</summary>
        public abstract void BeginFixedStep();

        /// <summary>After them.</summary>
        public abstract void FixedStep();

        /// <summary>After the fixed steps of a frame, before Update.</summary>
        public abstract void BeginUpdate();

        /// <summary>Adds a collider to a new primitive, as Unity does.</summary>
        public abstract void AddCollider(GameObject primitive, PrimitiveType type);

        public abstract void Reset();
    }
}
