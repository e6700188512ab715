using System;
using UnityEngine;

namespace Rill
{
    /// <summary>How two materials of a fluid act on each other, where that is not the default.</summary>
    [Serializable]
    public struct FluidMaterialPair
    {
        /// <summary>Largest <see cref="diffusion"/>, m²/s.</summary>
        public const float MaxDiffusion = 100f;

        /// <summary>One of the two; null for the fluid's own material.</summary>
        [Tooltip("One of the two. None: the fluid's own material.")]
        public FluidMaterialAsset first;

        /// <summary>The other one; null for the fluid's own material.</summary>
        [Tooltip("The other one. None: the fluid's own material.")]
        public FluidMaterialAsset second;

        /// <summary>Diffusivity D with which they mix, m²/s, 0 (they stay apart) to 100.</summary>
        /// <remarks>A border widens like √(2 D t) (Fick 1855). At most D Δt = 0.1 d² acts in a substep Δt, with a particle spacing d.</remarks>
        [Tooltip("Diffusivity with which they mix, m²/s. 0 (they stay apart) to 100: a border is 5 cm wide after a second with about 0.001. " +
            "Stirring mixes faster. More than 0.1 squared spacings a substep act like that.")]
        public float diffusion;

        /// <summary>Surface tension between them, N/m, 0 to 1000. 0: the difference of their tensions (Antonow 1907). At most their sum acts, and
        /// none where they mix.</summary>
        [Tooltip("Surface tension between them, N/m: it makes drops of one in the other round. 0: the difference of their surface tensions. Up to " +
            "1000; at most the sum of their surface tensions acts, and none where they mix.")]
        public float interfaceTension;

        /// <summary>Returns a pair that mixes.</summary>
        /// <param name="first">One of the two; null for the fluid's own material.</param>
        /// <param name="second">The other one.</param>
        /// <param name="diffusion">m²/s, 0 to 100.</param>
        public static FluidMaterialPair Mixing(FluidMaterialAsset first, FluidMaterialAsset second, float diffusion)
            => new FluidMaterialPair { first = first, second = second, diffusion = diffusion };

        /// <summary>Brings all values into their range.</summary>
        /// <param name="problem">Message for what was changed, or null.</param>
        internal void Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("diffusion", ref diffusion, 0f, MaxDiffusion, 0f, ref problem);
            Limit.Clamp("interface tension", ref interfaceTension, 0f, FluidMaterial.MaxTension, 0f, ref problem);
            if (first == second && (diffusion > 0f || interfaceTension > 0f))
                Limit.Append(ref problem, "both materials are the same, so nothing acts. Choose another for one of them");
        }
    }
}
