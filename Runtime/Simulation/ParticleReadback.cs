using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// A copy of a fluid's particles on the CPU, which comes two or three frames after <see cref="FluidSimulation.RequestParticles"/> asked for
    /// it and never waits for the GPU. Make one, use it again for every request, and dispose of it. For several requests at once, make several.
    /// </summary>
    public sealed class ParticleReadback : IDisposable
    {
        readonly Action onArrived;
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.ParticleReadback" };
        Readback readback;
        ParticleCopyLayout layout;
        ParticleFields fields, copied;      // asked for, and in the copy
        int capacity, count;
        bool hasData, isWaiting, isDisposed, hasMarked;
        ReadbackOutcome outcome;
        FluidSimulation fluid;
        PbfSolver solver;
        int generation, askedStep;
        double askedTime;

        /// <summary>Makes a readback that has not asked for anything.</summary>
        public ParticleReadback() => onArrived = OnArrived;

        /// <summary>Whether a request is pending; another is refused meanwhile.</summary>
        public bool IsPending => Refresh() && isWaiting;

        /// <summary>Whether there are particles to read: those of the newest request that arrived. They stay until the next one ends.</summary>
        public bool HasData => Refresh() && hasData;

        /// <summary>How the last request ended.</summary>
        public ReadbackOutcome Outcome => Refresh() ? outcome : ReadbackOutcome.None;

        /// <summary>Particles that were alive; 0 without data.</summary>
        public int Count => HasData ? count : 0;

        /// <summary>Fixed steps since the restart that the particles had taken, as <see cref="FluidSimulation.StepCount"/>.</summary>
        public int Step { get; private set; }

        /// <summary>Fluid time of that step, s, as <see cref="FluidSimulation.FluidTime"/>.</summary>
        public double Time { get; private set; }

        /// <summary>Positions, world space, m. A view, good until the next request ends.</summary>
        /// <exception cref="InvalidOperationException">No data has come back, or the request did not ask for this.</exception>
        public NativeArray<float3> Positions => View(ParticleFields.Positions, layout.PositionsAt, 3).Reinterpret<float3>(sizeof(uint));

        /// <summary>Velocities against the box, world space, m/s. A view, good until the next request ends.</summary>
        /// <exception cref="InvalidOperationException">No data has come back, or the request did not ask for this.</exception>
        public NativeArray<float3> Velocities => View(ParticleFields.Velocities, layout.VelocitiesAt, 3).Reinterpret<float3>(sizeof(uint));

        /// <summary>Ids. A view, good until the next request ends.</summary>
        /// <exception cref="InvalidOperationException">No data has come back, or the request did not ask for this.</exception>
        public NativeArray<uint> Ids => View(ParticleFields.Ids, layout.IdsAt, 1);

        /// <summary>Phases, 0 to 255; 0 where there are none. A view, good until the next request ends.</summary>
        /// <exception cref="InvalidOperationException">No data has come back, or the request did not ask for this.</exception>
        public NativeArray<uint> Phases => View(ParticleFields.Phases, layout.PhasesAt, 1);

        /// <summary>Copies the particles into arrays of the caller, the same particle to the same index; arrays that are not created are
        /// left out.</summary>
        /// <returns>The number of particles.</returns>
        /// <exception cref="InvalidOperationException">No data has come back, or the request did not ask for what an array is for.</exception>
        /// <exception cref="ArgumentException">An array is too short; nothing was copied.</exception>
        public int CopyTo(NativeArray<float3> positions, NativeArray<float3> velocities = default, NativeArray<uint> ids = default,
            NativeArray<uint> phases = default)
        {
            NeedData();
            CheckLength(positions, nameof(positions));
            CheckLength(velocities, nameof(velocities));
            CheckLength(ids, nameof(ids));
            CheckLength(phases, nameof(phases));
            if (positions.IsCreated)
                NativeArray<float3>.Copy(Positions, positions, count);
            if (velocities.IsCreated)
                NativeArray<float3>.Copy(Velocities, velocities, count);
            if (ids.IsCreated)
                NativeArray<uint>.Copy(Ids, ids, count);
            if (phases.IsCreated)
                NativeArray<uint>.Copy(Phases, phases, count);
            return count;
        }

        /// <summary>Gives the memory back, at any time: a pending request is forgotten.</summary>
        public void Dispose()
        {
            if (isDisposed)
                return;
            isDisposed = true;
            hasData = isWaiting = false;
            readback?.Dispose();
            readback = null;
            commands.Dispose();
            fluid = null;
            solver = null;
        }

        /// <summary>Requests a fluid's particles: see <see cref="FluidSimulation.RequestParticles"/>.</summary>
        internal static bool TryRequest(FluidSimulation fluid, ParticleReadback readback, ParticleFields fields)
        {
            if (readback == null)
                throw new ArgumentNullException(nameof(readback));
            if ((fields & ParticleFields.All) == 0)
                throw Limit.OutOfRange(nameof(fields), fields, "A request brings at least one field.");
            bool isPending = readback.IsPending;
            if (fluid.Solver == null && FeatureSupport.HasNoGraphics)
                return false;
            if (fluid.Solver == null)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' is not running: enable it before asking for its particles.");
            if (isPending)
                return false;
            if (!fluid.Support.Gate.IsLoaded(Features.ParticleAccess))
            {
                readback.Fail();
                return false;
            }
            readback.Request(fluid, fields & ParticleFields.All);
            return true;
        }

        // Requests the particles as the commands executed so far leave them.
        void Request(FluidSimulation of, ParticleFields wanted)
        {
            PbfSolver from = of.Solver;
            // Which particles a script has removed since the last step, only their positions tell.
            hasMarked = from.HasMarked;
            Reserve(from.Layout.Capacity, hasMarked ? wanted | ParticleFields.Positions : wanted);
            fields = wanted;
            (fluid, solver, generation) = (of, from, from.Generation);
            (askedStep, askedTime) = (of.StepCount, of.FluidTime);
            commands.Clear();
            from.RecordCopy(commands, of.DomainToWorld, layout, readback.Buffer);
            Graphics.ExecuteCommandBuffer(commands);
            isWaiting = true;
            readback.Report(from.ReadbackErrors, ReadbackKinds.Particles);
            readback.Request();
        }

        /// <summary>A request that could not even be made.</summary>
        internal void Fail() => (outcome, hasData) = (ReadbackOutcome.Failed, false);

        // For another capacity or other fields the copy is another buffer; what it held is gone.
        void Reserve(int particles, ParticleFields wanted)
        {
            if (readback != null && capacity == particles && copied == wanted)
                return;
            hasData = false;
            readback?.Dispose();
            readback = null;
            var next = new ParticleCopyLayout(wanted, particles);
            readback = new Readback(GpuBuffer.Structured<uint>("Rill.ParticleCopy", next.Words)) { Arrived = onArrived };
            BufferClear.Now(readback.Buffer);
            (layout, capacity, copied) = (next, particles, wanted);
        }

        void OnArrived()
        {
            isWaiting = false;
            bool isSame = fluid != null && fluid.Solver == solver && solver.Generation == generation;
            outcome = isSame ? ReadbackOutcome.Arrived : ReadbackOutcome.Dropped;
            hasData = isSame;
            if (!isSame)
                return;
            count = (int)readback.Latest[0];
            if (hasMarked)
                LeaveOutMarked();
            Step = askedStep;
            Time = askedTime;
        }

        void LeaveOutMarked()
        {
            NativeArray<uint> words = readback.Latest;
            int there = 0;
            for (int i = 0; i < count; i++)
            {
                if (!math.isfinite(math.asfloat(words[layout.PositionsAt + 3 * i])))
                    continue;
                Move(words, layout.PositionsAt, 3, i, there);
                Move(words, layout.VelocitiesAt, 3, i, there);
                Move(words, layout.IdsAt, 1, i, there);
                Move(words, layout.PhasesAt, 1, i, there);
                there++;
            }
            count = there;
        }

        static void Move(NativeArray<uint> words, int at, int size, int from, int to)
        {
            if (at == ParticleCopyLayout.Missing || from == to)
                return;
            for (int word = 0; word < size; word++)
                words[at + size * to + word] = words[at + size * from + word];
        }

        // A request that ended without a result is one that the device failed.
        bool Refresh()
        {
            if (isDisposed)
                throw new ObjectDisposedException(nameof(ParticleReadback));
            if (!isWaiting || readback.IsPending)
                return true;
            isWaiting = false;
            Fail();
            return true;
        }

        NativeArray<uint> View(ParticleFields field, int at, int words)
        {
            NeedData();
            if ((fields & field) == 0)
                throw new InvalidOperationException(Invariant($"The request asked for {fields} and not for {field}: name it in ") +
                    "RequestParticles.");
            return readback.Latest.GetSubArray(at, count * words);
        }

        void NeedData()
        {
            if (!HasData)
                throw new InvalidOperationException(isWaiting ? "The particles have not come back yet: ask HasData first."
                    : Invariant($"There are no particles to read, the last request ended as {outcome}: ask HasData first."));
        }

        void CheckLength<T>(NativeArray<T> array, string name) where T : struct
        {
            if (array.IsCreated && array.Length < count)
                throw new ArgumentException(Invariant($"'{name}' holds {array.Length:N0} elements, and {count:N0} particles came back: ") +
                    Invariant($"make it as long as FluidSimulation.Capacity, {capacity:N0} here."), name);
        }
    }
}
