using System;

namespace Rill
{
    /// <summary>Turns frame times into whole fixed steps; a hitch longer than the cap is dropped and counted, not caught up with.</summary>
    struct FixedStepClock
    {
        // Frame times summed in floating point fall a hair short of whole steps; without this the steps would stutter.
        const double Tolerance = 1e-4;

        const int SoonAfter = 10;       // frames with steps

        double accumulated, passing;
        int sinceDrop;

        /// <summary>Time that the cap dropped since the start, s.</summary>
        public double Dropped { get; private set; }

        /// <summary>Time from the frame before the last that took steps to that last one, s: in which what is drawn once a frame of steps
        /// has moved.</summary>
        public double FrameInterval { get; private set; }

        /// <summary>Time by which the steps so far stay behind the newest frame, s: less than a step.</summary>
        public double Lag { get; private set; }

        /// <summary>Time by which the steps of that last frame lag it, s: less than a step.</summary>
        public double FrameLag { get; private set; }

        /// <summary>Time by which the steps of the frame before it stayed behind, s.</summary>
        public double LastFrameLag { get; private set; }

        /// <summary>Time that the cap dropped of the last frame that took steps, s.</summary>
        public double FrameDropped { get; private set; }

        /// <summary>Frames in a row that took steps and dropped time, up to the last.</summary>
        public int DroppingFrames { get; private set; }

        /// <summary>Fluid time that the last frame with steps took, over the time that had passed: below 1 where it dropped some.</summary>
        public double FrameRate => FrameDropped > 0.0 ? 1.0 - FrameDropped / FrameInterval : 1.0;

        /// <summary>Whether time was dropped in one of the last frames that took steps.</summary>
        public bool DropsTime => sinceDrop > 0;

        /// <summary>All that the next frames need, for a snapshot.</summary>
        public ClockRecord Record
        {
            get => new ClockRecord
            {
                accumulated = accumulated, passing = passing, dropped = Dropped, frameInterval = FrameInterval,
                lag = Lag, frameLag = FrameLag, lastFrameLag = LastFrameLag
            };
            set
            {
                accumulated = value.accumulated;
                passing = value.passing;
                Dropped = value.dropped;
                FrameInterval = value.frameInterval;
                Lag = value.lag;
                FrameLag = value.frameLag;
                LastFrameLag = value.lastFrameLag;
            }
        }

        /// <summary>Puts what it knows of dropped time into a snapshot.</summary>
        public void SaveDrops(ref CallsRecord to)
        {
            to.frameDropped = FrameDropped;
            to.droppingFrames = DroppingFrames;
            to.sinceDrop = sinceDrop;
        }

        /// <summary>Takes it out of one.</summary>
        public void LoadDrops(in CallsRecord from)
        {
            FrameDropped = from.frameDropped;
            DroppingFrames = from.droppingFrames;
            sinceDrop = from.sinceDrop;
        }

        /// <summary>Steps to take for a frame.</summary>
        /// <param name="frameTime">s, not negative.</param>
        /// <param name="step">Length of a fixed step, s, above 0.</param>
        /// <param name="maxSteps">Cap, at least 1.</param>
        public int Advance(double frameTime, double step, int maxSteps)
        {
            accumulated += frameTime;
            double due = Math.Floor(accumulated / step + Tolerance);
            int steps = (int)Math.Min(due, maxSteps);
            Dropped += (due - steps) * step;
            accumulated = Math.Max(accumulated - due * step, 0.0);
            Lag = accumulated > Tolerance * step ? accumulated : 0.0;
            passing += frameTime;
            if (steps > 0)
            {
                FrameInterval = passing > 0.0 ? passing : steps * step;        // a shorter step may be due without a frame's time
                passing = 0.0;
                LastFrameLag = FrameLag;
                FrameLag = Lag;
                FrameDropped = (due - steps) * step;
                DroppingFrames = FrameDropped > 0.0 ? DroppingFrames + 1 : 0;
                sinceDrop = FrameDropped > 0.0 ? SoonAfter : Math.Max(sinceDrop - 1, 0);
            }
            return steps;
        }
    }
}
