using System.Collections;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Frames of a fixed length that always lie alike to the steps of the physics. What a body does depends on how they lie, and what
    /// was played before a test leaves them anyhow.</summary>
    static class PhysicsClock
    {
        const float BehindStep = 0.1f;

        /// <summary>Plays one frame that ends a tenth of a step behind a step of the physics.</summary>
        /// <param name="frame">Length of the frames after it, s.</param>
        public static IEnumerator Begin(float frame)
        {
            Time.captureDeltaTime = (float)(Time.fixedTimeAsDouble + (1f + BehindStep) * Time.fixedDeltaTime - Time.timeAsDouble);
            yield return null;
            Time.captureDeltaTime = frame;
        }
    }
}
