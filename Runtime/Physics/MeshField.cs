using System;
using UnityEngine;

namespace Rill
{
    /// <summary>A mesh of the physics, and what the water knows of it.</summary>
    [Serializable]
    public struct MeshField
    {
        [Tooltip("Mesh of the Mesh Collider.")]
        [SerializeField] Mesh mesh;

        [Tooltip("Signed distances that were baked from it.")]
        [SerializeField] SignedDistanceField field;

        /// <param name="mesh">Mesh of the Mesh Collider.</param>
        /// <param name="field">That was baked from it.</param>
        public MeshField(Mesh mesh, SignedDistanceField field)
        {
            this.mesh = mesh;
            this.field = field;
        }

        /// <summary>Mesh of the Mesh Collider.</summary>
        public Mesh Mesh => mesh;

        /// <summary>Signed distances that were baked from it.</summary>
        public SignedDistanceField Field => field;
    }
}
