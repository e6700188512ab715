using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>V-cycles for the potential of a <see cref="CoarseGrid"/>: each smooths, corrects from coarser levels, smooths.</summary>
    sealed class CoarseSolver : IDisposable
    {
        /// <summary>cells along the tile of a thread group that smooths</summary>
        [GenerateHlsl("CoarseSolver")] const int LargeTile = 8;

        /// <summary>the same of the kernels for 256 threads; even, as kTileCells at most kTailCells wants it</summary>
        [GenerateHlsl("CoarseSolver")] const int SmallTile = 6;

        /// <summary>threads that restrict to a cell</summary>
        [GenerateHlsl("CoarseSolver")] const int Children = 8;

        readonly ComputeShader shader = StageShader.LoadCompute("CoarseSolver");
        readonly CoarseGrid grid;
        readonly CoarseSolverPath path;
        readonly KernelVariants smooth, restrictGrid, correctAndSmooth;     // with colliders, with materials
        readonly Kernel smoothLevel, correctAndSmoothLevel, restrictLevel, solveCoarseLevels;
        readonly BufferSet buffers = new BufferSet();
        readonly GraphicsBuffer smoothed;

        /// <param name="grid">With the tail of the path.</param>
        public CoarseSolver(CoarseGrid grid, CoarseSolverPath path)
        {
            this.grid = grid;
            this.path = path;
            smooth = new KernelVariants(shader, path.Tiled("Smooth"), path.Tiled("SmoothWithColliders"),
                "SmoothWithMaterials", "SmoothWithCollidersAndMaterials");
            restrictGrid = new KernelVariants(shader, "RestrictGrid", "RestrictGridWithColliders",
                "RestrictGridWithMaterials", "RestrictGridWithCollidersAndMaterials");
            smoothLevel = new Kernel(shader, path.Tiled("SmoothLevel"));
            restrictLevel = new Kernel(shader, "RestrictLevel");
            correctAndSmoothLevel = new Kernel(shader, path.Tiled("CorrectAndSmoothLevel"));
            solveCoarseLevels = new Kernel(shader, path.CoarseLevels);
            correctAndSmooth = new KernelVariants(shader, path.Tiled("CorrectAndSmooth"), path.Tiled("CorrectAndSmoothWithColliders"),
                "CorrectAndSmoothWithMaterials", "CorrectAndSmoothWithCollidersAndMaterials");
            smoothed = buffers.Structured<float>("Rill.Coarse.Smoothed", grid.Total);
            buffers.Structured<float4>("Rill.Coarse.Couplings", grid.LevelCells);
            buffers.Structured<float>("Rill.Coarse.Residuals", grid.LevelCells);
            buffers.Structured<float>("Rill.Coarse.Errors", grid.LevelCells);
            buffers.Structured<float>("Rill.Coarse.Corrections", grid.LevelCells);
        }

        /// <summary>V-cycles of a solve without a past. With one, deep water began with a fall and swung up and down.</summary>
        public const int FirstCycles = 4;

        /// <summary>V-cycles a solve, at least 1: with a warm start one is enough.</summary>
        public int Cycles { get; set; } = 1;

        /// <summary>Records a solve, from the potential's present values.</summary>
        /// <param name="source">float [cells], right-hand side; kInactive in cells without a potential.</param>
        /// <param name="diagonal">float [cells], 1/d².</param>
        /// <param name="potential">float [cells], d²; 0 in inactive cells.</param>
        /// <param name="coarseColliders">Colliders that close faces; null for none.</param>
        /// <param name="densities">float [cells], relative to the heaviest phase's; null for one density.</param>
        /// <param name="minCycles">V-cycles at least.</param>
        public void Record(CommandBuffer cmd, GraphicsBuffer coarseConstants, GraphicsBuffer source, GraphicsBuffer diagonal,
            GraphicsBuffer potential, CoarseColliders coarseColliders = null, GraphicsBuffer densities = null, int minCycles = 1)
        {
            cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, coarseConstants, 0, coarseConstants.stride);
            for (int cycle = Math.Max(Cycles, minCycles); cycle > 0; cycle--)
                RecordCycle(cmd, source, diagonal, potential, coarseColliders, densities);
        }

        void RecordCycle(CommandBuffer cmd, GraphicsBuffer source, GraphicsBuffer diagonal, GraphicsBuffer potential,
            CoarseColliders coarseColliders, GraphicsBuffer densities)
        {
            bool withColliders = coarseColliders != null, withMaterials = densities != null;
            int first = smooth.For(withColliders, withMaterials), restrict = restrictGrid.For(withColliders, withMaterials),
                last = correctAndSmooth.For(withColliders, withMaterials);
            int tile = path.SmallTiles || withMaterials ? SmallTile : LargeTile;
            coarseColliders?.Bind(cmd, shader, first);
            coarseColliders?.Bind(cmd, shader, restrict);
            coarseColliders?.Bind(cmd, shader, last);
            RecordSmooth(cmd, first, tile, source, diagonal, densities, potential, smoothed);
            buffers.Bind(cmd, shader, restrict);
            Ids.Restrict.Bind(cmd, shader, restrict, source, diagonal, densities, smoothed);
            CoarseGrid.Dispatch(cmd, shader, restrict, Children * grid.Cells(1));

            for (int level = 1; level < grid.FirstTailLevel; level++)
            {
                RecordSmoothLevel(cmd, smoothLevel, level);
                cmd.SetComputeIntParam(shader, Ids.Level, level + 1);
                buffers.Bind(cmd, shader, restrictLevel);
                CoarseGrid.Dispatch(cmd, shader, restrictLevel, Children * grid.Cells(level + 1));
            }
            buffers.Bind(cmd, shader, solveCoarseLevels);
            cmd.DispatchCompute(shader, solveCoarseLevels, 1, 1, 1);
            for (int level = grid.FirstTailLevel - 1; level >= 1; level--)
                RecordSmoothLevel(cmd, correctAndSmoothLevel, level);

            buffers.Bind(cmd, shader, last);
            RecordSmooth(cmd, last, tile, source, diagonal, densities, smoothed, potential);
        }

        /// <param name="cycles">V-cycles in a step for one density.</param>
        /// <param name="withMaterials">V-cycles in a step for several.</param>
        public void Describe(StageDescription stage, int cycles, int withMaterials, bool withColliders)
        {
            void DescribeGrid(KernelVariants kernel)
            {
                stage.Kernel(kernel.For(withColliders), cycles);
                if (withMaterials > 0)
                    stage.Kernel(kernel.For(withColliders, true), withMaterials);
            }

            int levels = (grid.FirstTailLevel - 1) * (cycles + withMaterials);
            DescribeGrid(smooth);
            DescribeGrid(restrictGrid);
            if (levels > 0)
            {
                stage.Kernel(smoothLevel, levels);
                stage.Kernel(restrictLevel, levels);
                stage.Kernel(correctAndSmoothLevel, levels);
            }
            stage.Kernel(solveCoarseLevels, cycles + withMaterials);
            DescribeGrid(correctAndSmooth);
            buffers.Describe(stage);
        }

        public void Dispose() => buffers.Dispose();

        void RecordSmooth(CommandBuffer cmd, int kernel, int tile, GraphicsBuffer source, GraphicsBuffer diagonal, GraphicsBuffer densities,
            GraphicsBuffer from, GraphicsBuffer to)
        {
            Ids.Smooth.Bind(cmd, shader, kernel, source, diagonal, densities, from, to);
            DispatchTiles(cmd, kernel, tile, grid.Counts);
        }

        void RecordSmoothLevel(CommandBuffer cmd, int kernel, int level)
        {
            cmd.SetComputeIntParam(shader, Ids.Level, level);
            buffers.Bind(cmd, shader, kernel);
            DispatchTiles(cmd, kernel, path.SmallTiles ? SmallTile : LargeTile, (int3)grid.Level(level).xyz);
        }

        void DispatchTiles(CommandBuffer cmd, int kernel, int tile, int3 counts)
        {
            int3 tiles = (counts + tile - 1) / tile;
            cmd.DispatchCompute(shader, kernel, tiles.x, tiles.y, tiles.z);
        }

        static class Ids
        {
            public static readonly ShaderParameters Restrict = new ShaderParameters("_Source", "_Diagonal", "_CellDensities", "_Potential");
            public static readonly ShaderParameters Smooth = new ShaderParameters(
                "_Source", "_Diagonal", "_CellDensities", "_Potential", "_Smoothed");
            public static readonly int Level = Shader.PropertyToID("_Level");
        }
    }
}
