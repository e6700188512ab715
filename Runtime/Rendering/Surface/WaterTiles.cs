using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The tiles of one camera's picture that show a fluid's mesh, and those that show its spray: draws cover no more than those.</summary>
    sealed class WaterTiles
    {
        /// <summary>texels of a ray along each side of a tile, a multiple of 8</summary>
        [GenerateHlsl("WaterTiles")] public const int Tile = 16;

        /// <summary>bytes from the arguments of one list to those of the next</summary>
        [GenerateHlsl("WaterTiles")] public const uint TileCommand = GraphicsBuffer.IndirectDrawArgs.size;

        /// <summary>GraphicsBuffer.IndirectDrawArgs in <see cref="Arguments"/>.</summary>
        public const int WaterCommand = 0, SprayCommand = 1;

        const int Lists = 2, Words = 4;     // of a command

        static readonly uint[] start = new uint[Lists * Words];

        GraphicsBuffer tiles, arguments;

        /// <summary>See WaterTile.hlsl.</summary>
        public GraphicsBuffer Tiles => tiles;

        /// <summary>Draw arguments of both lists.</summary>
        public GraphicsBuffer Arguments => arguments;

        /// <summary>Returns how many words of TileMarks.hlsl so many texels of rays take: one for each tile and list.</summary>
        public static int MarksOf(int width, int height) => Lists * ((width + Tile - 1) / Tile) * ((height + Tile - 1) / Tile);

        /// <summary>Makes the buffers where they are missing or of another size.</summary>
        /// <param name="width">Width of the textures of rays, texels.</param>
        /// <param name="height">The same.</param>
        public void Fit(int width, int height)
        {
            int count = MarksOf(width, height);
            if (tiles != null && tiles.count == count)
                return;
            Release();
            tiles = GpuBuffer.Structured<uint>("Rill.Water.Tiles", count);
            arguments = GpuBuffer.Raw("Rill.Water.TileArguments", Lists * Words, GraphicsBuffer.Target.IndirectArguments);
            arguments.SetData(start);       // no vertices: a camera whose commands do not run draws nothing
        }

        /// <summary>Empties both lists.</summary>
        /// <param name="instances">Number of instances of each draw.</param>
        public void RecordStart(CommandBuffer cmd, int instances)
        {
            start[WaterCommand * Words + 1] = start[SprayCommand * Words + 1] = (uint)instances;
            cmd.SetBufferData(arguments, start);
        }

        public void Describe(StageDescription stage)
        {
            if (tiles == null)
                return;
            stage.Buffer("Rill.Water.Tiles", tiles);
            stage.Buffer("Rill.Water.TileArguments", arguments);
        }

        public void Release()
        {
            GpuBuffer.Release(ref tiles);
            GpuBuffer.Release(ref arguments);
        }
    }
}
