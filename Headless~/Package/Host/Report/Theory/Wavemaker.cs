using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Host.Report.Obstacles;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report
{
    /// <summary>
    /// A piston at the end of a long tank moves to and fro: the waves that leave it are H/S = 2 (cosh 2kh - 1) / (sinh 2kh + 2kh) as high
    /// as its stroke (Havelock 1929; Dean and Dalrymple 1991, section 6.2).
    /// </summary>
    static class Wavemaker
    {
        const int Thickness = 8;            // d
        const float Plate = 6f;             // d: of the piston
        const double Tank = 2.5;            // wave lengths
        const double Station = 1.5;         // depths from the piston's rest position: of what does not travel 2 % are left there
        const double Apart = 0.25;          // wave lengths from there to the second station
        const double FirstPeriod = 2.5, Periods = 2;        // of the measurement: after the front, before what the far wall returns
        const float Reach = 4f;             // d: of the mean over the length, whole so that a lattice that drifts by shows no waves

        public static double HeightOverStroke(double kh) => 2 * (Math.Cosh(2 * kh) - 1) / (Math.Sinh(2 * kh) + 2 * kh);

        /// <summary>Length of the waves, d.</summary>
        public static double Length(int layers, double kh) => 2 * Math.PI * layers / kh;

        /// <summary>Particles of a tank.</summary>
        public static double Particles(int layers, double kh) => Tank * Length(layers, kh) * layers * Thickness;

        /// <param name="layers">Depth h, d.</param>
        /// <param name="kh">Wave number times depth.</param>
        /// <param name="stroke">S, d.</param>
        /// <param name="spacing">m.</param>
        /// <returns>Height of the waves from trough to crest over the stroke, of their first harmonic, and how fast they run over what theory
        /// says. What the same tank shows while its piston rests is taken off: as the lattice settles it makes waves of its own, and the mean
        /// height has some part in a harmonic, as periods are not whole steps.</returns>
        public static (double Height, double Speed) Run(int layers, double kh, double stroke, float spacing, in StepInput input)
        {
            Complex[] moved = Harmonics(layers, kh, stroke, spacing, input), rested = Harmonics(layers, kh, 0, spacing, input);
            Complex first = moved[0] - rested[0], second = moved[1] - rested[1];
            double delay = (second / first).Phase / (2 * Math.PI);     // of the second station, periods
            return (2 * first.Magnitude / stroke, Apart / delay);
        }

        // The first harmonic of the water's height at both stations.
        static Complex[] Harmonics(int layers, double kh, double stroke, float spacing, in StepInput input)
        {
            double k = kh / layers, frequency = Math.Sqrt(FluidRun.Gravity / spacing * k * Math.Tanh(kh)), period = 2 * Math.PI / frequency;
            int length = (int)Math.Round(Tank * Length(layers, kh));
            var positions = new List<float3>();
            var random = new Random(7);
            FluidRun.AddBlock(positions, new float3(Plate, 0f, 0f), new int3(length, layers, Thickness), ref random);
            var box = new float3(Plate + length, 1.6f * layers, Thickness);
            using var run = new FluidRun("wavemaker", box, spacing, positions, _ => 0f, input);

            // From rest; the plate is thick enough to stay in the domain's wall at the end of its stroke.
            ColliderMotion piston = Solids.Box(new float3(-Plate, -Plate, -Plate), new float3(Plate, box.y + Plate, box.z + Plate));
            float3 rest = piston.end.position;
            double weight = 2 * run.Input.timeStep / (Periods * period);
            double[] stations = { Plate + Station * layers, Plate + Station * layers + Apart * Length(layers, kh) };
            var harmonics = new Complex[stations.Length];
            while (run.Time < (FirstPeriod + Periods) * period)
            {
                double time = run.Time + run.Input.timeStep;
                piston.start = piston.end;
                piston.end.position = rest + new float3((float)(stroke / 2 * (1 - Math.Cos(frequency * time))), 0f, 0f);
                run.Use(piston);
                run.Step();
                if (run.Time <= FirstPeriod * period)
                    continue;
                float4[] points = run.ReadPositions();
                Complex turn = Complex.FromPolarCoordinates(weight, frequency * run.Time);
                for (int i = 0; i < stations.Length; i++)
                    harmonics[i] += HeightAt(points, (float)stations[i]) * turn;
            }
            return harmonics;
        }

        // Height of the water by its volume, d: a weighted mean that falls to both sides.
        static double HeightAt(float4[] positions, float x)
            => positions.Sum(p => math.max(1 - math.abs(p.x - x) / Reach, 0f)) / (double)(Reach * Thickness);
    }
}
