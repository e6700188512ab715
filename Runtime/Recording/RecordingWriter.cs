using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;

namespace Rill
{
    /// <summary>Writes frames to a stream on a thread of its own, from a ring of buffers that does not grow. Nothing but <see cref="Join"/>
    /// waits for the disk. While a frame is written, other threads make the checksum of the next.</summary>
    sealed class RecordingWriter
    {
        readonly object gate = new object();
        readonly Stream stream;
        readonly RecordingHeader header;
        readonly int buffers;
        readonly Stack<RecordedFrame> free = new Stack<RecordedFrame>();
        readonly Queue<RecordedFrame> queue = new Queue<RecordedFrame>();
        readonly List<IndexEntry> index = new List<IndexEntry>();
        readonly byte[] headerBytes = new byte[RecordingFormat.HeaderBytes];
        readonly Thread thread;
        int made, written;
        long bytes;
        bool isFinished, isDone;
        string problem;

        /// <param name="stream">Disposed when all is written, or failed.</param>
        /// <param name="buffers">Frames that may wait for the disk, those that are being filled included.</param>
        public RecordingWriter(Stream stream, in RecordingHeader header, int buffers)
        {
            this.stream = stream;
            this.header = header;
            this.buffers = buffers;
            thread = new Thread(Run) { Name = "Rill.RecordingWriter", IsBackground = true };
            thread.Start();
        }

        /// <summary>Frames that are in the file.</summary>
        public int FramesWritten { get { lock (gate) return written; } }

        /// <summary>Bytes that are in the file.</summary>
        public long BytesWritten { get { lock (gate) return bytes; } }

        /// <summary>Whether nothing more will be written.</summary>
        public bool IsDone { get { lock (gate) return isDone; } }

        /// <summary>Why the file could not be written; null where it could.</summary>
        public string Problem { get { lock (gate) return problem; } }

        /// <summary>A buffer to fill; null while the disk is as far behind as there are buffers.</summary>
        public RecordedFrame TryReserve()
        {
            lock (gate)
            {
                if (free.Count > 0)
                    return free.Pop();
                if (made == buffers)
                    return null;
                made++;
            }
            var frame = new RecordedFrame();
            frame.Reserve(header.Layout.Words(header.Capacity));
            return frame;
        }

        /// <summary>Gives back a buffer that is not to be written.</summary>
        public void Release(RecordedFrame frame)
        {
            lock (gate)
                free.Push(frame);
        }

        /// <summary>Hands a filled buffer over, in the order of the frames.</summary>
        public void Write(RecordedFrame frame)
        {
            lock (gate)
            {
                queue.Enqueue(frame);
                Monitor.Pulse(gate);
            }
        }

        /// <summary>No more frames: what waits is written, then the index.</summary>
        public void Finish()
        {
            lock (gate)
            {
                isFinished = true;
                Monitor.Pulse(gate);
            }
        }

        /// <summary>Waits until nothing more will be written, but no longer than a time.</summary>
        /// <returns>Whether nothing more will be.</returns>
        public bool Join(int milliseconds) => thread.Join(milliseconds);

        void Run()
        {
            string failure = null;
            try
            {
                WriteAll();
            }
            catch (Exception problemOfDisk)      // whatever it is must not end the player: the recorder logs it
            {
                failure = problemOfDisk.Message;
            }
            try
            {
                stream.Dispose();
            }
            catch (Exception problemOfDisk)
            {
                failure ??= problemOfDisk.Message;
            }
            lock (gate)
            {
                problem = failure;
                isDone = true;
            }
        }

        void WriteAll()
        {
            RecordingFormat.WriteHeader(header, headerBytes);
            stream.Write(headerBytes, 0, RecordingFormat.HeaderBytes);
            long at = RecordingFormat.HeaderBytes;
            using (var checksums = new ChecksumThreads())
                for (RecordedFrame frame = Begin(checksums, true), next; frame != null; frame = next ?? Begin(checksums, true))
                {
                    uint checksum = checksums.End();
                    next = Begin(checksums, false);
                    at = WriteFrame(frame, checksum, at);
                }
            byte[] last = RecordingFormat.WriteIndex(index.ToArray(), at);
            stream.Write(last, 0, last.Length);
            stream.Flush();
            lock (gate)
                bytes = at + last.Length;
        }

        // Returns where it ends in the file.
        long WriteFrame(RecordedFrame frame, uint checksum, long at)
        {
            int length = LengthOf(frame);
            frame.number = index.Count;
            RecordingFormat.WriteFrameHeader(frame, length, checksum, headerBytes);
            stream.Write(headerBytes, 0, RecordingFormat.FrameHeaderBytes);
            stream.Write(MemoryMarshal.AsBytes(frame.words.AsSpan()).Slice(0, length));
            index.Add(new IndexEntry { position = at, time = frame.time, particles = frame.particles, step = frame.step });
            at += RecordingFormat.FrameHeaderBytes + length;
            lock (gate)
            {
                written++;
                bytes = at;
                free.Push(frame);
            }
            return at;
        }

        int LengthOf(RecordedFrame frame) => (int)(sizeof(uint) * header.Layout.Words(frame.particles));

        // The next frame, of which the checksum is being made. Null where there is none: yet, or any more if this waits.
        RecordedFrame Begin(ChecksumThreads checksums, bool waits)
        {
            RecordedFrame frame;
            lock (gate)
            {
                while (waits && queue.Count == 0 && !isFinished)
                    Monitor.Wait(gate);
                if (queue.Count == 0)
                    return null;
                frame = queue.Dequeue();
            }
            checksums.Begin(frame.words, LengthOf(frame));
            return frame;
        }
    }
}
