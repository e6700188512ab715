using System.Collections.Generic;
using UnityEditor;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidDeformingMesh))]
    [CanEditMultipleObjects]
    sealed class FluidDeformingMeshEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Field", true,
                new InspectorField("resolution", "voxels"),
                new InspectorField("trianglesPerFrame"),
                new InspectorField("margin")),
            new InspectorSection("Inside and Outside", false,
                new InspectorField("sign"),
                new InspectorField("shellThickness", "m", When.IsNot("sign", MeshSdfSign.WindingNumber))),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override void ListLive(List<(string label, string text)> live)
        {
            var mesh = (FluidDeformingMesh)target;
            live.Add(("Voxel", Invariant($"{mesh.VoxelSize:0.####} m")));
            live.Add(("Triangles", Invariant($"{mesh.TriangleCount:N0}")));
            bool bakes = mesh.BakedFields > 0;
            live.Add(("Baked fields", bakes ? Invariant($"{mesh.BakedFields:N0}") : "none: no fluid is near"));
            if (bakes)
                live.Add(("Newest field", Invariant($"{1000f * mesh.FieldAge:0} ms old, baked in {mesh.FramesPerBake} frames")));
        }
    }
}
