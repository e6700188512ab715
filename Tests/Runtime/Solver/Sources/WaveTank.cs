using System;
using System.Numerics;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>A narrow tank in which waves run from one end to the other. Lengths in d.</summary>
    /// <remarks>
    /// The first end is an open border whose velocity swings: it makes waves and takes what comes back. Before the other end the first harmonic of
    /// height η and flux q is split: of a wave that runs up the tank q is η ω / k, of one that runs down its negative (linear waves).
    /// </remarks>
    sealed class WaveTank : IDisposable
    {
        const float Spacing = 0.05f;
        const int Thickness = 4, Bin = 2;
        const float Between = 1f;               // wave lengths between the two ends' bands
        const float Measured = 0.5f;            // the last of them, wave lengths

        readonly TestFluid fluid;
        readonly int axis, layers, maker, length;
        readonly bool isReversed;
        readonly double wave, speed;

        /// <param name="wave">Wave length, d.</param>
        /// <param name="layers">Depth, d.</param>
        /// <param name="amplitude">About that of the waves, d.</param>
        /// <param name="kind">Of the end that the waves run to.</param>
        /// <param name="band">Width of its band, d; 0 for a wall.</param>
        /// <param name="axis">Axis of the box along which the tank lies, 0 or 2.</param>
        /// <param name="isReversed">Whether the waves run to the lower end.</param>
        public WaveTank(float wave, int layers, float amplitude, BorderKind kind, float band, int axis = 0, bool isReversed = false)
        {
            this.axis = axis;
            this.layers = layers;
            this.wave = wave;
            this.isReversed = isReversed;
            maker = (int)math.max(12f, 0.35f * wave);
            length = maker + (int)math.round(Between * wave) + (int)band;
            int3 counts = layers;
            counts[axis] = length;
            counts[2 - axis] = Thickness;
            float3 box = counts;
            box.y = layers + 8;
            SolverSettings settings = SolverSettings.Default;
            settings.numericalDamping = 0f;
            fluid = new TestFluid(box * Spacing, Spacing, counts.x * counts.y * counts.z, settings);
            fluid.Input.material.velocitySmoothing = 0f;
            fluid.AddBlock(0f, (float3)counts * Spacing);
            speed = amplitude * Frequency;

            FluidBorders borders = FluidBorders.Default;
            borders[LastSide ^ 1] = new FluidBorder { kind = BorderKind.Open, width = maker * Spacing, level = layers * Spacing };
            borders[LastSide] = new FluidBorder { kind = kind, width = math.max(band, 4f) * Spacing, level = layers * Spacing };
            fluid.Input.borders = borders;
        }

        int LastSide => axis + (isReversed ? 0 : 1);

        double WaveNumber => 2 * Math.PI / wave;

        /// <summary>rad/s.</summary>
        double Frequency => Math.Sqrt(9.81 / Spacing * WaveNumber * Math.Tanh(WaveNumber * layers));

        double Period => 2 * Math.PI / Frequency;

        /// <summary>Plays until the waves are steady, and then some periods.</summary>
        /// <returns>Amplitude of the waves that run to the end, d, and the energy of those that come back over theirs.</returns>
        public (double Amplitude, double Reflected) Run(int settle = 4, int periods = 2)
        {
            float dt = fluid.Input.timeStep;
            int every = Math.Max((int)(Period / dt / 24), 1);
            int first = (int)(settle * Period / dt) / every, samples = (int)Math.Round(periods * Period / dt / every);
            int bins = (int)(Measured * wave) / Bin;
            var height = new Complex[bins];
            var flux = new Complex[bins];
            for (int sample = 0; sample < first + samples; sample++)
            {
                for (int i = 0; i < every; i++)
                {
                    FluidBorder border = fluid.Input.borders[LastSide ^ 1];
                    double time = (sample * every + i) * dt;
                    border.velocity = (float)(speed * Spacing * Math.Min(time / Period, 1.0) * Math.Sin(Frequency * time));
                    fluid.Input.borders[LastSide ^ 1] = border;
                    fluid.Step();
                }
                if (sample >= first)
                    Add(Complex.FromPolarCoordinates(2.0 / samples, Frequency * (sample + 1) * every * dt), height, flux);
            }
            Complex up = 0, down = 0;
            for (int b = 0; b < bins; b++)
            {
                Complex turn = Complex.FromPolarCoordinates(0.5 / bins, WaveNumber * (b + 0.5) * Bin);
                Complex other = flux[b] * new Complex(WaveNumber / Frequency, 0.0);
                up += (height[b] + other) * Complex.Conjugate(turn);
                down += (height[b] - other) * turn;
            }
            return (up.Magnitude, down.Magnitude * down.Magnitude / (up.Magnitude * up.Magnitude));
        }

        // Adds the water's height and flux before the end, times a weight.
        void Add(Complex weight, Complex[] height, Complex[] flux)
        {
            ParticleState state = fluid.Read();
            double start = maker + (Between - Measured) * wave;
            for (int i = 0; i < state.Count; i++)
            {
                float along = state.positions[i][axis];
                double x = (isReversed ? length - along : along) - start;
                if (x < 0 || x >= height.Length * Bin)
                    continue;
                Complex part = weight / new Complex(Bin * Thickness, 0.0);
                height[(int)(x / Bin)] += part;
                flux[(int)(x / Bin)] += part * new Complex((isReversed ? -1.0 : 1.0) * state.velocities[i][axis], 0.0);
            }
        }

        public void Dispose() => fluid.Dispose();
    }
}
