using System;

namespace Rill
{
    /// <summary>How large the textures of a camera's picture are made while what is in use of them changes from frame to frame: with dynamic
    /// resolution, a moving camera, a window that is resized.</summary>
    /// <remarks>They grow at once, with room to spare, and shrink only where the largest use of a second leaves much of them empty.</remarks>
    struct ScreenSize
    {
        const int Step = 32;            // texels
        const int Spare = 16;           // one part of so many
        const int Patience = 60;        // frames

        int width, height, widest, highest, frames;

        /// <summary>Texels.</summary>
        public int Width => width;

        /// <summary>Texels.</summary>
        public int Height => height;

        /// <summary>Asks for so many texels, once in a frame.</summary>
        /// <param name="maxWidth">Width of the whole picture: no room is spared beyond it.</param>
        /// <param name="maxHeight">The same.</param>
        /// <returns>Whether textures have to be made again, of <see cref="Width"/> and <see cref="Height"/>.</returns>
        public bool Fit(int neededWidth, int neededHeight, int maxWidth, int maxHeight)
        {
            widest = Math.Max(widest, neededWidth);
            highest = Math.Max(highest, neededHeight);
            if (neededWidth > width || neededHeight > height)
            {
                width = neededWidth > width ? WithRoom(neededWidth, maxWidth) : width;
                height = neededHeight > height ? WithRoom(neededHeight, maxHeight) : height;
                return true;
            }
            if (++frames < Patience)
                return false;
            int smallerWidth = WithRoom(widest, maxWidth), smallerHeight = WithRoom(highest, maxHeight);
            bool shrinks = 4L * smallerWidth * smallerHeight < 3L * width * height;
            if (shrinks)
                (width, height) = (smallerWidth, smallerHeight);
            widest = highest = frames = 0;
            return shrinks;
        }

        static int WithRoom(int needed, int max)
        {
            int roomy = (needed + needed / Spare + Step - 1) / Step * Step;
            return Math.Max(needed, Math.Min(roomy, max));
        }
    }
}
