using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Which layers and which pairs of colliders pass through each other.</summary>
    internal static class CollisionLayers
    {
        static readonly uint[] masks = new uint[32];
        static readonly HashSet<(int, int)> ignored = new HashSet<(int, int)>();

        static CollisionLayers() => Reset();

        /// <summary>Masks of the layers that each layer meets.</summary>
        public static uint[] Masks => masks;

        public static IEnumerable<(int A, int B)> Ignored => ignored;

        public static bool Ignores(int a, int b) => (masks[a] & 1u << b) == 0;

        public static void Ignore(int a, int b, bool ignore)
        {
            Set(a, b, !ignore);
            Set(b, a, !ignore);
        }

        public static bool Ignores(Collider a, Collider b) => ignored.Contains(Pair(a, b));

        public static void Ignore(Collider a, Collider b, bool ignore)
        {
            if (ignore)
                ignored.Add(Pair(a, b));
            else
                ignored.Remove(Pair(a, b));
            foreach (ContactWorld world in PhysicsWorld.ContactWorlds)
                world.Ignore(a.Id, b.Id, ignore);
        }

        public static void Reset()
        {
            for (int i = 0; i < masks.Length; i++)
                masks[i] = ~0u;
            ignored.Clear();
        }

        static void Set(int a, int b, bool meet) => masks[a] = meet ? masks[a] | 1u << b : masks[a] & ~(1u << b);

        static (int, int) Pair(Collider a, Collider b) => a.Id < b.Id ? (a.Id, b.Id) : (b.Id, a.Id);
    }
}
