using System;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Layout of a solver's memory: domain, spacing, capacity and neighbor lists. Changing any of it means a
    /// new solver; everything else can change from step to step.
    /// </summary>
    sealed class SolverLayout
    {
        /// <summary>Most particles one solver takes: ids and float counters stay exact, and two list buffers suffice.</summary>
        public const int MaxCapacity = 1 << 24;

        /// <summary>Most grid cells: with 8 bytes each they take half a gigabyte.</summary>
        public const int MaxCells = 1 << 26;

        /// <summary>Particle spacings that keep positions and their differences apart from rounding: at most this many along an axis.</summary>
        public const float MaxSpacingsAcross = 8192f;

        /// <summary>particles whose blocks of entries lie side by side</summary>
        [GenerateHlsl("NeighborList")] const int ParticlesPerListBlock = 32;

        // Cells to the list radius. Along x a search is cut to its reach, cell by cell. Particles of a cell are neighbors in memory, so
        // that wide ones in y keep more of what a thread group fetches near it. A domain with too many cells gets wide ones.
        static readonly int3 TightCells = new int3(3, 1, 2), WideCells = 1;

        // Memory of each particle and each grid cell besides the lists, in a scene without optional stages.
        const long BytesOfParticle = 92, BytesOfCell = 8;

        /// <param name="domainSize">Inner size of the box, m, each at least the support radius 2 d.</param>
        /// <param name="spacing">Particle spacing d, m, above 0.</param>
        /// <param name="capacity">Maximum number of particles, 1 to <see cref="MaxCapacity"/>, as far as the device can bind their buffers.</param>
        /// <param name="neighborCapacity">Entries of a particle's neighbor list.</param>
        /// <param name="listMargin">List radius over support radius, at least 1.</param>
        /// <exception cref="ArgumentException">A value is out of range; the message names it, the limit and the remedy.</exception>
        public SolverLayout(float3 domainSize, float spacing, int capacity, int neighborCapacity, float listMargin)
            : this(domainSize, spacing, capacity, neighborCapacity, listMargin, GpuBuffer.MaxBinding) { }

        /// <param name="maxBinding">Bytes of the largest buffer that a kernel can be given.</param>
        internal SolverLayout(float3 domainSize, float spacing, int capacity, int neighborCapacity, float listMargin, long maxBinding)
        {
            if (!(spacing > 0f) || float.IsInfinity(spacing))
                throw new ArgumentException(
                    Invariant($"Particle spacing {spacing} m: it must be above 0. Set it to the distance between particles at rest, ") +
                    "e.g. 0.05.");
            if (!math.all(math.isfinite(domainSize)))
                throw new ArgumentException($"Domain size {Text(domainSize)} m is not finite. Set all three sides to numbers.");
            float support = (float)LatticeKernels.Support;
            DomainSize = domainSize / spacing;
            if (math.cmin(DomainSize) < support)
                throw new ArgumentException($"Domain size {Text(domainSize)} m: each side must be at least the support radius, " +
                    Invariant($"{support * spacing} m (2 spacings). Enlarge the domain or lower the particle spacing."));
            if (math.cmax(DomainSize) > MaxSpacingsAcross)
                throw new ArgumentException(Invariant($"Domain size {Text(domainSize)} m is more than {MaxSpacingsAcross:N0} particle ") +
                    Invariant($"spacings of {spacing} m along a side, where single precision ends. Shrink the domain or raise the ") +
                    "particle spacing.");
            if (capacity < 1 || capacity > MaxCapacity)
                throw new ArgumentException(Invariant($"Capacity {capacity:N0}: a simulation holds 1 to {MaxCapacity:N0} particles. Set ") +
                    "the capacity to the most that the scene ever needs.");

            Spacing = spacing;
            Capacity = capacity;
            NeighborCapacity = (neighborCapacity + NeighborLists.BlockEntries - 1) / NeighborLists.BlockEntries * NeighborLists.BlockEntries;
            AskedNeighborCapacity = neighborCapacity;
            ListRadius = support * listMargin;
            ChooseCells();
            SplitLists(maxBinding);
        }

        /// <summary>Particle spacing d, m.</summary>
        public float Spacing { get; }
        /// <summary>Inner size of the box, d.</summary>
        public float3 DomainSize { get; }
        public int Capacity { get; }
        /// <summary>Entries of a particle's neighbor list: what was asked for, rounded up to whole blocks.</summary>
        public int NeighborCapacity { get; }
        /// <summary>Requested capacity of a neighbor list.</summary>
        public int AskedNeighborCapacity { get; }
        /// <summary>Radius within which a neighbor is listed, d.</summary>
        public float ListRadius { get; }
        /// <summary>Grid cells to the list radius along each axis.</summary>
        public int3 CellsPerRadius { get; private set; }
        /// <summary>Sides of a grid cell, d.</summary>
        public float3 CellSize { get; private set; }
        public int3 CellCounts { get; private set; }
        public int CellTotal { get; private set; }
        /// <summary>Particles whose neighbors lie in the first list buffer: all, or as many whole blocks as one buffer holds.</summary>
        public int FirstListParticles { get; private set; }
        public bool TwoLists => FirstListParticles < Capacity;

        /// <summary>Entries of the first list buffer.</summary>
        public long FirstListEntries => (long)RoundUp(FirstListParticles) * NeighborCapacity;
        /// <summary>Entries of the second list buffer; 0 without one.</summary>
        public long SecondListEntries => (long)RoundUp(Capacity - FirstListParticles) * NeighborCapacity;

        /// <summary>Entries of the lists of the first particles, in whole blocks of particles.</summary>
        public long ListWords(int particles) => (long)RoundUp(particles) * NeighborCapacity;

        /// <summary>Returns the word of entry k of a particle's list, with the second buffer after the first; as NeighborList.hlsl has it.</summary>
        public long WordOfEntry(int particle, int k)
            => ((long)(particle / ParticlesPerListBlock) * (NeighborCapacity / NeighborLists.BlockEntries) + k / NeighborLists.BlockEntries)
            * (ParticlesPerListBlock * NeighborLists.BlockEntries)
            + particle % ParticlesPerListBlock * NeighborLists.BlockEntries + k % NeighborLists.BlockEntries;

        /// <summary>Bytes of the buffers of a solver with this layout, without its optional stages.</summary>
        public long EstimatedBytes => Capacity * BytesOfParticle + CellTotal * BytesOfCell + sizeof(uint) * (FirstListEntries + SecondListEntries);

        void ChooseCells()
        {
            foreach (int3 perRadius in new[] { TightCells, WideCells })
            {
                CellsPerRadius = perRadius;
                CellSize = ListRadius / (float3)perRadius;
                CellCounts = (int3)math.ceil(DomainSize / CellSize);
                long total = (long)CellCounts.x * CellCounts.y * CellCounts.z;
                if (total < MaxCells)
                {
                    CellTotal = (int)total;
                    return;
                }
            }
            throw new ArgumentException(Invariant($"Domain size {Text(DomainSize * Spacing)} m has more than {MaxCells:N0} grid cells ") +
                Invariant($"of {CellSize.x * Spacing} m. Shrink the domain or raise the particle spacing."));
        }

        void SplitLists(long maxBinding)
        {
            long entries = maxBinding / sizeof(uint);
            long perBuffer = entries / NeighborCapacity / ParticlesPerListBlock * ParticlesPerListBlock;
            if (2 * perBuffer < Capacity)
                throw new ArgumentException(Invariant($"Capacity {Capacity:N0} with {NeighborCapacity} neighbors each needs more than ") +
                    Invariant($"two buffers of {maxBinding:N0} bytes, the most this device binds. Lower the capacity to ") +
                    Invariant($"{2 * perBuffer:N0} or the neighbor capacity."));
            FirstListParticles = (int)Math.Min(Capacity, perBuffer);
        }

        static int RoundUp(int particles) => (particles + ParticlesPerListBlock - 1) / ParticlesPerListBlock * ParticlesPerListBlock;

        static string Text(float3 v) => Invariant($"{v.x} x {v.y} x {v.z}");
    }
}
