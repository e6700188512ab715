using Unity.Mathematics;

namespace Rill
{
    /// <summary>Tells when a level has changed by a step since it was told last. The first one is a change.</summary>
    struct LevelWatch
    {
        float last;
        bool isKnown;

        /// <param name="step">In the level's unit; 0 tells each change.</param>
        public bool Follow(float level, float step)
        {
            float change = math.abs(level - last);
            if (isKnown && !(change >= step && change > 0f))
                return false;
            last = level;
            isKnown = true;
            return true;
        }
    }
}
