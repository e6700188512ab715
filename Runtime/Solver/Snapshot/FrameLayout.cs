using Unity.Mathematics;

namespace Rill
{
    /// <summary>How the particles of a recorded frame lie in its words: one field after the other, each as long as the particles need.
    /// Recording.compute has the same.</summary>
    /// <remarks>
    /// Positions in 16 bits: a word with x and y for each particle, then one with z for each two. In 21 bits: two words for each. Velocities:
    /// three half-precision numbers, d/s, a word with x and y for each, then one with z for each two. Ids: a word for each. Phases: a word
    /// for each four.
    /// </remarks>
    readonly struct FrameLayout
    {
        /// <summary>words before the first field in the buffer that the GPU fills: particles, next id</summary>
        [GenerateHlsl("Recording")] public const int PackedHeader = 2;

        /// <summary>bits of a coordinate</summary>
        [GenerateHlsl("Recording")] public const int NarrowBits = 16;

        /// <summary>bits of a coordinate in a box that is too long for fewer</summary>
        [GenerateHlsl("Recording")] public const int WideBits = 21;

        /// <summary>bit of the fields that are there</summary>
        [GenerateHlsl("Recording")] public const int HasVelocities = (int)RecordingFields.Velocities;

        /// <summary>bit of the fields that are there</summary>
        [GenerateHlsl("Recording")] public const int HasPhases = (int)RecordingFields.Phases;

        /// <summary>bit of the fields that are there</summary>
        [GenerateHlsl("Recording")] public const int HasIds = (int)RecordingFields.Ids;

        /// <summary>Sides up to which 16 bits are enough, d: their steps are then no more than 1/64 of a spacing.</summary>
        public const float MaxNarrowSize = 1024f;

        public readonly RecordingFields Fields;

        /// <summary>Whether coordinates have 21 bits.</summary>
        public readonly bool IsWide;

        public FrameLayout(RecordingFields fields, bool isWide)
        {
            Fields = fields;
            IsWide = isWide;
        }

        /// <param name="domainSize">d.</param>
        public static FrameLayout For(RecordingFields fields, float3 domainSize) => new FrameLayout(fields, math.cmax(domainSize) > MaxNarrowSize);

        public int Bits => IsWide ? WideBits : NarrowBits;

        /// <summary>The number that stands for the highest coordinate that a particle's center can have; 0 stands for the lowest.</summary>
        public uint MaxSteps => (1u << Bits) - 1u;

        /// <summary>Length of a step of a coordinate, d; a particle is stored within half of it.</summary>
        public float3 StepSize(float3 domainSize) => (domainSize - 2f * Colliders.ContactOffset) / MaxSteps;

        public bool Has(RecordingFields field) => (Fields & field) != 0;

        /// <summary>Words of a frame's particles.</summary>
        public long Words(long particles)
        {
            long pairs = (particles + 1) / 2, words = IsWide ? 2 * particles : particles + pairs;
            words += Has(RecordingFields.Velocities) ? particles + pairs : 0;
            words += Has(RecordingFields.Ids) ? particles : 0;
            words += Has(RecordingFields.Phases) ? (particles + 3) / 4 : 0;
            return words;
        }
    }
}
