using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The measures by which pictures are compared. The figures come from a second program in Python, written from the paper's formulas
    /// as loops over pixels. Its primaries of sRGB are the standard's digits, which differ from the paper's in the fifth.</summary>
    public class PictureDifferenceTests
    {
        const int Width = 20, Height = 14;

        [Test]
        public void Flip_is_0_for_equal_pictures_and_1_for_green_against_blue()
        {
            Assert.That(Flip.Mean(First(), First(), Width, Height), Is.Zero);
            Assert.That(OfColors(new double3(0, 1, 0), new double3(0, 0, 1)), Is.EqualTo(1.0).Within(1e-9));
        }

        [Test]
        public void Flip_of_two_even_colors_is_the_papers()
        {
            Assert.That(OfColors(0.0, 1.0), Is.EqualTo(0.967379).Within(2e-5));
            Assert.That(OfColors(0.5, 0.6), Is.EqualTo(0.285010).Within(2e-5));
            Assert.That(OfColors(new double3(1, 0, 0), new double3(0, 1, 0)), Is.EqualTo(0.986661).Within(2e-5));
            Assert.That(OfColors(new double3(0.2, 0.4, 0.6), new double3(0.25, 0.38, 0.5)), Is.EqualTo(0.241720).Within(2e-5));
        }

        [Test]
        public void Flip_of_two_patterns_is_the_papers_in_each_pixel()
        {
            double[] map = Flip.Map(First(), Second(), Width, Height);
            Assert.That(map[0], Is.EqualTo(0.821244).Within(2e-5));
            Assert.That(map[7 * Width + 9], Is.EqualTo(0.572234).Within(2e-5));
            Assert.That(map[13 * Width + 19], Is.EqualTo(0.518657).Within(2e-5));
            Assert.That(Flip.Mean(First(), Second(), Width, Height), Is.EqualTo(0.619192).Within(2e-5));
        }

        // Hardly a color for the eye, but a point.
        [Test]
        public void Flip_sees_a_single_white_pixel_by_its_features()
        {
            double3[] black = Picture((x, y) => 0.0), dot = Picture((x, y) => x == 10 && y == 7 ? 1.0 : 0.0);
            double[] map = Flip.Map(black, dot, Width, Height);
            Assert.That(map[7 * Width + 10], Is.EqualTo(0.865041).Within(2e-5));
            Assert.That(map[7 * Width + 12], Is.EqualTo(0.480467).Within(2e-5));
            Assert.That(Flip.Mean(black, dot, Width, Height), Is.EqualTo(0.051096).Within(2e-5));
        }

        [Test]
        public void Flip_does_not_ask_which_picture_is_the_reference()
            => Assert.That(Flip.Mean(First(), Second(), Width, Height), Is.EqualTo(Flip.Mean(Second(), First(), Width, Height)).Within(1e-12));

        // Standing and lying.
        [Test]
        public void Flip_treats_rows_as_columns()
        {
            double3[] Turned(double3[] picture)
            {
                var turned = new double3[picture.Length];
                for (int i = 0; i < turned.Length; i++)
                    turned[i] = picture[i % Height * Width + i / Height];
                return turned;
            }
            double lying = Flip.Mean(First(), Second(), Width, Height), standing = Flip.Mean(Turned(First()), Turned(Second()), Height, Width);
            Assert.That(standing, Is.EqualTo(lying).Within(1e-12));
        }

        [Test]
        public void Flip_and_SSIM_refuse_pictures_of_another_size()
        {
            Assert.Throws<ArgumentException>(() => Flip.Mean(First(), new double3[3], Width, Height));
            Assert.Throws<ArgumentException>(() => Ssim.Mean(new double[64], new double[65], 8, 8));
            Assert.Throws<ArgumentException>(() => Ssim.Mean(new double[49], new double[49], 7, 7));
        }

        // Tests one window, by hand: means 0.5 and 0.5, variance 0.25 each, covariance -0.25.
        [Test]
        public void SSIM_is_1_for_equal_pictures_and_negative_for_the_opposite()
        {
            var board = new double[64];
            for (int i = 0; i < 64; i++)
                board[i] = (i + i / 8) & 1;
            double[] opposite = Array.ConvertAll(board, value => 1.0 - value);
            Assert.That(Ssim.Mean(board, board, 8, 8), Is.EqualTo(1.0).Within(1e-12));
            Assert.That(Ssim.Mean(board, opposite, 8, 8), Is.EqualTo((-0.5 + 0.0009) / (0.5 + 0.0009)).Within(1e-12));
            double[] wide = new double[24 * 8], shifted = new double[24 * 8];
            for (int i = 0; i < wide.Length; i++)
                (wide[i], shifted[i]) = (i % 24 / 24.0, i % 24 / 24.0 + 0.2);
            Assert.That(Ssim.Mean(wide, shifted, 24, 8), Is.InRange(0.6, 0.98));
        }

        static double OfColors(double3 a, double3 b) => Flip.Mean(Picture((x, y) => a), Picture((x, y) => b), Width, Height);

        static double3[] First()
            => Picture((x, y) => new double3((x * 7 + y * 3) % 11 / 10.0, (x * x + 2 * y) % 7 / 6.0, (x + y * 5) % 13 / 12.0));

        static double3[] Second()
            => Picture((x, y) => x > 8 ? new double3((x * 7 + y * 3) % 11 / 10.0, (x * x + 2 * y) % 7 / 6.0 * 0.8, 1.0 - (x + y * 5) % 13 / 12.0)
                : new double3(0.3, 0.5, 0.7));

        static double3[] Picture(Func<int, int, double3> color)
        {
            var picture = new double3[Width * Height];
            for (int i = 0; i < picture.Length; i++)
                picture[i] = color(i % Width, i / Width);
            return picture;
        }
    }
}
