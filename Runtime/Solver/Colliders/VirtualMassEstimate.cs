using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Mass of water that resists a body's changes of velocity, as a fraction of the water that it displaces, estimated from the forces
    /// that the water exerted: least squares, in which older steps count less, and a guess counts as much as a slip that resists with a
    /// small part of the weight.
    /// </summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]      // as it stands in snapshots
    struct VirtualMassEstimate
    {
        const float Memory = 0.5f;          // s
        const float GuessWeight = 0.02f;    // of gravity: forces are noisy
        const float Min = 0.1f, Max = 10f;

        float product, square;              // m²/s³

        /// <summary>Lets older steps count less.</summary>
        public void Age(float time)
        {
            float left = math.exp(-time / Memory);
            product *= left;
            square *= left;
        }

        /// <summary>Adds some steps. Those with the body out of the water tell nothing.</summary>
        /// <param name="change">Force of the water over the buoyancy, per kg of water that the whole body displaces, m/s².</param>
        /// <param name="slip">In which it was measured, over the time in which the water comes to move along, m/s².</param>
        /// <param name="fraction">Fraction of the body under water, 0 to 1.</param>
        /// <param name="time">s.</param>
        public void Add(Vector3 change, Vector3 slip, float fraction, float gravity, float guess, float time)
        {
            Vector3 resists = fraction * slip;
            float prior = fraction * GuessWeight * gravity;
            prior *= prior;
            product += (guess * prior - Vector3.Dot(change, resists)) * time;
            square += (prior + resists.sqrMagnitude) * time;
        }

        /// <summary>The guess while nothing is known.</summary>
        public float Or(float guess) => square > 0f ? math.clamp(product / square, Min, math.max(Max, guess)) : guess;
    }
}
