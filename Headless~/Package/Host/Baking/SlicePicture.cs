using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Host.Output;
using Rill.Editor;
using UnityEngine;

namespace Host.Baking
{
    /// <summary>Slices of a distance field through its center, one for each axis, side by side: blue inside, orange outside, black where it
    /// is zero.</summary>
    static class SlicePicture
    {
        static readonly SdfSlice[] Views = { SdfSlice.Across(0), SdfSlice.Across(1), SdfSlice.Across(2) };
        static readonly string[] Axes = { "x", "y", "z" };

        /// <returns>Whether it could: not without gnuplot.</returns>
        public static bool Draw(SdfVolume volume, string file)
        {
            if (!Tool.Gnuplot.IsInstalled)
                return false;
            float most = Views.Max(view => view.MaxDistance(volume, Center(volume, view)));

            var script = new StringBuilder();
            void Line(FormattableString line) => script.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');
            Line($"set terminal pngcairo size 1500,640 font 'DejaVu Sans,10'");
            Line($"set output {Quote(file)}");
            for (int i = 0; i < Views.Length; i++)
                Data(script, i, Views[i].Values(volume, Center(volume, Views[i])), Lowest(volume, Views[i].Right),
                    Lowest(volume, Views[i].Up), volume.VoxelSize);
            Line($"set palette defined ({string.Join(", ", DistanceColors.Stops.Select(stop => string.Create(CultureInfo.InvariantCulture, $"{stop.Fraction} '#{stop.Color.r:x2}{stop.Color.g:x2}{stop.Color.b:x2}'")))})");
            Line($"set cbrange [{-most:R}:{most:R}]");
            Line($"set colorbox horizontal user origin screen 0.3,0.1 size screen 0.4,0.03");
            Line($"set cblabel 'distance to the surface (m), negative inside; black: 0'");
            Line($"set size ratio -1");
            Line($"set tics nomirror out");
            Line($"set multiplot layout 1,3 margins screen 0.05,0.98,0.27,0.86 spacing screen 0.06 title {Quote($"{volume.Name}: {volume.Resolution.x} x {volume.Resolution.y} x {volume.Resolution.z} voxels of {volume.VoxelSize.ToString("G4", CultureInfo.InvariantCulture)} m")} noenhanced");
            for (int i = 0; i < Views.Length; i++)
            {
                (int right, int up, int normal) = (Views[i].Right, Views[i].Up, Views[i].Normal);
                if (i > 0)
                    Line($"unset colorbox");
                Line($"set title '{Axes[normal]} = {Views[i].PositionOf(volume, Center(volume, Views[i])):G4} m'");
                Line($"set xlabel '{Axes[right]} (m)'");
                Line($"set ylabel '{Axes[up]} (m)'");
                Line($"set xrange [{volume.Bounds.min[right]:R}:{volume.Bounds.max[right]:R}]");
                Line($"set yrange [{volume.Bounds.min[up]:R}:{volume.Bounds.max[up]:R}]");
                Line($"plot $slice{i} using 1:2:3 with image notitle, $zero{i} using 1:2 with lines lw 1.5 lc rgb 'black' notitle");
            }
            Line($"unset multiplot");
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file)));
            Tool.Gnuplot.Run(Array.Empty<string>(), script.ToString());
            return true;
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

        static int Center(SdfVolume volume, SdfSlice view) => volume.Resolution[view.Normal] / 2;

        /// <summary>Coordinates of the centers of the first voxels, m.</summary>
        static float Lowest(SdfVolume volume, int axis) => volume.Bounds.min[axis] + 0.5f * volume.VoxelSize;

        static string Quote(string text) => "'" + text.Replace("'", "''") + "'";
    }
}
