using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Lets the user undo what a Fluid Bone Colliders fits.</summary>
    sealed class BoneFitUndo : IFitUndo
    {
        const string Name = "Fit to Bones";

        [InitializeOnLoadMethod]
        static void Install() => FluidBoneColliders.Undo = new BoneFitUndo();

        public void Changing(Object what)
        {
            if (!Application.isPlaying)
                Undo.RecordObject(what, Name);
        }

        public void Created(Object what)
        {
            if (!Application.isPlaying)
                Undo.RegisterCreatedObjectUndo(what, Name);
        }

        public bool MayDestroy(GameObject what) => !PrefabUtility.IsPartOfPrefabInstance(what);

        public void Destroy(Object what)
        {
            if (Application.isPlaying)
                Object.DestroyImmediate(what);
            else
                Undo.DestroyObjectImmediate(what);
        }
    }
}
