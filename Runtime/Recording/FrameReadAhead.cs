using System;
using System.Threading;

namespace Rill
{
    /// <summary>Reads the frames of a recording on a thread of its own, those that come next before they are asked for.</summary>
    sealed class FrameReadAhead : IDisposable
    {
        enum State { Empty, Reading, Ready, Failed }

        sealed class Slot
        {
            public readonly RecordedFrame frame = new RecordedFrame();
            public int number = -1;
            public State state;
            public string problem;
        }

        const int Ahead = 4;        // frames, the one asked for included
        const int MaxWait = 2000;   // ms

        readonly object gate = new object();
        readonly RecordingReader reader;
        readonly Slot[] slots = new Slot[Ahead + 1];        // one more than are wanted: that which is shown
        readonly Thread thread;
        Slot held;
        int wanted, direction = 1;
        bool isDisposed;

        /// <param name="reader">Disposed with this; used by no one else from now on, but for what is known without reading.</param>
        public FrameReadAhead(RecordingReader reader)
        {
            this.reader = reader;
            for (int i = 0; i < slots.Length; i++)
                slots[i] = new Slot();
            thread = new Thread(Run) { Name = "Rill.FrameReadAhead", IsBackground = true };
            thread.Start();
        }

        /// <summary>Asks for a frame and for those after it.</summary>
        /// <param name="forward">Whether time goes on, so that higher numbers come next.</param>
        /// <param name="waits">Whether to wait for the disk.</param>
        /// <param name="problem">Why it cannot be read; null where it is there or pending.</param>
        /// <returns>The frame, good until the next call; null while it is not there.</returns>
        public RecordedFrame Take(int number, bool forward, bool waits, out string problem)
        {
            lock (gate)
            {
                wanted = number;
                direction = forward ? 1 : -1;
                Monitor.PulseAll(gate);
                Slot slot = Find(number);
                while (waits && (slot == null || slot.state == State.Reading))
                {
                    Monitor.Wait(gate);
                    slot = Find(number);
                }
                problem = slot?.state == State.Failed ? slot.problem : null;
                if (slot == null || slot.state != State.Ready)
                    return null;
                held = slot;
                return slot.frame;
            }
        }

        public void Dispose()
        {
            lock (gate)
            {
                isDisposed = true;
                Monitor.PulseAll(gate);
            }
            thread.Join(MaxWait);       // so that the file can be deleted; a disk that hangs keeps it
        }

        void Run()
        {
            while (TryBegin(out Slot slot))
            {
                string failure = null;
                try
                {
                    reader.Read(slot.number, slot.frame);
                }
                catch (Exception problemOfDisk)      // whatever it is must not end the player: playback logs it
                {
                    failure = problemOfDisk.Message;
                }
                lock (gate)
                {
                    slot.state = failure == null ? State.Ready : State.Failed;
                    slot.problem = failure;
                    Monitor.PulseAll(gate);
                }
            }
            reader.Dispose();
        }

        // Waits for a frame that is wanted and not there.
        bool TryBegin(out Slot slot)
        {
            lock (gate)
            {
                slot = null;
                while (!isDisposed && !TryNext(out slot))
                    Monitor.Wait(gate);
                return !isDisposed;
            }
        }

        bool TryNext(out Slot slot)
        {
            for (int i = 0; i < Math.Min(Ahead, reader.FrameCount); i++)
            {
                int number = Wanted(i);
                if (Find(number) != null)
                    continue;
                slot = FindUnwanted();
                if (slot == null)
                    return false;
                slot.number = number;
                slot.state = State.Reading;
                return true;
            }
            slot = null;
            return false;
        }

        // The frames go round, as one that loops does.
        int Wanted(int ahead) => ((wanted + direction * ahead) % reader.FrameCount + reader.FrameCount) % reader.FrameCount;

        Slot Find(int number)
        {
            foreach (Slot slot in slots)
                if (slot.number == number)
                    return slot;
            return null;
        }

        Slot FindUnwanted()
        {
            foreach (Slot slot in slots)
                if (slot != held && slot.state != State.Reading && !IsWanted(slot.number))
                    return slot;
            return null;
        }

        bool IsWanted(int number)
        {
            for (int i = 0; i < Math.Min(Ahead, reader.FrameCount); i++)
                if (Wanted(i) == number)
                    return true;
            return false;
        }
    }
}
