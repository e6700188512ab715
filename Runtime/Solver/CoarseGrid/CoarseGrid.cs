using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The cells of the two-level correction: the grid itself and the coarser levels of its V-cycle.</summary>
    sealed class CoarseGrid
    {
        /// <summary>Levels with the grid itself: as many as <see cref="CoarseLevels"/> holds.</summary>
        public const int MaxLevels = 8;

        /// <summary>cells of all levels that one thread group holds</summary>
        [GenerateHlsl("CoarseSolver")] public const int LargeTailCells = 2048;

        /// <summary>the same of the kernels for 16 KB of groupshared memory</summary>
        [GenerateHlsl("CoarseSolver")] public const int SmallTailCells = 1024;

        /// <summary>Most cells: a larger domain gets larger ones.</summary>
        public const int MaxCells = 1 << 22;

        const int EnoughCells = 64, EnoughAlong = 4;        // of the coarsest level, in all and along an axis: its sweeps are few
        const float Fine = 4f, Medium = 5f, Coarse = 8f;    // sides of cells, d
        const float MaxDepth = 5000f;       // layers² times |g| Δt², d, for fine cells
        const float MaxGravityStep = 1.4f;  // |g| Δt², d, for fine and medium ones
        const float Grows = 1.2f, Returns = 0.67f;          // of these limits, for a grid that is there

        readonly List<uint4> levels = new List<uint4>();

        /// <param name="domainSize">d.</param>
        /// <param name="cellSize">Wanted side of a cell, d; what it is comes from whole cells along each axis.</param>
        /// <param name="tailCells">Cells of all levels that one thread group holds.</param>
        public CoarseGrid(float3 domainSize, float cellSize, int tailCells = LargeTailCells)
        {
            WantedSize = cellSize;
            Counts = math.max((int3)math.round(domainSize / cellSize), 1);
            CellSize = domainSize / Counts;
            levels.Add(new uint4((uint3)Counts, 0));
            uint first = 0;
            int3 counts = Counts;
            do
            {
                counts = (counts + 1) / 2;
                levels.Add(new uint4((uint3)counts, first));
                first += (uint)Cells(levels.Count - 1);
            }
            while ((Cells(levels.Count - 1) > EnoughCells || math.cmax(counts) > EnoughAlong) && levels.Count < MaxLevels);
            LevelCells = (int)first;
            FirstTailLevel = 1;
            while (LevelCells - levels[FirstTailLevel].w > tailCells)
                FirstTailLevel++;
        }

        public float WantedSize { get; }
        /// <summary>Side of a cell along each axis, d.</summary>
        public float3 CellSize { get; }
        public int3 Counts { get; }
        public int Total => Counts.x * Counts.y * Counts.z;
        /// <summary>Levels below the grid itself.</summary>
        public int LevelCount => levels.Count - 1;
        /// <summary>Cells of all of them.</summary>
        public int LevelCells { get; }
        /// <summary>The first of the levels that one thread group does together.</summary>
        public int FirstTailLevel { get; }

        /// <summary>Cells of a level; 0 is the grid itself.</summary>
        public int Cells(int level) => (int)(levels[level].x * levels[level].y * levels[level].z);

        /// <summary>Cells along x, y, z and index of the first; the last level again beyond it.</summary>
        public uint4 Level(int level) => levels[Math.Min(level, levels.Count - 1)];

        /// <summary>Records a kernel for so many cells.</summary>
        public static void Dispatch(CommandBuffer cmd, ComputeShader shader, int kernel, int cells)
            => ThreadGroups.Dispatch(cmd, shader, kernel, ParticleBuffers.Groups(cells));

        /// <summary>
        /// Side of a coarse cell, d: the smallest at which the correction is calm, since larger ones damp waves. It has to grow with
        /// how far gravity carries a particle in a step, and in deep water sooner; see Research~/solver-study.md, "Sides of cells". A grid
        /// that is there changes late, since with its potentials it loses where to start from.
        /// </summary>
        /// <param name="gravityStep">|g| Δt², d.</param>
        /// <param name="layers">Depth of the water, d.</param>
        /// <param name="present">Side of the present grid's cells, d; 0 without one.</param>
        public static float CellSizeFor(float3 domainSize, float gravityStep, float layers, float present)
        {
            bool Exceeds(float value, float limit, float size)
                => value > limit * (present >= size ? Returns : present > 0f ? Grows : 1f);
            return Fit(domainSize, Exceeds(gravityStep, MaxGravityStep, Coarse) ? Coarse
                : Exceeds(layers * layers * gravityStep, MaxDepth, Medium) ? Medium : Fine);
        }

        /// <summary>Whether cells of so many d can be those of a domain.</summary>
        public static bool IsCellSize(float3 domainSize, float size)
            => size == Fit(domainSize, Fine) || size == Fit(domainSize, Medium) || size == Fit(domainSize, Coarse);

        static float Fit(float3 domainSize, float size)
        {
            while (math.csum(math.log2(math.max(math.round(domainSize / size), 1f))) > math.log2((float)MaxCells))
                size *= 2f;
            return size;
        }
    }
}
