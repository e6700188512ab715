using System;
using System.Collections.Generic;
using System.IO;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Records the particles of the <see cref="FluidSimulation"/> on this object into a file, for a <see cref="FluidPlayback"/>. Nothing
    /// waits: the GPU packs each frame, it comes back two or three frames later, and a thread of its own writes it.
    /// </summary>
    /// <remarks>
    /// It stops, and logs why, where the disk falls behind by <see cref="BufferedFrames"/>, where it is full, and where the fluid starts again.
    /// All that was written until then is complete and can be played. Recording changes nothing in the fluid. WebGL has no threads and so no
    /// recordings.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Recorder"), Icon(PackagePaths.Icon), ManualPage("state", "fluid-recorder")]
    [RequireComponent(typeof(FluidSimulation))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 100)]    // after the simulation's step
    public sealed class FluidRecorder : MonoBehaviour, IUsesFeatures, IHasProblems, IAppliesSettings
    {
        const int MinBuffers = 4, MaxBuffers = 64, DefaultBuffers = 12;
        const float MaxRate = 1000f;
        const int MaxWait = 10_000;     // for the disk, of a recorder that is disabled, ms

        [Tooltip("Values stored for each particle besides its position. Velocities: 6 bytes; phases: 1 byte; ids: 4 bytes.")]
        [SerializeField] RecordingFields fields = RecordingFields.Velocities | RecordingFields.Phases | RecordingFields.Ids;

        [Tooltip("Frames that are recorded for a second of fluid time, 1/s, at most one for each step. 0: every step.")]
        [Range(0f, MaxRate)]
        [SerializeField] float rate;

        [Tooltip("Frames that may wait for the disk, 4 to 64. Memory is taken for them as they are needed; when all wait, the recording stops.")]
        [Range(MinBuffers, MaxBuffers)]
        [SerializeField] int bufferedFrames = DefaultBuffers;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        /// <summary>A packed frame pending from the GPU. Used again for others.</summary>
        sealed class Transfer
        {
            public readonly Action<AsyncGPUReadbackRequest> arrived;
            public GraphicsBuffer buffer;
            public RecordedFrame frame;
            public AsyncGPUReadbackRequest request;
            public int most;        // particles

            public Transfer(FluidRecorder recorder) => arrived = request => recorder.OnArrived(this, request);
        }

        readonly Stack<Transfer> idle = new Stack<Transfer>();
        readonly List<Transfer> recorded = new List<Transfer>(), coming = new List<Transfer>();      // before and after their commands are executed
        [NonSerialized] FluidSimulation simulation;
        RecordingWriter writer;
        RecordingHeader header;
        PbfSolver solver;
        [NonSerialized] string path, problem;
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] double startTime;
        [NonSerialized] long lastFrame;
        [NonSerialized] int lastStep, buffers;

        /// <summary>Values stored for each particle besides its position, in the next recording.</summary>
        public RecordingFields Fields { get => fields; set => fields = value & RecordingFields.All; }

        /// <summary>Frames that are recorded for a second of fluid time, 1/s, 0 to 1,000; 0 for every step. Out-of-range values are clamped
        /// with a warning.</summary>
        public float Rate { get => rate; set { rate = value; Changed(); } }

        /// <summary>Frames that may wait for the disk, 4 to 64; of the next recording. Out-of-range values are clamped with a warning.</summary>
        public int BufferedFrames { get => bufferedFrames; set { bufferedFrames = value; Changed(); } }

        /// <summary>Whether frames are being recorded.</summary>
        [field: NonSerialized] public bool IsRecording { get; private set; }

        /// <summary>Whether the file is still being written, which goes on for some frames after <see cref="Stop"/>.</summary>
        public bool IsWriting => writer != null && !writer.IsDone;

        /// <summary>Frames of the newest recording that are in its file.</summary>
        public int FrameCount => writer?.FramesWritten ?? 0;

        /// <summary>Size of the newest recording's file so far, bytes.</summary>
        public long FileSize => writer?.BytesWritten ?? 0;

        /// <summary>Why the newest recording stopped by itself, and what to do; null where it did not.</summary>
        public string Problem => problem;

        /// <summary>Replaces the file: for tests.</summary>
        internal Func<string, Stream> OpenFile { get; set; } = File.Create;

        /// <summary>Replaces Application.platform: for tests.</summary>
        internal RuntimePlatform? Platform { get; set; }

        FeatureSet IUsesFeatures.UsedFeatures => Features.Recording;

        StageReferences IUsesFeatures.StageReferences => shaders;

        /// <summary>Starts to record into a file, with the next step. A file of that name is replaced.</summary>
        /// <param name="file">Its path; the folder has to be there.</param>
        /// <exception cref="ArgumentNullException">No path.</exception>
        /// <exception cref="InvalidOperationException">This or the simulation is not running, it already records, the platform is WebGL, or
        /// the stage Recording is not in this build.</exception>
        /// <exception cref="IOException">The file cannot be made; as for other exceptions of File.Create.</exception>
        public void Record(string file)
        {
            if (file == null)
                throw new ArgumentNullException(nameof(file));
            if ((Platform ?? Application.platform) == RuntimePlatform.WebGLPlayer)
                throw new InvalidOperationException($"FluidRecorder '{name}' cannot record: WebGL has no threads, one of which writes " +
                    $"the file. Record in the Editor or on another platform; snapshots work everywhere.");
            if (!isActiveAndEnabled || !simulation.IsRunning)
                throw new InvalidOperationException($"FluidRecorder '{name}' or its FluidSimulation is not running: enable both before you record.");
            if (IsRecording || IsWriting)
                throw new InvalidOperationException(
                    $"FluidRecorder '{name}' already records into '{path}': call Stop, and wait until IsWriting is false.");
            if (!simulation.Playback.IsSupported)
                throw new InvalidOperationException($"FluidRecorder '{name}' cannot record: {StageShader.MissingProblem("Recording")}");
            solver = simulation.Solver;
            header = new RecordingHeader(solver.Layout, fields);
            writer = new RecordingWriter(OpenFile(file), header, bufferedFrames);
            (path, problem, buffers) = (file, null, bufferedFrames);
            (lastFrame, lastStep) = (-1, simulation.StepCount);
            simulation.Steps.AfterStep += OnStep;
            simulation.Steps.AfterSteps += OnSteps;
            IsRecording = true;
        }

        /// <summary>Ends the recording. Frames pending are still written, then the index; <see cref="IsWriting"/> says when that is done.
        /// Nothing waits for it.</summary>
        public void Stop()
        {
            if (!IsRecording)
                return;
            IsRecording = false;
            simulation.Steps.AfterStep -= OnStep;
            FinishIfAll();
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(problem);
        }

        void OnEnable()
        {
            simulation = GetComponent<FluidSimulation>();
            shaders.Hold();
        }

        // Waits for the GPU and the disk: the file is whole when this is off, and nothing is left pending.
        void OnDisable()
        {
            Stop();
            while (coming.Count > 0)
            {
                Transfer transfer = coming[0];
                transfer.request.WaitForCompletion();
                OnArrived(transfer, transfer.request);      // if its callback has not come
            }
            foreach (Transfer transfer in recorded)         // a pass of a script disabled this: its step is yet to be executed
                ReleaseFrame(transfer);
            writer?.Finish();
            if (writer != null && !writer.Join(MaxWait))
                Debug.LogError($"Rill: FluidRecorder '{name}': the disk did not take the last frames of '{path}' within " +
                    Invariant($"{MaxWait / 1000} s. Those before them can be played; the rest is written if the player goes on."), this);
            Check();
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            string outOfRange = null;
            Limit.Clamp("rate", ref rate, 0f, MaxRate, 0f, ref outOfRange);
            Limit.Clamp("buffered frames", ref bufferedFrames, MinBuffers, MaxBuffers, ref outOfRange);
            clamped.Set(outOfRange);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(Features.Recording);
        }

        void LateUpdate() => Check();

        // Checks for errors of the disk.
        void Check()
        {
            if (writer == null || problem != null || writer.Problem == null)
                return;
            Fail($"the disk did not take it: {writer.Problem} Make room, or record to another disk.");
        }

        // After the commands of a step, before they are executed.
        void OnStep(CommandBuffer commands, int step)
        {
            if (!IsRecording)
                return;
            Check();
            if (simulation.Solver != solver || step <= lastStep)
            {
                Fail("the fluid was started again, restored or replaced, and a recording is of one run. Call Record again.");
                return;
            }
            lastStep = step;
            double time = simulation.FluidTime + (step - simulation.StepCount) * (double)simulation.FixedStep;
            if (problem != null || !IsDue(time))
                return;
            RecordedFrame frame = writer.TryReserve();
            if (frame == null)
            {
                int fromGpu = recorded.Count + coming.Count;
                Fail(Invariant($"all {buffers} frames that Buffered Frames allows are pending, {fromGpu} from the GPU and ") +
                    Invariant($"{buffers - fromGpu} to the disk. Record fewer Fields or at a lower Rate, raise Buffered Frames, or use ") +
                    "a faster disk.");
                return;
            }
            frame.step = step;
            frame.time = time;
            Transfer transfer = idle.Count > 0 ? idle.Pop() : new Transfer(this);
            transfer.buffer ??= GpuBuffer.Structured<uint>("Rill.RecordedFrame", FrameLayout.PackedHeader + header.Layout.Words(header.Capacity));
            transfer.frame = frame;
            solver.RecordFrame(commands, header.Layout, transfer.buffer);
            recorded.Add(transfer);
        }

        // The first step is, and then the first at or after each interval since.
        bool IsDue(double time)
        {
            if (rate <= 0f)
                return true;
            if (lastFrame < 0)
                startTime = time;
            var due = (long)Math.Floor((time - startTime) * rate + 1e-4);      // as much as times summed in floating point fall short
            if (due == lastFrame)
                return false;
            lastFrame = due;
            return true;
        }

        // After they are executed, or given up.
        void OnSteps(bool areExecuted)
        {
            if (!areExecuted)
                (lastStep, lastFrame) = (simulation.StepCount, lastFrame - recorded.Count);     // they will be taken again
            foreach (Transfer transfer in recorded)
            {
                if (!areExecuted || transfer.frame == null)
                {
                    ReleaseFrame(transfer);
                    idle.Push(transfer);
                    continue;
                }
                coming.Add(transfer);
                transfer.most = solver.MaxAlive;
                var bytes = (int)(sizeof(uint) * (FrameLayout.PackedHeader + header.Layout.Words(transfer.most)));
                transfer.request = AsyncGPUReadback.Request(transfer.buffer, bytes, 0, transfer.arrived);
            }
            recorded.Clear();
            FinishIfAll();
        }

        void OnArrived(Transfer transfer, AsyncGPUReadbackRequest request)
        {
            if (transfer.frame == null)     // this was disabled, and waited for it
                return;
            coming.Remove(transfer);
            idle.Push(transfer);
            RecordedFrame frame = transfer.frame;
            if (request.hasError)
            {
                ReleaseFrame(transfer);
                Fail("the GPU did not give a frame back. Record again.");
            }
            else
            {
                NativeArray<uint> words = request.GetData<uint>();
                frame.particles = (int)Math.Min(words[0], (uint)transfer.most);
                frame.nextId = words[1];
                NativeArray<uint>.Copy(words, FrameLayout.PackedHeader, frame.words, 0, (int)header.Layout.Words(frame.particles));
                transfer.frame = null;
                writer.Write(frame);
            }
            FinishIfAll();
        }

        void ReleaseFrame(Transfer transfer)
        {
            if (transfer.frame != null)
                writer.Release(transfer.frame);
            transfer.frame = null;
        }

        // Once it is stopped and nothing is pending.
        void FinishIfAll()
        {
            if (IsRecording || recorded.Count + coming.Count > 0)
                return;
            simulation.Steps.AfterSteps -= OnSteps;
            foreach (Transfer transfer in idle)
                GpuBuffer.Release(ref transfer.buffer);
            idle.Clear();       // a callback that is late finds no frame
            solver?.ReleasePacking();
            solver = null;
            writer.Finish();
        }

        // Says why it stops, once.
        void Fail(string why)
        {
            if (problem != null)
                return;
            problem = Invariant($"stopped to record: {why} '{path}' holds the {FrameCount:N0} frames that are written, and those pending.");
            Debug.LogError($"Rill: FluidRecorder '{name}' {problem}", this);
            Stop();
        }
    }
}
