using UnityEngine;

namespace Rill
{
    /// <summary>The phases of a fluid whose surface shows each with a look of its own.</summary>
    readonly struct PhaseFrame
    {
        /// <summary>phases that have looks of their own, those beyond counting as the last</summary>
        [GenerateHlsl("PhaseFrame")] public const int MaxPhases = 4;

        /// <summary>See ParticleTags.hlsl; null where all particles look alike.</summary>
        public readonly GraphicsBuffer Tags;

        public PhaseFrame(GraphicsBuffer tags) => Tags = tags;

        public bool AreShown => Tags != null;

        /// <summary>Components of a texel of thickness.</summary>
        public int Components => AreShown ? MaxPhases : 1;
    }
}
