using System;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>Particles by grid cell, cells numbered x first.</summary>
    static class CountingSort
    {
        /// <summary>Cell of a position; those outside belong to the nearest cell.</summary>
        public static int Cell(float3 position, float3 inverseCellSize, int3 counts)
        {
            int3 cell = default;
            for (int axis = 0; axis < 3; axis++)
                cell[axis] = Math.Min((int)Math.Max(position[axis] * inverseCellSize[axis], 0f), counts[axis] - 1);
            return (cell.z * counts.y + cell.y) * counts.x + cell.x;
        }

        /// <summary>For every cell the number of particles in all cells before; the total behind the last.</summary>
        public static uint[] Starts(int[] cells, int cellTotal)
        {
            var starts = new uint[cellTotal + 1];
            foreach (int cell in cells)
                starts[cell + 1]++;
            for (int cell = 0; cell < cellTotal; cell++)
                starts[cell + 1] += starts[cell];
            return starts;
        }

        /// <summary>Indices of the particles by cell, by id within a cell.</summary>
        public static int[] Order(int[] cells, uint[] ids)
        {
            return Enumerable.Range(0, cells.Length).OrderBy(i => cells[i]).ThenBy(i => ids[i]).ToArray();
        }
    }
}
