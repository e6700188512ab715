using System;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Structural similarity of two pictures (Wang, Bovik, Sheikh and Simoncelli 2004): 1 for equal ones.</summary>
    static class Ssim
    {
        const int Window = 8, Step = 2;     // pixels
        const double Steady = 0.01 * 0.01, Contrast = 0.03 * 0.03;

        /// <summary>Luminance of a linear color as a screen shows it.</summary>
        public static double Luminance(double3 linear)
            => Math.Pow(Math.Max(math.dot(linear, new double3(0.2126, 0.7152, 0.0722)), 0.0), 1.0 / 2.2);

        /// <summary>Mean over windows of 8 x 8 pixels, each two pixels from the next.</summary>
        /// <param name="a">Luminances from 0 to 1, row by row.</param>
        public static double Mean(double[] a, double[] b, int width, int height)
        {
            if (a.Length != width * height || b.Length != width * height || width < Window || height < Window)
                throw new ArgumentException($"SSIM: two pictures of {width} x {height} pixels, {Window} x {Window} at least.");
            double sum = 0.0;
            int count = 0;
            for (int y = 0; y + Window <= height; y += Step)
                for (int x = 0; x + Window <= width; x += Step, count++)
                {
                    double meanA = 0.0, meanB = 0.0, squareA = 0.0, squareB = 0.0, both = 0.0;
                    for (int i = 0; i < Window * Window; i++)
                    {
                        int at = (y + i / Window) * width + x + i % Window;
                        meanA += a[at];
                        meanB += b[at];
                        squareA += a[at] * a[at];
                        squareB += b[at] * b[at];
                        both += a[at] * b[at];
                    }
                    const double n = Window * Window;
                    (meanA, meanB) = (meanA / n, meanB / n);
                    double varianceA = squareA / n - meanA * meanA, varianceB = squareB / n - meanB * meanB, covariance = both / n - meanA * meanB;
                    sum += (2.0 * meanA * meanB + Steady) * (2.0 * covariance + Contrast)
                        / ((meanA * meanA + meanB * meanB + Steady) * (varianceA + varianceB + Contrast));
                }
            return sum / count;
        }
    }
}
