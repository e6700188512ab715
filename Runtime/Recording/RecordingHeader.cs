using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Data that holds for all frames of a recording.</summary>
    readonly struct RecordingHeader
    {
        public readonly FrameLayout Layout;

        /// <summary>Most particles of a frame.</summary>
        public readonly int Capacity;

        /// <summary>Particle spacing d, m.</summary>
        public readonly float Spacing;

        /// <summary>Inner size of the box, d.</summary>
        public readonly float3 DomainSize;

        public RecordingHeader(in FrameLayout layout, int capacity, float spacing, float3 domainSize)
        {
            Layout = layout;
            Capacity = capacity;
            Spacing = spacing;
            DomainSize = domainSize;
        }

        public RecordingHeader(SolverLayout fluid, RecordingFields fields)
            : this(FrameLayout.For(fields, fluid.DomainSize), fluid.Capacity, fluid.Spacing, fluid.DomainSize) { }

        /// <summary>Why a fluid cannot show it, with what to do; null where it can.</summary>
        /// <param name="most">Particles of its largest frame.</param>
        public string ProblemFor(SolverLayout fluid, int most)
        {
            if (Spacing != fluid.Spacing)
                return Invariant($"it is of a fluid with a particle spacing of {Spacing} m, but this one has {fluid.Spacing} m. Set the ") +
                    Invariant($"Particle Spacing to {Spacing}.");
            if (math.any(DomainSize != fluid.DomainSize))
                return $"it is of a box of {Text(DomainSize * Spacing)} m, but this one is {Text(fluid.DomainSize * fluid.Spacing)} m. " +
                    $"Set the Domain Size to that of the recording.";
            if (most > fluid.Capacity)
                return Invariant($"it has up to {most:N0} particles, more than the capacity of {fluid.Capacity:N0}. Raise the Capacity ") +
                    Invariant($"to at least {most:N0}.");
            return null;
        }

        static string Text(float3 v) => Invariant($"{v.x} x {v.y} x {v.z}");
    }
}
