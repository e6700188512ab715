using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report
{
    /// <summary>Times at which a signal that goes to and fro turns back: each time that of a parabola through the samples around the extreme
    /// one.</summary>
    static class TurningPoints
    {
        /// <summary>In order, the first of them highest or lowest as it comes. What the signal begins and ends with is none.</summary>
        /// <param name="least">How far the signal must go back until it has turned, as a fraction of all that it spans: less is a ripple.</param>
        /// <param name="window">Of the parabola to both sides, s.</param>
        public static List<double> Of(IReadOnlyList<(double Time, double Value)> samples, double least, double window)
        {
            double back = least * (samples.Max(s => s.Value) - samples.Min(s => s.Value));
            var found = new List<double>();
            int highest = 0, lowest = 0, direction = 0;
            for (int i = 1; i < samples.Count; i++)
            {
                double value = samples[i].Value;
                highest = value > samples[highest].Value ? i : highest;
                lowest = value < samples[lowest].Value ? i : lowest;
                bool fell = direction >= 0 && value < samples[highest].Value - back, rose = direction <= 0 && value > samples[lowest].Value + back;
                if (!fell && !rose)
                    continue;
                int turn = fell ? highest : lowest;
                if (turn > 0)
                    found.Add(Vertex(samples, turn, window));
                direction = fell ? -1 : 1;
                highest = lowest = i;
            }
            return found;
        }

        // Least squares about the extreme sample: y = a + b s + c s², s = time - time of that sample.
        static double Vertex(IReadOnlyList<(double Time, double Value)> samples, int at, double window)
        {
            double time = samples[at].Time;
            (double S, double Y)[] near = samples.Where(s => Math.Abs(s.Time - time) <= window)
                .Select(s => (s.Time - time, s.Value - samples[at].Value)).ToArray();
            double n = near.Length, s1 = near.Sum(p => p.S), s2 = near.Sum(p => p.S * p.S), s3 = near.Sum(p => Math.Pow(p.S, 3)),
                s4 = near.Sum(p => Math.Pow(p.S, 4));
            double y0 = near.Sum(p => p.Y), y1 = near.Sum(p => p.S * p.Y), y2 = near.Sum(p => p.S * p.S * p.Y);
            double all = Determinant(n, s1, s2, s1, s2, s3, s2, s3, s4);
            double b = Determinant(n, y0, s2, s1, y1, s3, s2, y2, s4), c = Determinant(n, s1, y0, s1, s2, y1, s2, s3, y2);
            // Fewer than 3 samples make no parabola, and one that is flat has no vertex within the window.
            return n < 3 || all == 0 || Math.Abs(b) > 2 * Math.Abs(c) * window ? time : time - b / (2 * c);
        }

        static double Determinant(double a, double b, double c, double d, double e, double f, double g, double h, double i)
            => a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
    }
}
