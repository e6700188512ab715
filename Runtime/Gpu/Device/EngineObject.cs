using UnityEngine;

namespace Rill
{
    /// <summary>Ends what the package has made of Unity's own objects: at once where nothing plays, at the end of the frame in play mode,
    /// as Unity wants it.</summary>
    static class EngineObject
    {
        /// <summary>Destroys it and nulls the reference; nothing where it is null.</summary>
        public static void Destroy<T>(ref T made) where T : Object
        {
            if (made == null)
                return;
            if (Application.isPlaying)
                Object.Destroy(made);
            else
                Object.DestroyImmediate(made);
            made = null;
        }

        /// <summary>Destroys as <see cref="Destroy{T}"/> does; its memory on the GPU is free at once.</summary>
        public static void Release(ref RenderTexture texture)
        {
            if (texture == null)
                return;
            texture.Release();
            Destroy(ref texture);
        }

        /// <summary>Destroys a mesh like <see cref="Destroy{T}"/>, and frees its memory on the GPU at once.</summary>
        public static void Release(ref Mesh mesh)
        {
            if (mesh == null)
                return;
            mesh.Clear(false);
            Destroy(ref mesh);
        }
    }
}
