using System;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>
    /// LDR-FLIP of Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
    /// Images": what a person sees who flips between two pictures, from 0 (nothing) to 1. Written by the paper; sections and constants are its own.
    /// </summary>
    static class Flip
    {
        /// <summary>Resolution of a screen 0.7 m away with 3840 pixels on 0.7 m, as the paper assumes.</summary>
        public const double PixelsPerDegree = 67.0;

        const double ColorPower = 0.7, ColorKnee = 0.4, ColorAtKnee = 0.95;      // q_c, p_c, p_t
        const double FeatureWidth = 0.082, FeaturePower = 0.5;                    // w degrees, q_f

        // Contrast sensitivity in the frequency domain, (a1, b1, a2, b2) of a sum of two Gaussians, section 4.1.1: achromatic, red-green,
        // blue-yellow.
        static readonly double[][] sensitivity =
        {
            new[] { 1.0, 0.0047, 0.0, 1e-5 }, new[] { 1.0, 0.0053, 0.0, 1e-5 }, new[] { 34.1, 0.04, 13.5, 0.025 },
        };

        // CIE XYZ of the primaries of linear sRGB, by columns, and of its white, D65.
        static readonly double3 red = new double3(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0);
        static readonly double3 green = new double3(8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0);
        static readonly double3 blue = new double3(4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0);
        static readonly double3 white = red + green + blue;

        /// <summary>The mean of <see cref="Map"/>.</summary>
        public static double Mean(double3[] reference, double3[] test, int width, int height)
        {
            double sum = 0.0;
            foreach (double value in Map(reference, test, width, height))
                sum += value;
            return sum / (width * height);
        }

        /// <param name="reference">sRGB from 0 to 1, row by row.</param>
        /// <returns>The difference of each pixel.</returns>
        public static double[] Map(double3[] reference, double3[] test, int width, int height, double pixelsPerDegree = PixelsPerDegree)
        {
            if (reference.Length != width * height || test.Length != width * height)
                throw new ArgumentException($"FLIP: two pictures of {width} x {height} pixels.");
            double3[] a = Array.ConvertAll(reference, Opponent), b = Array.ConvertAll(test, Opponent);
            double[] color = ColorDifference(Filtered(a, width, height, pixelsPerDegree), Filtered(b, width, height, pixelsPerDegree));
            double[] feature = FeatureDifference(a, b, width, height, pixelsPerDegree);
            var map = new double[color.Length];
            for (int i = 0; i < map.Length; i++)
                map[i] = Math.Pow(color[i], 1.0 - feature[i]);
            return map;
        }

        // colors

        static double3 Opponent(double3 srgb) => ToOpponent(new double3(Linear(srgb.x), Linear(srgb.y), Linear(srgb.z)));

        static double Linear(double srgb)
        {
            srgb = Math.Min(Math.Max(srgb, 0.0), 1.0);
            return srgb <= 0.04045 ? srgb / 12.92 : Math.Pow((srgb + 0.055) / 1.055, 2.4);
        }

        // YCxCz.
        static double3 ToOpponent(double3 linear)
        {
            double3 xyz = (red * linear.x + green * linear.y + blue * linear.z) / white;
            return new double3(116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z));
        }

        static double3 FromOpponent(double3 opponent)
        {
            double y = (opponent.x + 16.0) / 116.0;
            double3 xyz = new double3(y + opponent.y / 500.0, y, y - opponent.z / 200.0) * white;
            double volume = math.dot(red, math.cross(green, blue));
            return new double3(math.dot(xyz, math.cross(green, blue)), math.dot(xyz, math.cross(blue, red)),
                math.dot(xyz, math.cross(red, green))) / volume;
        }

        // CIE L*a*b*, its a and b by the Hunt effect, section 4.1.2: colors are paler where they are dark.
        static double3 HuntLab(double3 linear)
        {
            double3 xyz = (red * linear.x + green * linear.y + blue * linear.z) / white;
            double x = LabRoot(xyz.x), y = LabRoot(xyz.y), z = LabRoot(xyz.z), lightness = 116.0 * y - 16.0;
            return new double3(lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z));
        }

        static double LabRoot(double t)
        {
            const double bend = 6.0 / 29.0;
            return t > bend * bend * bend ? Math.Pow(t, 1.0 / 3.0) : t / (3.0 * bend * bend) + 4.0 / 29.0;
        }

        static double HyAb(double3 a, double3 b)
        {
            double3 difference = a - b;
            return Math.Abs(difference.x) + Math.Sqrt(difference.y * difference.y + difference.z * difference.z);
        }

        static double[] ColorDifference(double3[] a, double3[] b)
        {
            double most = Math.Pow(HyAb(HuntLab(new double3(0.0, 1.0, 0.0)), HuntLab(new double3(0.0, 0.0, 1.0))), ColorPower);
            double knee = ColorKnee * most;
            var difference = new double[a.Length];
            for (int i = 0; i < difference.Length; i++)
            {
                double power = Math.Pow(HyAb(a[i], b[i]), ColorPower);
                difference[i] = power < knee ? ColorAtKnee / knee * power
                    : ColorAtKnee + (power - knee) / (most - knee) * (1.0 - ColorAtKnee);
            }
            return difference;
        }

        /// <summary>Returns what an eye resolves of a picture, in Hunt-adjusted L*a*b*.</summary>
        static double3[] Filtered(double3[] opponent, int width, int height, double pixelsPerDegree)
        {
            double widest = 0.0;
            foreach (double[] channel in sensitivity)
                widest = Math.Max(widest, Math.Max(channel[1], channel[3]));
            int radius = (int)Math.Ceiling(3.0 * Math.Sqrt(widest / (2.0 * Math.PI * Math.PI)) * pixelsPerDegree);
            double[][] channels = Array.ConvertAll(sensitivity, channel => Sensitivity(channel, radius, pixelsPerDegree));
            var seen = new double3[opponent.Length];
            for (int c = 0; c < 3; c++)
            {
                double[] values = Convolved(Array.ConvertAll(opponent, color => color[c]), width, height, channels[c], radius);
                for (int i = 0; i < values.Length; i++)
                    seen[i][c] = values[i];
            }
            return Array.ConvertAll(seen, color => HuntLab(math.clamp(FromOpponent(color), 0.0, 1.0)));
        }

        static double[] Sensitivity(double[] of, int radius, double pixelsPerDegree)
        {
            int side = 2 * radius + 1;
            var kernel = new double[side * side];
            double sum = 0.0;
            for (int i = 0; i < kernel.Length; i++)
            {
                double x = (i % side - radius) / pixelsPerDegree, y = (i / side - radius) / pixelsPerDegree, square = x * x + y * y;
                kernel[i] = of[0] * Math.Sqrt(Math.PI / of[1]) * Math.Exp(-Math.PI * Math.PI * square / of[1])
                    + of[2] * Math.Sqrt(Math.PI / of[3]) * Math.Exp(-Math.PI * Math.PI * square / of[3]);
                sum += kernel[i];
            }
            return Array.ConvertAll(kernel, value => value / sum);
        }

        // features

        // Edges by the first, points by the second derivative of a Gaussian, section 4.2.
        static double[] FeatureDifference(double3[] a, double3[] b, int width, int height, double pixelsPerDegree)
        {
            double deviation = 0.5 * FeatureWidth * pixelsPerDegree;
            int radius = (int)Math.Ceiling(3.0 * deviation);
            double[] grayA = Array.ConvertAll(a, color => (color.x + 16.0) / 116.0), grayB = Array.ConvertAll(b, color => (color.x + 16.0) / 116.0);
            var difference = new double[a.Length];
            foreach (bool isPoint in new[] { false, true })
            {
                double[] across = Feature(deviation, radius, isPoint), up = Transposed(across, 2 * radius + 1);
                double[] ofA = Lengths(Convolved(grayA, width, height, across, radius), Convolved(grayA, width, height, up, radius));
                double[] ofB = Lengths(Convolved(grayB, width, height, across, radius), Convolved(grayB, width, height, up, radius));
                for (int i = 0; i < difference.Length; i++)
                    difference[i] = Math.Max(difference[i], Math.Abs(ofA[i] - ofB[i]));
            }
            return Array.ConvertAll(difference, value => Math.Pow(value / Math.Sqrt(2.0), FeaturePower));
        }

        // Positive and negative weights each add up to 1.
        static double[] Feature(double deviation, int radius, bool isPoint)
        {
            int side = 2 * radius + 1;
            var kernel = new double[side * side];
            double positive = 0.0, negative = 0.0;
            for (int i = 0; i < kernel.Length; i++)
            {
                double x = i % side - radius, y = i / side - radius, square = deviation * deviation;
                kernel[i] = Math.Exp(-(x * x + y * y) / (2.0 * square)) * (isPoint ? x * x / square - 1.0 : -x);
                positive += Math.Max(kernel[i], 0.0);
                negative -= Math.Min(kernel[i], 0.0);
            }
            return Array.ConvertAll(kernel, value => value / (value > 0.0 ? positive : negative));
        }

        static double[] Transposed(double[] kernel, int side)
        {
            var transposed = new double[kernel.Length];
            for (int i = 0; i < kernel.Length; i++)
                transposed[i] = kernel[i % side * side + i / side];
            return transposed;
        }

        static double[] Lengths(double[] x, double[] y)
        {
            var lengths = new double[x.Length];
            for (int i = 0; i < lengths.Length; i++)
                lengths[i] = Math.Sqrt(x[i] * x[i] + y[i] * y[i]);
            return lengths;
        }

        // Beyond the border the outermost pixels go on.
        static double[] Convolved(double[] values, int width, int height, double[] kernel, int radius)
        {
            int side = 2 * radius + 1, wide = width + 2 * radius;
            var padded = new double[wide * (height + 2 * radius)];
            for (int i = 0; i < padded.Length; i++)
            {
                int x = Math.Min(Math.Max(i % wide - radius, 0), width - 1), y = Math.Min(Math.Max(i / wide - radius, 0), height - 1);
                padded[i] = values[y * width + x];
            }
            var sums = new double[values.Length];
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                {
                    double sum = 0.0;
                    for (int row = 0; row < side; row++)
                    {
                        int from = (y + row) * wide + x, weight = row * side;
                        for (int column = 0; column < side; column++)
                            sum += kernel[weight + column] * padded[from + column];
                    }
                    sums[y * width + x] = sum;
                }
            return sums;
        }
    }
}
