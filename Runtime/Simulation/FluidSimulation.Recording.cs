using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Recordings: what is recorded after a step, and what is shown instead of steps.
    public sealed partial class FluidSimulation
    {
        [NonSerialized] IFluidPlayback playback;

        /// <summary>Whether the frames of a <c>FluidPlayback</c> replace the fluid's steps.</summary>
        public bool IsPlayedBack => playback != null;

        /// <summary>After the commands of a fixed step, with its number: for what is recorded of the state that it leaves.</summary>
        internal event Action<CommandBuffer, int> AfterStep;

        /// <summary>After the commands of all steps of a frame, with whether they were executed.</summary>
        internal event Action<bool> AfterSteps;

        /// <summary>What replaces the steps; null for none. The fluid then goes on from what is shown.</summary>
        internal IFluidPlayback Playback
        {
            get => playback;
            set
            {
                playback = value;
                if (value != null || pbf == null)
                    return;
                clock = default;
                lastFrameTime = FluidTime;
                pbf.ReleasePacking();
            }
        }

        /// <summary>Whether the shaders of recordings are there, which is logged once where not.</summary>
        internal bool CanRecord => HasBesideSteps(Features.Recording);

        // Instead of the steps of a frame.
        void ShowRecording(float frameTime)
        {
            lastFrameTime = FrameTime;
            FollowTransform();
            StandStill();
            ClearMotions();
            bool shows = playback.Advance(frameTime, pbf, out RecordedFrame frame, out bool follows);
            if (shows && CanRecord)
                Show(frame, follows);
            clock.Record = new ClockRecord { lag = playback.Lag };
            if (!follows)
                lastFrameTime = FrameTime;
        }

        void Show(RecordedFrame frame, bool follows)
        {
            input = StillInput();
            NeedsDensity = false;
            NeedsFoam = null;
            wanted = FeatureSet.None;
            LimitToDevice();
            commands.Clear();
            try
            {
                pbf.ShowFrame(commands, input, playback.Layout, frame, follows && playback.HasIds);
            }
            catch (ArgumentException problem)       // more than the device holds
            {
                Fail(problem.Message);
                return;
            }
            StepCount = frame.step;
            FluidTime = frame.time;
            stepsSinceStatistics++;
            Execute();
        }

        // Of a step in which nothing acts: each particle goes on as it is.
        StepInput StillInput()
        {
            SolverSettings settings = solver;
            settings.substeps = 1;
            settings.iterations = 0;
            settings.deepWater = DeepWater.Off;
            settings.sleepSpeed = 0f;
            settings.numericalDamping = 1f;
            FluidMaterial still = material;
            still.velocitySmoothing = still.dynamicViscosity = still.shearModulus = still.vorticity = still.artificialPressure = 0f;
            effective = settings;
            return new StepInput { timeStep = FixedStep, gravity = float3.zero, settings = settings, material = still, needsDensity = NeedsDensity };
        }
    }
}
