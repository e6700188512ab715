using System.Collections.Generic;

namespace Rill
{
    /// <summary>Problems of a project's render settings for fluid surfaces: each adapter of a render pipeline has one, the inspector shows
    /// them.</summary>
    interface IRenderSetup
    {
        /// <summary>Found again at each call; none where the pipeline is not in use.</summary>
        IEnumerable<SetupProblem> Problems { get; }

        /// <summary>The last surface has ended: cameras are to be as they were.</summary>
        void End();
    }
}
