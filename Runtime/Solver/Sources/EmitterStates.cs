using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>State of each emitter that only the GPU knows, and the numbers that are read back without waiting.</summary>
    sealed class EmitterStates : IDisposable
    {
        /// <summary>words of an emitter in _EmitterStates</summary>
        [GenerateHlsl("EmitterStates", Prefix = "Emitter")] public const int Words = 16;

        /// <summary>Which word of an emitter is what.</summary>
        [GenerateHlsl("EmitterStates", Prefix = "Emitter")]
        public enum Word
        {
            /// <summary>particles due that had no room yet</summary>
            Waiting,
            /// <summary>particles that drains sent here and that are not back yet</summary>
            Recycled,
            /// <summary>place at which a volume goes on to be filled, or a cross-section to be searched</summary>
            Cursor,
            /// <summary>since the reset</summary>
            Emitted,
            /// <summary>for want of capacity, since the reset</summary>
            Refused,
            /// <summary>given up for want of room, since the reset</summary>
            Blocked,
            /// <summary>places tried in this step that a collider covers; 0 between steps</summary>
            InCollider,
            /// <summary>emissions in a row up to the last in which none of the places tried had room; 0 where one had</summary>
            Shut,
            /// <summary>places tried in this emission that lie outside the box; 0 between</summary>
            Outside,
            /// <summary>places tried in this emission that water takes, and particles that lag behind what presses them; 0 between</summary>
            Crowded,
            /// <summary>emissions for which it goes on to press water away</summary>
            Pressing,
            /// <summary>error of the density of what lies before the outlet, summed in this emission; 0 between</summary>
            PressureSum,
            /// <summary>particles of that sum; 0 between</summary>
            PressureCount,
            /// <summary>their mean error while the water yields, in steps of 1 / PressureSteps; 0 while it presses nothing away</summary>
            Pressure,
            /// <summary>emissions in a row in which the water before it did not yield</summary>
            Stalled,
            /// <summary>why none had room, see <see cref="ShutCause"/></summary>
            ShutBy,
        }

        /// <summary>Why an emitter lets nothing in.</summary>
        [GenerateHlsl("EmitterStates", Prefix = "Shut")]
        public enum ShutCause
        {
            /// <summary>colliders cover its outlet</summary>
            Collider,
            /// <summary>it lies outside the box</summary>
            Outside,
            /// <summary>the box holds as much as fits</summary>
            Full,
            /// <summary>water lies there and does not yield</summary>
            Water,
        }

        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.Emitters.States", StepSources.MaxEmitters * Words));

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public EmitterStates(ReadbackErrors errors = null)
        {
            readback.Report(errors, ReadbackKinds.Emitters);
            Clear();
        }

        /// <summary>uint [emitters * <see cref="Words"/>].</summary>
        public GraphicsBuffer Buffer => readback.Buffer;

        /// <summary>No emitter has done anything, and none of what is pending counts.</summary>
        public void Clear()
        {
            BufferClear.Now(Buffer);
            readback.Invalidate();
        }

        /// <summary>Lists what the next step depends on.</summary>
        public void ListState(List<StateBuffer> state) => state.Add(new StateBuffer(SnapshotSection.EmitterStates, Buffer, StateExtent.All));

        /// <summary>One emitter has done nothing: its number goes to another.</summary>
        public void Invalidate(int emitter) => readback.Zero(emitter * Words, Words);

        /// <summary>Asks for the numbers as the commands executed so far leave them. Nothing while some are pending.</summary>
        public void Request() => readback.Request();

        /// <summary>Waits for the numbers that are pending, and for nothing else.</summary>
        public void Complete() => readback.Complete();

        /// <summary>The newest number that has come back since the last <see cref="Clear"/>; 0 before the first.</summary>
        public int Latest(int emitter, Word word) => readback.HasResult ? (int)readback.Latest[emitter * Words + (int)word] : 0;

        public void Dispose() => readback.Dispose();
    }
}
