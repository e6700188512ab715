using UnityEngine;

namespace Rill
{
    /// <summary>Records what a fit changes, so that the user can undo it.</summary>
    interface IFitUndo
    {
        void Changing(Object what);
        void Created(Object what);
        void Destroy(Object what);

        /// <summary>False for a part of a prefab's instance: the Editor lets its components be removed, and not itself.</summary>
        bool MayDestroy(GameObject what);
    }
}
