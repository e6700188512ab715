using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// What the host has of it. In an assembly of its own, for the package alone: scripts of other projects find the stub with all members
    /// of Unity's, whose gravity is this one, and which throws for the rest.
    /// </summary>
    public class Physics
    {
        public static Vector3 gravity { get => PhysicsWorld.Gravity; set => PhysicsWorld.Gravity = value; }
    }
}
