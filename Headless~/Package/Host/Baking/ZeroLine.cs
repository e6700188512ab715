using System.Collections.Generic;
using UnityEngine;

namespace Host.Baking
{
    /// <summary>Lines on which values on a grid change their sign: marching squares with linear interpolation.</summary>
    static class ZeroLine
    {
        /// <param name="values">[y, x]</param>
        /// <returns>Pieces of the line, in cells: value [y, x] lies at (x, y).</returns>
        public static List<(Vector2 From, Vector2 To)> Of(float[,] values)
        {
            var pieces = new List<(Vector2, Vector2)>();
            var crossings = new List<Vector2>(4);
            for (int y = 0; y + 1 < values.GetLength(0); y++)
                for (int x = 0; x + 1 < values.GetLength(1); x++)
                {
                    float a = values[y, x], b = values[y, x + 1], c = values[y + 1, x + 1], d = values[y + 1, x];
                    crossings.Clear();
                    if (a < 0 != b < 0) crossings.Add(new Vector2(x + a / (a - b), y));
                    if (b < 0 != c < 0) crossings.Add(new Vector2(x + 1, y + b / (b - c)));
                    if (c < 0 != d < 0) crossings.Add(new Vector2(x + d / (d - c), y + 1));
                    if (d < 0 != a < 0) crossings.Add(new Vector2(x, y + a / (a - d)));
                    if (crossings.Count == 2)
                        pieces.Add((crossings[0], crossings[1]));
                    else if (crossings.Count == 4)
                    {
                        // A saddle: its center says which corners hang together, and the line goes around the others.
                        bool joined = (a + b + c + d < 0) == (a < 0);
                        pieces.Add(joined ? (crossings[0], crossings[1]) : (crossings[3], crossings[0]));
                        pieces.Add(joined ? (crossings[2], crossings[3]) : (crossings[1], crossings[2]));
                    }
                }
            return pieces;
        }
    }
}
