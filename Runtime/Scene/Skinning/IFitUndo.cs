using UnityEngine;

namespace Rill
{
    /// <summary>Records what a fit changes, so that the user can undo it.</summary>
    interface IFitUndo
    {
        void Changing(Object what);
        void Created(GameObject what);
        void Destroy(Object what);
    }
}
