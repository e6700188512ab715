using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>A snapshot that comes from the GPU: asks for each buffer as the commands executed so far leave it, and waits for nothing.</summary>
    sealed class SnapshotCapture : IPendingReadback
    {
        readonly SnapshotContents contents;
        readonly SolverLayout layout;
        readonly List<Part> parts = new List<Part>();
        Action<SnapshotContents, string> done;
        Action finishing;
        int coming;
        bool failed;

        /// <param name="contents">Holds all that is not a buffer; its <see cref="SolverRecord"/> gets the numbers of particles.</param>
        public SnapshotCapture(SolverLayout layout, SnapshotContents contents)
        {
            this.layout = layout;
            this.contents = contents;
        }

        sealed class Part
        {
            public StateBuffer state;
            public int bytes;
            public bool isList;
            public Action<byte[]> arrived;      // takes data without a section of its own
            public byte[] data = Array.Empty<byte>();
            public AsyncGPUReadbackRequest request;
        }

        /// <summary>The buffers that are asked for.</summary>
        public IEnumerable<GraphicsBuffer> Buffers
        {
            get
            {
                foreach (Part part in parts)
                    yield return part.state.Buffer;
            }
        }

        /// <param name="maxParticles">Maximum number of particles that may be alive.</param>
        /// <exception cref="InvalidOperationException">More than can be read back at once.</exception>
        public void Add(in StateBuffer state, long maxParticles)
        {
            long elements = state.Extent == StateExtent.All ? state.Buffer.count : maxParticles;
            Add(state, elements * state.Buffer.stride, false);
        }

        /// <summary>Adds neighbor lists as they lie on the GPU, the second buffer after the first.</summary>
        /// <param name="entries">Number of entries of a buffer, from its start.</param>
        public void AddLists(GraphicsBuffer buffer, long entries)
            => Add(new StateBuffer(SnapshotSection.Neighbors, buffer, StateExtent.Moved), entries * sizeof(uint), true);

        /// <summary>Adds a buffer that becomes part of a section; see <see cref="Finishing"/>.</summary>
        public void Add(GraphicsBuffer buffer, Action<byte[]> arrived)
        {
            Add(new StateBuffer(default, buffer, StateExtent.All), (long)buffer.count * buffer.stride, false);
            parts[parts.Count - 1].arrived = arrived;
        }

        /// <summary>Calls this when all has come, before the contents are handed over.</summary>
        public void Finishing(Action act) => finishing += act;

        /// <summary>Asks for all of them.</summary>
        /// <param name="onDone">Gets the contents, or null and what went wrong.</param>
        public void Request(Action<SnapshotContents, string> onDone)
        {
            done = onDone;
            coming = 1;         // this call
            foreach (Part part in parts)
            {
                if (part.bytes == 0)
                    continue;
                coming++;
                PendingReadbacks.Hold(part.state.Buffer);
                part.request = AsyncGPUReadback.Request(part.state.Buffer, part.bytes, 0, arrived => OnRead(part, arrived));
            }
            if (coming > 1)
                PendingReadbacks.Add(this);
            CountDown();
        }

        /// <summary>Waits for all of them: as play ends and before scripts are loaded again.</summary>
        public void Complete()
        {
            foreach (Part part in parts.ToArray())
                if (part.bytes > 0 && !part.request.done)
                    part.request.WaitForCompletion();
        }

        void Add(in StateBuffer state, long bytes, bool isList)
        {
            if (bytes > int.MaxValue)
                throw new InvalidOperationException(Invariant($"A snapshot of {layout.Capacity:N0} particles reads {bytes:N0} bytes of ") +
                    Invariant($"one buffer, more than the {int.MaxValue:N0} of a request. Lower the capacity."));
            parts.Add(new Part { state = state, bytes = (int)bytes, isList = isList });
        }

        void OnRead(Part part, AsyncGPUReadbackRequest arrived)
        {
            failed |= arrived.hasError;
            if (!arrived.hasError)
                part.data = arrived.GetData<byte>().ToArray();
            PendingReadbacks.LetGo(part.state.Buffer);
            CountDown();
        }

        void CountDown()
        {
            if (--coming > 0)
                return;
            PendingReadbacks.Remove(this);
            string problem = failed ? "the GPU did not give the particles back. Ask again." : Finish();
            done(problem == null ? contents : null, problem);
        }

        // Cuts all to the particles that are there.
        string Finish()
        {
            ReadOnlySpan<uint> counters = CountersOf(parts);
            SolverRecord record = contents.Get<SolverRecord>(SnapshotSection.Solver);
            record.particles = counters[(int)ParticleCounter.Alive];
            record.moved = Math.Min(counters[(int)ParticleCounter.Moved], record.particles);
            if (record.particles > record.maxParticles)
                return Invariant($"{record.particles:N0} particles came back where {record.maxParticles:N0} were expected at most. Ask ") +
                    "again.";
            contents.Set(SnapshotSection.Solver, record);
            var lists = new List<byte[]>();
            foreach (Part part in parts)
            {
                if (part.isList)
                    lists.Add(part.data);
                else if (part.arrived != null)
                    part.arrived(part.data);
                else
                    contents.Set(part.state.Section, Cut(part, record));
            }
            uint[] changed = contents.Values<uint>(SnapshotSection.Counters).ToArray();
            changed[(int)ParticleCounter.Moved] = record.moved;
            contents.SetValues<uint>(SnapshotSection.Counters, changed);
            if (lists.Count > 0)
                contents.SetValues<uint>(SnapshotSection.Neighbors,
                    NeighborLists.Pack(layout, Join(lists), contents.Values<uint>(SnapshotSection.NeighborCounts)));
            finishing?.Invoke();
            return null;
        }

        static ReadOnlySpan<uint> CountersOf(List<Part> parts)
        {
            foreach (Part part in parts)
                if (part.state.Section == SnapshotSection.Counters)
                    return System.Runtime.InteropServices.MemoryMarshal.Cast<byte, uint>(part.data);
            throw new InvalidOperationException("A snapshot without counters.");
        }

        static byte[] Cut(Part part, in SolverRecord record)
        {
            long bytes = part.state.Elements(record.particles, record.moved) * part.state.Buffer.stride;
            return part.data.AsSpan(0, (int)bytes).ToArray();
        }

        static uint[] Join(List<byte[]> lists)
        {
            long bytes = 0;
            foreach (byte[] list in lists)
                bytes += list.Length;
            var words = new uint[bytes / sizeof(uint)];
            int at = 0;
            foreach (byte[] list in lists)
            {
                Buffer.BlockCopy(list, 0, words, at, list.Length);
                at += list.Length;
            }
            return words;
        }
    }
}
