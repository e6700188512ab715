using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using Host.Output;
using Rill;
using UnityEngine;

namespace Host.Baking
{
    /// <summary>Slices of a distance field through its middle, one for each axis, side by side: blue inside, orange outside, black where it is zero.</summary>
    static class SlicePicture
    {
        // Horizontal, vertical and normal axis of each slice; y is up where it is in the slice.
        static readonly (int Right, int Up, int Normal)[] Views = { (2, 1, 0), (0, 2, 1), (0, 1, 2) };
        static readonly string[] Axes = { "x", "y", "z" };

        public static void Draw(SdfBake bake, string file)
        {
            float most = 0f;
            foreach (var view in Views)
                foreach (float distance in Slice(bake, view, bake.Resolution[view.Normal] / 2))
                    most = Math.Max(most, Math.Abs(distance));

            var script = new StringBuilder();
            void Line(FormattableString line) => script.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');
            Line($"set terminal pngcairo size 1500,640 font 'DejaVu Sans,10'");
            Line($"set output {Quote(file)}");
            for (int i = 0; i < Views.Length; i++)
                Data(script, i, Slice(bake, Views[i], bake.Resolution[Views[i].Normal] / 2), Lowest(bake, Views[i].Right), Lowest(bake, Views[i].Up), bake.VoxelSize);
            // The two halves do not meet in one colour, so that the sign of the smallest distance shows.
            Line($"set palette defined (-1 '#08306b', -0.4 '#2b7bba', 0 '#d6e6f4', 0 '#fdebd5', 0.4 '#ee7f26', 1 '#7f2704')");
            Line($"set cbrange [{-most:R}:{most:R}]");
            Line($"set colorbox horizontal user origin screen 0.3,0.1 size screen 0.4,0.03");
            Line($"set cblabel 'distance to the surface (m), negative inside; black: 0'");
            Line($"set size ratio -1");
            Line($"set tics nomirror out");
            Line($"set multiplot layout 1,3 margins screen 0.05,0.98,0.27,0.86 spacing screen 0.06 title {Quote($"{bake.Name}: {bake.Resolution.x} x {bake.Resolution.y} x {bake.Resolution.z} voxels of {bake.VoxelSize.ToString("G4", CultureInfo.InvariantCulture)} m")} noenhanced");
            for (int i = 0; i < Views.Length; i++)
            {
                (int right, int up, int normal) = Views[i];
                if (i > 0)
                    Line($"unset colorbox");
                Line($"set title '{Axes[normal]} = {Lowest(bake, normal) + bake.Resolution[normal] / 2 * bake.VoxelSize:G4} m'");
                Line($"set xlabel '{Axes[right]} (m)'");
                Line($"set ylabel '{Axes[up]} (m)'");
                Line($"set xrange [{bake.Bounds.min[right]:R}:{bake.Bounds.max[right]:R}]");
                Line($"set yrange [{bake.Bounds.min[up]:R}:{bake.Bounds.max[up]:R}]");
                Line($"plot $slice{i} using 1:2:3 with image notitle, $zero{i} using 1:2 with lines lw 1.5 lc rgb 'black' notitle");
            }
            Line($"unset multiplot");
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file)));
            Tool.Run("gnuplot", "gnuplot-nox", Array.Empty<string>(), script.ToString());
        }

        /// <summary>[up, right] of the voxels of one layer, m.</summary>
        internal static float[,] Slice(SdfBake bake, (int Right, int Up, int Normal) view, int layer)
        {
            Vector3Int n = bake.Resolution, at = default;
            var slice = new float[n[view.Up], n[view.Right]];
            at[view.Normal] = layer;
            for (at[view.Up] = 0; at[view.Up] < n[view.Up]; at[view.Up]++)
                for (at[view.Right] = 0; at[view.Right] < n[view.Right]; at[view.Right]++)
                    slice[at[view.Up], at[view.Right]] = bake.Distances[(at.z * n.y + at.y) * n.x + at.x];
            return slice;
        }

        static void Data(StringBuilder script, int index, float[,] slice, float x0, float y0, float voxel)
        {
            string At(float x, float y) => string.Create(CultureInfo.InvariantCulture, $"{x0 + x * voxel:R} {y0 + y * voxel:R}");
            script.Append($"$slice{index} << EOD\n");
            for (int y = 0; y < slice.GetLength(0); y++)
            {
                for (int x = 0; x < slice.GetLength(1); x++)
                    script.Append(At(x, y)).Append(' ').Append(slice[y, x].ToString("R", CultureInfo.InvariantCulture)).Append('\n');
                script.Append('\n');
            }
            script.Append($"EOD\n$zero{index} << EOD\n");
            List<(Vector2 From, Vector2 To)> pieces = ZeroLine.Of(slice);
            foreach ((Vector2 from, Vector2 to) in pieces)
                script.Append(At(from.x, from.y)).Append('\n').Append(At(to.x, to.y)).Append("\n\n");
            // gnuplot refuses data without any point.
            if (pieces.Count == 0)
                script.Append("NaN NaN\n");
            script.Append("EOD\n");
        }

        /// <summary>Of the centres of the first voxels, m.</summary>
        static float Lowest(SdfBake bake, int axis) => bake.Bounds.min[axis] + 0.5f * bake.VoxelSize;

        static string Quote(string text) => "'" + text.Replace("'", "''") + "'";
    }
}
