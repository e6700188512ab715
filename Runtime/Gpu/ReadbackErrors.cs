using System;

namespace Rill
{
    /// <summary>Kinds of data of a fluid that are read back from the GPU, one bit each.</summary>
    [Flags]
    enum ReadbackKinds
    {
        None = 0,
        Statistics = 1,
        Foam = 2,
        Queries = 4,
        QueryBatches = 8,
        Forces = 16,
        Emitters = 32,
        Drains = 64,
        Transfers = 128,
        Refusals = 256,
        Particles = 512,
    }

    /// <summary>Which results of a fluid the graphics device gave an error for instead of their data.</summary>
    sealed class ReadbackErrors
    {
        // Scripts that requested them learn it themselves, and may never request again.
        const ReadbackKinds OfScripts = ReadbackKinds.QueryBatches | ReadbackKinds.Particles;

        ReadbackKinds told, untold, lost;

        /// <summary>Kinds whose newest request ended with an error, but those of scripts' requests.</summary>
        public ReadbackKinds Lost => lost & ~OfScripts;

        /// <summary>Marks how a request ended.</summary>
        public void Mark(ReadbackKinds kind, bool isLost)
        {
            lost = isLost ? lost | kind : lost & ~kind;
            if (isLost)
                untold |= kind & ~told;
        }

        /// <summary>Returns the kinds that were lost since the last call, each once, also where another request brought them since.</summary>
        public ReadbackKinds ConsumeNew()
        {
            ReadbackKinds fresh = untold;
            told |= fresh;
            untold = ReadbackKinds.None;
            return fresh;
        }

        /// <summary>Takes one kind out of several; false where none is left.</summary>
        public static bool TryTake(ref ReadbackKinds kinds, out ReadbackKinds kind)
        {
            kind = kinds & (ReadbackKinds)(-(int)kinds);
            kinds &= ~kind;
            return kind != ReadbackKinds.None;
        }

        /// <summary>Returns what of one kind was lost, what follows, and what to do, as a text that goes on after the name of the fluid.</summary>
        public static string Problem(ReadbackKinds kind)
        {
            (string what, string follows) = Texts(kind);
            return $"did not get {what} back: the graphics device gave an error instead (AsyncGPUReadback). {follows} If it comes again, " +
                $"look in the player's log for a lost device or a lack of memory, and use less of it: a lower Capacity, fewer results at once.";
        }

        static (string what, string follows) Texts(ReadbackKinds kind)
        {
            switch (kind)
            {
                case ReadbackKinds.Statistics: return ("a measurement", "There are no statistics until the next measurement.");
                case ReadbackKinds.Foam: return ("the counts of its foam", "They are unknown until the next come.");
                case ReadbackKinds.Queries:
                    return ("an answer to probes and detectors",
                    "They keep the sample of before, whose age grows, and are asked again.");
                case ReadbackKinds.QueryBatches:
                    return ("an answer to a FluidQueryBatch",
                    "It keeps the answer of before, whose age grows, and is asked again, once where it does not repeat.");
                case ReadbackKinds.Forces:
                    return ("the forces on colliders", "Colliders and what floats keep those of before until the next come, " +
                    "and contacts of the time between are not told.");
                case ReadbackKinds.Emitters: return ("the counts of its emitters", "Those of before stay until the next come.");
                case ReadbackKinds.Drains: return ("the counts of its drains", "Those of before stay until the next come.");
                case ReadbackKinds.Transfers:
                    return ("the counts of particles that crossed to or from other fluids or left with its box",
                    "Those of before stay until the next come.");
                case ReadbackKinds.Refusals: return ("the number of particles of scripts that it refused", "It is asked for again.");
                case ReadbackKinds.Particles: return ("the particles for a ParticleReadback", "Its Outcome is Failed: request them again.");
                default: throw Limit.OutOfRange(nameof(kind), kind, "One kind has a text.");
            }
        }
    }
}
