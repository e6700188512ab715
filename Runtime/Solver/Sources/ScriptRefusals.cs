using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Counts the particles of scripts that the capacity did not hold, and brings their number back without waiting. Made when a
    /// script first adds some.</summary>
    sealed class ScriptRefusals : IDisposable
    {
        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.RefusedOfScripts", 1));
        bool isStale, isLost;

        /// <param name="arrived">Called when a number has come.</param>
        /// <param name="errors">Learns of numbers that the device did not give; may be null.</param>
        public ScriptRefusals(Action arrived, ReadbackErrors errors = null)
        {
            readback.Report(errors, ReadbackKinds.Refusals);
            readback.Lost = () => isLost = true;
            readback.Arrived = () =>
            {
                if (isStale)
                    Request();
                arrived?.Invoke();
            };
            Clear();
        }

        /// <summary>uint [1].</summary>
        public GraphicsBuffer Buffer => readback.Buffer;

        /// <summary>Particles refused since the last <see cref="Clear"/>, as far as it has come back.</summary>
        public int Count => readback.HasResult ? (int)readback.Latest[0] : 0;

        /// <summary>None was refused.</summary>
        public void Clear()
        {
            isLost = false;
            BufferClear.Now(readback.Buffer);
            readback.Invalidate();
        }

        /// <summary>Asks for the number as the commands executed so far leave it.</summary>
        public void Request()
        {
            isStale = readback.IsPending;
            isLost = false;
            readback.Request();
        }

        /// <summary>Asks again where the last request ended with an error.</summary>
        public void RequestLost()
        {
            if (isLost)
                Request();
        }

        public void Dispose() => readback.Dispose();
    }
}
