using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>A source of colliders whose bodies one fluid carries.</summary>
    interface IBodySource
    {
        /// <summary>Lists those that it knows.</summary>
        void ListBodies(List<ICarriedBody> bodies);

        /// <summary>Returns the carrier of a body, also of one that was not near the box in the newest steps; null where it is not of this
        /// source.</summary>
        ICarriedBody CarrierOf(Component body);
    }
}
