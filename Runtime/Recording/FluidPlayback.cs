using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Plays a recording of a <see cref="FluidRecorder"/> instead of the steps of the <see cref="FluidSimulation"/> on this object: the
    /// frames' particles are put into the fluid, and renderers, probes, detectors and scripts find them as after a step. Nothing is solved.
    /// </summary>
    /// <remarks>
    /// Between two frames each particle goes on along its velocity; without velocities the frame before is shown. A thread of its own reads
    /// the frames, those that come next ahead of time. Emitters, drains, colliders, force fields and foam do nothing meanwhile. When the
    /// recording is closed, or this is disabled, the fluid goes on from the frame that is shown.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Playback"), Icon(PackagePaths.Icon), ManualPage("state", "fluid-playback")]
    [RequireComponent(typeof(FluidSimulation))]
    [DisallowMultipleComponent]
    public sealed partial class FluidPlayback : MonoBehaviour, IFluidPlayback, IUsesFeatures, IHasProblems, IRunsInEditMode, IAppliesSettings
    {
        const float MaxSpeed = 100f;
        const double Tolerance = 1e-5;      // s: by which a time that is meant to be a frame's may fall short of it

        [Tooltip("Recording that is opened when this is enabled. A relative path begins in the StreamingAssets folder. Empty: none is.")]
        [SerializeField] string recording = "";

        [Tooltip("Plays once it is opened. Off: it shows the first frame.")]
        [SerializeField] bool playOnEnable = true;

        [Tooltip("Seconds of the recording in a second of the game, -100 to 100. Below 0 it plays backwards.")]
        [Range(-MaxSpeed, MaxSpeed)]
        [SerializeField] float speed = 1f;

        [Tooltip("Starts again at its end.")]
        [SerializeField] bool loop;

        [Tooltip("Makes the game wait for a frame that is not read yet: for films that are rendered frame by frame. Off: the last " +
            "frame stays, which is counted.")]
        [SerializeField] bool waitForFrames;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] FluidSimulation simulation;
        RecordingReader reader;
        FrameReadAhead frames;
        [NonSerialized] string opened, problem;
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] double time;
        [NonSerialized] bool hasJumped, goesBack;
        PbfSolver shownSolver;      // which the shown frame is in
        [NonSerialized] int shownGeneration;
        [NonSerialized] string refused;             // why it does not fit, of the solver that was looked at
        PbfSolver checkedSolver;

        /// <summary>Path of the recording that is opened when this is enabled; a relative one begins in the StreamingAssets folder. Empty
        /// for none. Takes effect when this is enabled next; <see cref="Open"/> opens one at once.</summary>
        public string Recording { get => recording; set => recording = value ?? ""; }

        /// <summary>Whether a recording plays once it is opened; if not, it shows the first frame.</summary>
        public bool PlayOnEnable { get => playOnEnable; set => playOnEnable = value; }

        /// <summary>Whether a recording is open; the fluid then takes no steps.</summary>
        public bool IsOpen => reader != null;

        /// <summary>Whether time passes in the recording.</summary>
        [field: NonSerialized] public bool IsPlaying { get; private set; }

        /// <summary>Time that is shown since the first frame, s, 0 to <see cref="Duration"/>. Set it to go anywhere, also while paused; it
        /// is brought into that range.</summary>
        /// <exception cref="ArgumentException">Set to NaN.</exception>
        public double Time
        {
            get => time;
            set
            {
                if (double.IsNaN(value))
                    throw new ArgumentException(
                        $"FluidPlayback '{name}': a time must be a number. Give seconds since the first frame.", nameof(value));
                double to = Clamped(value);
                goesBack = to < time;
                hasJumped |= to != time;
                time = to;
            }
        }

        /// <summary>Time from the first frame to the last, s; 0 where none is open.</summary>
        public double Duration => FrameCount > 0 ? TimeOf(FrameCount - 1) : 0.0;

        /// <summary>Frames of the recording; 0 where none is open.</summary>
        public int FrameCount => reader?.FrameCount ?? 0;

        /// <summary>Time of a frame since the first, s.</summary>
        /// <param name="frame">0 to <see cref="FrameCount"/> - 1.</param>
        /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
        public double TimeOf(int frame)
        {
            if (frame < 0 || frame >= FrameCount)
                throw Limit.OutOfRange(nameof(frame), frame, Invariant($"The recording has {FrameCount:N0} frames."));
            return reader.TimeOf(frame) - reader.TimeOf(0);
        }

        /// <summary>Number of the frame that the fluid shows, from 0; -1 before the first has been read.</summary>
        [field: NonSerialized] public int ShownFrame { get; private set; } = -1;

        /// <summary>Times that a frame was not read when it should have been shown, since the recording was opened: the frame before
        /// stayed.</summary>
        [field: NonSerialized] public int MissedFrames { get; private set; }

        /// <summary>Whether the recording has no index that can be read, as of a player that was ended while it recorded: it then ends with
        /// the last whole frame.</summary>
        public bool WasCutShort => reader != null && reader.WasCutShort;

        /// <summary>Whether each of its particles has an id that stays the same from frame to frame.</summary>
        public bool HasIds => reader != null && reader.Header.Layout.Has(RecordingFields.Ids);

        /// <summary>Seconds of the recording in a second of the game, -100 to 100; below 0 it plays backwards. Out-of-range values are
        /// clamped with a warning.</summary>
        public float Speed { get => speed; set { speed = value; Changed(); } }

        /// <summary>Whether it begins again at its end.</summary>
        public bool Loop { get => loop; set => loop = value; }

        /// <summary>Whether the game waits for a frame that is not read yet: for films that are rendered frame by frame.</summary>
        public bool WaitForFrames { get => waitForFrames; set => waitForFrames = value; }

        /// <summary>Why the recording is not shown, or a frame of it was left out, and what to do; null where nothing is wrong.</summary>
        public string Problem => problem;

        internal FrameLayout Layout => reader.Header.Layout;

        FrameLayout IFluidPlayback.Layout => Layout;

        double IFluidPlayback.Lag => Lag;

        bool IFluidPlayback.Advance(float seconds, PbfSolver solver, out RecordedFrame frame, out bool follows)
            => Advance(seconds, solver, out frame, out follows);

        /// <summary>Time of the shown picture since the shown frame, s.</summary>
        [field: NonSerialized] internal double Lag { get; private set; }

        /// <summary>Replaces the file: for tests.</summary>
        internal Func<string, Stream> OpenFile { get; set; } = File.OpenRead;

        /// <summary>Replaces Application.platform: for tests.</summary>
        internal RuntimePlatform? Platform { get; set; }

        FeatureSet IUsesFeatures.UsedFeatures => Features.Recording;

        StageReferences IUsesFeatures.StageReferences => shaders;

        /// <summary>Opens a recording at its first frame. It plays where Play On Enable is on, else call <see cref="Play"/> or set
        /// <see cref="Time"/>. One that was open is closed.</summary>
        /// <param name="file">Its path; a relative one begins in the StreamingAssets folder, which holds no files on Android.</param>
        /// <exception cref="ArgumentNullException">No path.</exception>
        /// <exception cref="InvalidOperationException">This is disabled, or the platform is WebGL.</exception>
        /// <exception cref="InvalidDataException">The file is not a recording, is damaged, holds no frame or is of a newer version.</exception>
        /// <exception cref="IOException">The file cannot be read; as for other exceptions of File.OpenRead.</exception>
        public void Open(string file)
        {
            if (file == null)
                throw new ArgumentNullException(nameof(file));
            if ((Platform ?? Application.platform) == RuntimePlatform.WebGLPlayer)
                throw new InvalidOperationException(
                    $"FluidPlayback '{name}' cannot play: WebGL has no threads, one of which reads the file. Play on another platform.");
            if (!isActiveAndEnabled)
                throw new InvalidOperationException($"FluidPlayback '{name}' is disabled: enable it before you open a recording.");
            Close();
            var next = new RecordingReader(OpenFile(PathOf(file)));
            if (next.FrameCount == 0)
            {
                next.Dispose();
                throw new InvalidDataException($"'{file}' holds no whole frame. Record again, and call Stop before the player ends.");
            }
            (reader, opened, time, problem) = (next, file, 0.0, null);
            frames = new FrameReadAhead(reader);
            (MissedFrames, hasJumped, goesBack, IsPlaying) = (0, true, speed < 0f, playOnEnable);
            simulation.Playback.Source = this;
        }

        /// <summary>Closes the recording. The fluid goes on from the frame that is shown.</summary>
        public void Close()
        {
            if (!IsOpen)
                return;
            if (simulation != null)
                simulation.Playback.Source = null;
            frames.Dispose();
            (frames, reader, opened) = (null, null, null);
            (ShownFrame, Lag, IsPlaying, IsDriven) = (-1, 0.0, false, false);
            shownSolver = checkedSolver = null;
            refused = null;
        }

        /// <summary>Lets time pass in the recording; from its start if it stands at its end, or vice versa if the speed is
        /// below 0.</summary>
        public void Play()
        {
            if (!loop && time >= Duration && speed > 0f)
                Time = 0.0;
            else if (!loop && time <= 0.0 && speed < 0f)
                Time = Duration;
            IsPlaying = IsOpen;
        }

        /// <summary>Lets time stand still in the recording.</summary>
        public void Pause() => IsPlaying = false;

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => TryGetComponent(out FluidSimulation own) && own == fluid;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(problem);
        }

        /// <summary>Lets the time of a frame pass.</summary>
        /// <param name="seconds">Time of the game, s.</param>
        /// <param name="frame">What to show; null where what is shown stays.</param>
        /// <param name="follows">Whether it goes on from what was shown: false after a jump.</param>
        internal bool Advance(float seconds, PbfSolver solver, out RecordedFrame frame, out bool follows)
        {
            frame = null;
            bool isShown = ShownFrame >= 0 && solver == shownSolver && solver.Generation == shownGeneration;
            bool hasWrapped = IsPlaying && !IsDriven && Pass(seconds);
            follows = isShown && !hasJumped && !hasWrapped;
            if (!Fits(solver))
                return false;
            double at = reader.TimeOf(0) + time;
            int number = reader.FrameAt(at + Tolerance);
            if (!isShown || number != ShownFrame)
            {
                frame = frames.Take(number, !goesBack, waitForFrames, out string failure);
                if (frame == null)
                {
                    MissedFrames++;
                    follows = isShown;
                    if (failure != null)
                        LogProblem(Invariant($"leaves out frame {number:N0} of '{opened}': {failure}"));
                    return false;
                }
                (ShownFrame, shownSolver, shownGeneration) = (number, solver, solver.Generation);
            }
            hasJumped = false;
            Lag = Layout.Has(RecordingFields.Velocities) ? Math.Max(at - reader.TimeOf(number), 0.0) : 0.0;
            return frame != null;
        }

        void OnEnable()
        {
            simulation = GetComponent<FluidSimulation>();
            shaders.Hold();
            if (string.IsNullOrEmpty(recording) || DeviceGate.HasNoGraphics)
                return;
            try
            {
                Open(recording);
            }
            catch (Exception refusal) when (IsOfFile(refusal) || refusal is InvalidOperationException)
            {
                LogProblem($"does not play '{recording}': {refusal.Message}");
            }
        }

        void OnDisable()
        {
            Close();
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            string outOfRange = null;
            Limit.Clamp("speed", ref speed, -MaxSpeed, MaxSpeed, 1f, ref outOfRange);
            clamped.Set(outOfRange);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(Features.Recording);
        }

        string PathOf(string file)
        {
            if ((Platform ?? Application.platform) == RuntimePlatform.Android && !Path.IsPathRooted(file))
                throw new IOException($"on Android the StreamingAssets folder is packed into the app, where '{file}' is not a file. Copy it " +
                    "to Application.persistentDataPath by a UnityWebRequest, and call Open with the path of the copy.");
            return Path.Combine(Application.streamingAssetsPath, file);
        }

        // Tells whether an exception is one that opening a file and reading its index throws.
        static bool IsOfFile(Exception refusal) => refusal is IOException || refusal is InvalidDataException
            || refusal is UnauthorizedAccessException || refusal is ArgumentException || refusal is NotSupportedException;

        // Whether it began again.
        bool Pass(float seconds)
        {
            double to = time + (double)seconds * speed;
            goesBack = speed < 0f;
            time = Clamped(to);
            bool isOver = speed > 0f ? to >= Duration : speed < 0f && to <= 0.0;
            if (!isOver)
                return false;
            if (loop && Duration > 0.0)
            {
                time = to - Math.Floor(to / Duration) * Duration;
                return true;
            }
            IsPlaying = loop;
            return false;
        }

        double Clamped(double value) => Math.Min(Math.Max(value, 0.0), Duration);

        bool Fits(PbfSolver solver)
        {
            if (solver != checkedSolver)
            {
                checkedSolver = solver;
                refused = reader.Header.ProblemFor(solver.Layout, reader.MaxParticles);
                if (refused != null)
                    LogProblem($"does not show '{opened}': {refused}");
            }
            return refused == null;
        }

        // Logs a problem, once if it comes several times in a row.
        void LogProblem(string what)
        {
            if (what == problem)
                return;
            problem = what;
            Debug.LogError($"Rill: FluidPlayback '{name}' {what}", this);
        }
    }
}
