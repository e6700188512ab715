using UnityEngine;

namespace Rill
{
    /// <summary>Why a Skinned Mesh Renderer cannot be read.</summary>
    static class SkinProblems
    {
        public static string NotReadable(Mesh mesh)
            => $"its mesh '{mesh.name}' cannot be read. Tick Read/Write in the import settings of the model.";

        /// <param name="bones">Bones of the renderer.</param>
        /// <returns>Null where its mesh and weights can be used.</returns>
        public static string Of(SkinnedMeshRenderer renderer, Transform[] bones)
        {
            Mesh mesh = renderer.sharedMesh;
            if (mesh == null)
                return "its Skinned Mesh Renderer has no mesh. Assign one.";
            if (!mesh.isReadable)
                return NotReadable(mesh);
            if (bones.Length == 0)
                return "its Skinned Mesh Renderer has no bones. Rig the model, and do not optimize its game objects away at import.";
            if (mesh.boneWeights.Length != mesh.vertexCount || mesh.vertexCount == 0)
                return $"its mesh '{mesh.name}' has no bone weights. Rig it, or use a Mesh Renderer.";
            return mesh.bindposes.Length == 0 ? $"its mesh '{mesh.name}' has no bind poses. Export it again with its skin." : null;
        }
    }
}
