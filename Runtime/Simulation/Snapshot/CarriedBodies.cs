using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>The bodies that fluids carry by a component on them, in the order in which they were enabled.</summary>
    static class CarriedBodies
    {
        static List<ICarriedBody> enabled = new List<ICarriedBody>();

        public static List<ICarriedBody> Enabled => enabled;

        /// <summary>Names of the object and of those above it, from the highest on.</summary>
        public static string PathOf(Component body)
        {
            string path = body.name;
            for (Transform above = body.transform.parent; above != null; above = above.parent)
                path = above.name + "/" + path;
            return path;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetStatics() => enabled = new List<ICarriedBody>();
    }
}
