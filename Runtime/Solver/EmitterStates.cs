using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What is known of each emitter on the GPU alone, and the numbers that come back from there without waiting.</summary>
    sealed class EmitterStates : IDisposable
    {
        /// <summary>Words of an emitter; kEmitterWords in EmitterStates.hlsl.</summary>
        public const int Words = 8;

        /// <summary>Words by their place; the constants of EmitterStates.hlsl.</summary>
        public enum Word { Waiting, Recycled, Cursor, Emitted, Refused, Blocked, InCollider, Shut }

        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.Emitters.States", StepSources.MaxEmitters * Words));

        public EmitterStates() => Clear();

        /// <summary>uint [emitters * <see cref="Words"/>].</summary>
        public GraphicsBuffer Buffer => readback.Buffer;

        /// <summary>No emitter has done anything, and none of what is under way counts.</summary>
        public void Clear()
        {
            BufferClear.Now(Buffer);
            readback.Invalidate();
        }

        /// <summary>One emitter has done nothing: its number goes to another.</summary>
        public void Invalidate(int emitter) => readback.Zero(emitter * Words, Words);

        /// <summary>Asks for the numbers as the commands executed so far leave them. Nothing while some are under way.</summary>
        public void Request() => readback.Request();

        /// <summary>The newest number that has come back since the last <see cref="Clear"/>; 0 before the first.</summary>
        public int Latest(int emitter, Word word) => readback.HasResult ? (int)readback.Latest[emitter * Words + (int)word] : 0;

        public void Dispose() => readback.Dispose();
    }
}
