using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The time of a fluid: how fast it passes, the fixed steps that fit into a frame, and the time that frames drop.</summary>
    sealed class FluidClock
    {
        const int DroppingFrames = 5;       // in a row, before it is logged: a single hitch is not worth a message
        const int DroppedTime = 0;          // problem of the log

        readonly FluidSimulation fluid;
        readonly BoxCulling culling;
        FixedStepClock clock;
        OnceLog log;
        double lastFrameTime;       // FrameTime of the frame before, s
        float? editorTime;          // for the next frame, s; null where none has come since the last

        public FluidClock(FluidSimulation fluid)
        {
            this.fluid = fluid;
            culling = new BoxCulling(fluid);
        }

        /// <summary>Fixed steps taken since the last restart.</summary>
        public int StepCount { get; private set; }

        /// <summary>Fluid time since the last restart, s.</summary>
        public double FluidTime { get; private set; }

        /// <summary>Fluid time of the current frame since the last restart, s.</summary>
        public double FrameTime => FluidTime + clock.Lag;

        /// <summary>The fixed steps of the last frames.</summary>
        public FixedStepClock Steps => clock;

        /// <summary>Whether no camera saw the box in the last frame, so that the fluid was slowed or paused.</summary>
        public bool IsCulled => culling.IsCulled;

        /// <summary>Whether one of the last frames was so long that the fluid dropped time.</summary>
        public bool DropsTime => clock.DropsTime;

        /// <summary>How fast the fluid's time passes in the game's: 1 unless it drops some.</summary>
        public float RateOfTime => (float)clock.FrameRate;

        /// <summary>The fluid's time of the current frame since the newest state, x, and that of the frame before, z, in substeps; y and w
        /// the same in s.</summary>
        public Vector4 FrameLag
        {
            get
            {
                double now = clock.Lag, before = lastFrameTime - FluidTime, substep = fluid.FixedStep / Math.Max(fluid.Solver.LastSubsteps, 1);
                return new Vector4((float)(now / substep), (float)now, (float)(before / substep), (float)before);
            }
        }

        /// <summary>Lets the next long frames be logged again, as the fluid begins.</summary>
        public void Begin() => log.Reset();

        /// <summary>Sets all time to 0.</summary>
        public void Restart()
        {
            clock = default;
            StepCount = 0;
            FluidTime = 0.0;
            lastFrameTime = 0.0;
        }

        /// <summary>Gives the fluid the time of the next frame in the Editor without Play, s; 0 stands for a pause.</summary>
        public void GiveTime(float seconds) => editorTime = seconds;

        /// <summary>Returns the time of this frame. The Editor also calls LateUpdate between two of its times, where something of the scene
        /// changed: false then.</summary>
        public bool TryTakeTime(out float seconds)
        {
            if (!fluid.IsInEditMode)
            {
                seconds = Time.deltaTime;
                return true;
            }
            seconds = editorTime ?? 0f;
            bool hasTime = editorTime.HasValue;
            editorTime = null;
            return hasTime;
        }

        /// <summary>Begins a frame.</summary>
        public void BeginFrame() => lastFrameTime = FrameTime;

        /// <summary>Returns how fast the fluid's time passes in this frame, 0 to 1. In the Editor without Play neither the stored pause counts
        /// nor which camera sees the box.</summary>
        public float Rate(float frameTime)
        {
            if (fluid.IsInEditMode)
                return frameTime > 0f ? 1f : 0f;
            return culling.TimeRate();
        }

        /// <summary>Lets time pass, and returns the fixed steps that are due.</summary>
        /// <param name="frameTime">s.</param>
        public int Advance(float frameTime)
        {
            int steps = clock.Advance(frameTime, fluid.FixedStep, fluid.MaxStepsPerFrame);
            LogDroppedTime(frameTime);
            return steps;
        }

        /// <summary>Counts steps that were recorded.</summary>
        public void Count(int steps)
        {
            StepCount += steps;
            FluidTime += steps * (double)fluid.FixedStep;
        }

        /// <summary>Takes the time of a recorded frame.</summary>
        public void Show(int step, double time)
        {
            StepCount = step;
            FluidTime = time;
        }

        /// <summary>Ends a frame that shows a recording.</summary>
        /// <param name="lag">Time by which the recorded state lags the frame, s.</param>
        /// <param name="follows">Whether it goes on from the frame before.</param>
        public void EndShown(double lag, bool follows)
        {
            clock.Record = new ClockRecord { lag = lag };
            if (!follows)
                lastFrameTime = FrameTime;
        }

        /// <summary>Goes on from the recorded state that is shown.</summary>
        public void ContinueFromShown()
        {
            clock = default;
            lastFrameTime = FluidTime;
        }

        public void Save(ref TimeRecord to)
        {
            to.stepCount = StepCount;
            to.fluidTime = FluidTime;
            to.lastFrameTime = lastFrameTime;
            to.clock = clock.Record;
        }

        public void Save(ref CallsRecord to) => clock.SaveDrops(ref to);

        public void Load(in TimeRecord from)
        {
            StepCount = from.stepCount;
            FluidTime = from.fluidTime;
            lastFrameTime = from.lastFrameTime;
            clock.Record = from.clock;
        }

        public void Load(in CallsRecord from) => clock.LoadDrops(from);

        void LogDroppedTime(float frameTime)
        {
            if (clock.DroppingFrames < DroppingFrames || fluid.IsInEditMode || !log.ShouldLog(DroppedTime))
                return;
            Debug.LogWarning(Invariant($"Rill: FluidSimulation '{fluid.name}' drops time, and runs slower than the game: frames of ") +
                Invariant($"{frameTime:0.###} s need {Math.Ceiling(frameTime * fluid.StepRate - 1e-3f):0} fixed steps, and Max Steps Per ") +
                Invariant($"Frame is {fluid.MaxStepsPerFrame}. Raise Max Steps Per Frame, to 16 at most, or lower Step Rate."), fluid);
        }
    }
}
