using System;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Receives the fields of a bake, instead of colliders on the objects that show the meshes.</summary>
    sealed class FieldReceiver
    {
        readonly Func<Mesh, SignedDistanceField, bool> take;

        /// <param name="label">Where the fields go, for the window.</param>
        /// <param name="take">Called for each mesh that could be baked; false where what it is for is gone or has a field by then. Undo takes back
        /// what it does.</param>
        public FieldReceiver(string label, Func<Mesh, SignedDistanceField, bool> take) => (Label, this.take) = (label, take);

        /// <summary>Name of the receiver of the fields.</summary>
        public string Label { get; }

        /// <summary>Takes the field of a mesh; false where it is no longer wanted.</summary>
        public bool Assign(Mesh mesh, SignedDistanceField field) => take(mesh, field);
    }
}
