using Unity.Collections;
using UnityEngine;

namespace Rill
{
    /// <summary>Asks the water at a point; a <see cref="FluidQuery"/>.</summary>
    interface IProbe
    {
        /// <param name="frame">State that was asked.</param>
        /// <param name="position">Where it asked, world space, m.</param>
        /// <param name="isOutside">Whether that was outside the box.</param>
        /// <param name="words">What came back of all.</param>
        /// <param name="at">Index of the first word of this one.</param>
        void SetResult(in QueryFrame frame, Vector3 position, bool isOutside, NativeArray<uint> words, int at);
    }
}
