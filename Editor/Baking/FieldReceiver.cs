using System;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>What takes the fields of a bake, instead of colliders on the objects that show the meshes.</summary>
    sealed class FieldReceiver
    {
        readonly Action<Mesh, SignedDistanceField> take;

        /// <param name="label">Where the fields go, for the window.</param>
        /// <param name="take">Called for each mesh that could be baked. What it is for may be gone by then. Undo takes back what it does.</param>
        public FieldReceiver(string label, Action<Mesh, SignedDistanceField> take) => (Label, this.take) = (label, take);

        /// <summary>Where the fields go.</summary>
        public string Label { get; }

        /// <summary>Takes the field of a mesh.</summary>
        public void Take(Mesh mesh, SignedDistanceField field) => take(mesh, field);
    }
}
