using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine.SceneManagement
{
    public struct Scene
    {
        internal readonly SceneData Data;
        internal Scene(SceneData data) { Data = data; }

        public int handle => Data?.Handle ?? 0;
        public string path => Data?.Path ?? "";
        public string name { get => Data?.Name; set => Valid().Name = value; }
        public int buildIndex => Data?.BuildIndex ?? -1;
        public bool isLoaded => Data != null && Data.IsLoaded;
        public bool isDirty => false;
        public bool isSubScene { get => false; set { } }
        public int rootCount => Valid().Roots.Count;

        public bool IsValid() => Data != null && !Data.IsGone;

        public GameObject[] GetRootGameObjects() => Valid().Roots.ToArray();

        public void GetRootGameObjects(List<GameObject> rootGameObjects)
        {
            rootGameObjects.Clear();
            rootGameObjects.AddRange(Valid().Roots);
        }

        SceneData Valid() => IsValid() ? Data : throw new ArgumentException("The scene is invalid.");

        public static bool operator ==(Scene lhs, Scene rhs) => lhs.handle == rhs.handle;
        public static bool operator !=(Scene lhs, Scene rhs) => lhs.handle != rhs.handle;
        public override bool Equals(object other) => other is Scene scene && scene == this;
        public override int GetHashCode() => handle;
    }
}

namespace UnityEngine.Headless
{
    internal sealed class SceneData
    {
        static int lastHandle;

        public readonly int Handle = --lastHandle;
        public readonly List<GameObject> Roots = new List<GameObject>();
        public string Name = "", Path = "";
        public int BuildIndex = -1;
        public bool IsLoaded, IsGone;

        /// <summary>Whether its bodies and colliders are in a physics scene of their own, by LocalPhysicsMode.Physics3D.</summary>
        public bool HasLocalPhysics;
    }
}
