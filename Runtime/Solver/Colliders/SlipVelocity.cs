using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>
    /// Velocity of a body against the water around it. Water that is pushed comes to move along: after a change of the body's
    /// velocity the slip decays by exp(-t / memory). Also of angular velocities.
    /// </summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]      // as it stands in snapshots
    struct SlipVelocity
    {
        float3 velocity;        // of the body

        /// <summary>At the end of the time followed so far.</summary>
        public float3 Now { get; private set; }

        /// <summary>Follows a body that took a velocity and kept it for a time.</summary>
        /// <param name="time">s, above 0.</param>
        /// <param name="memory">Memory of the water, s, above 0.</param>
        /// <returns>Mean slip over that time.</returns>
        public float3 Follow(float3 next, float time, float memory)
        {
            float3 begin = Now + next - velocity;
            velocity = next;
            Now = begin * math.exp(-time / memory);
            return begin * MeanFraction(time, memory);
        }

        /// <summary>Mean slip over a time, as a fraction of the slip at its beginning.</summary>
        public static float MeanFraction(float time, float memory) => (1f - math.exp(-time / memory)) * memory / time;
    }
}
