using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>A collider of the scene that every fluid looks for in its box.</summary>
    interface ISceneCollider : IFluidCollider
    {
        /// <summary>Layer of its object.</summary>
        int Layer { get; }
    }

    /// <summary>The colliders of all scenes that are enabled, in the order in which they were.</summary>
    static class SceneColliders
    {
        static List<ISceneCollider> enabled = new List<ISceneCollider>();

        public static List<ISceneCollider> Enabled => enabled;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetStatics() => enabled = new List<ISceneCollider>();
    }
}
