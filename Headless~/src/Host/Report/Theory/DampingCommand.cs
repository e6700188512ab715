using System;
using System.CommandLine;
using System.Globalization;
using Host.Fluids;
using Rill;

namespace Host.Report
{
    /// <summary><c>damping</c>: what the time step takes of motion that ideal water keeps, for numerical dampings and substeps.</summary>
    static class DampingCommand
    {
        const string Scenes = "slosh:<particles along 1 m>:<layers>:<wave, d>, vortex:<side, d>:<layers>:<m/s>, bucket:<radius, d>:<layers>:<rad/s> or utube:<width, d>:<depth, d>:<height, d>.";

        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = Scenes };
            var damping = new Option<float[]>("--damping") { Description = "Numerical dampings, as fractions of a first-order step's.", AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => new[] { 1f, 0.5f, 0f } };
            var substeps = new Option<int[]>("--substeps") { AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => new[] { 1, 2, 4 } };
            var iterations = new Option<int>("--iterations") { DefaultValueFactory = _ => 2 };
            var deep = new Option<DeepWater>("--deep-water") { DefaultValueFactory = _ => DeepWater.On };
            var seconds = new Option<double>("--seconds") { Description = "Fluid time of the motion; 0: four periods of a wave, three of a U-tube, 1 s of a vortex, 3.8 s of a bucket." };
            var smoothing = new Option<float>("--smoothing") { Description = "XSPH's.", DefaultValueFactory = _ => FluidMaterial.Water.velocitySmoothing };
            var command = new Command("damping", "Measures what the time step takes of sloshing and turning water.") { scene, damping, substeps, iterations, deep, seconds, smoothing };
            command.SetAction(parsed =>
            {
                using var session = new Session(Session.Root());
                Console.WriteLine(session.DescribeDevice());
                foreach (float fraction in parsed.GetValue(damping))
                    foreach (int count in parsed.GetValue(substeps))
                    {
                        StepInput input = FluidRun.Water(count, parsed.GetValue(iterations), parsed.GetValue(deep));
                        input.settings.numericalDamping = fraction;
                        input.material.velocitySmoothing = parsed.GetValue(smoothing);
                        Console.WriteLine($"{parsed.GetValue(scene)} damping {fraction} {count} x {input.settings.iterations}: {Run(parsed.GetValue(scene), input, parsed.GetValue(seconds))}");
                    }
                return 0;
            });
            return command;
        }

        static string Run(string scene, in StepInput input, double seconds)
        {
            string[] words = scene.Split(':');
            if (words.Length != 4 || !TryParse(words[1], out int size) || !TryParse(words[2], out int layers)
                || !double.TryParse(words[3], NumberStyles.Float, CultureInfo.InvariantCulture, out double strength) || !(strength > 0) || double.IsInfinity(strength))
                throw BadScene(scene);
            return words[0] switch
            {
                "slosh" => Slosh(size, layers, strength, input, seconds),
                "vortex" => Vortex(size, layers, (float)strength, input, seconds > 0 ? seconds : 1),
                "bucket" => Bucket(size, layers, strength, input, seconds > 0 ? seconds : 3.8),
                "utube" => Tube(size, layers, (int)strength, input, seconds),
                _ => throw BadScene(scene),
            };
        }

        static bool TryParse(string word, out int count) => int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out count) && count > 0;

        static HostException BadScene(string scene) => new HostException($"scene \"{scene}\": give {Scenes} Two whole numbers and one number, all above 0, as in slosh:40:20:2 or bucket:12:12:6.3.");

        static string Slosh(int along, int layers, double wave, in StepInput input, double seconds)
        {
            double depth = (double)layers / along, lean = Math.Atan(2 * wave / along), theory = Sloshing.Period(depth);
            DampedCosine fit = DampedCosine.Fit(Sloshing.Run(along, depth, lean, input, seconds > 0 ? seconds : 4 * theory));
            double first = FluidRun.FirstOrderDamping(theory, input);
            return Text($"period {fit.Period:0.000} s, {100 * (fit.Period / theory - 1):+0.0;-0.0} % of the theory's; damping {fit.Damping:0.000}/s, a first-order step's {first:0.000}; offset {(fit.Offset - Sloshing.Middle) / Sloshing.Offset(depth, lean):0.00}, misfit {100 * fit.Misfit:0.0} %");
        }

        static string Vortex(int side, int layers, float speed, in StepInput input, double seconds)
        {
            TaylorGreenVortex vortex = TaylorGreenVortex.Run(side, layers, speed, input, seconds);
            return Text($"{vortex.Left:0.000} of the amplitude after {vortex.Time:0.0} s, {vortex.LeftAtFirstOrder:0.000} by a first-order step alone: damping {vortex.Damping:0.00} of its; highest energy {vortex.MaxEnergy:0.0000}");
        }

        static string Bucket(int radius, int layers, double speed, in StepInput input, double seconds)
        {
            TurningTank tank = TurningTank.Run(radius, layers, speed, input, seconds);
            return Text($"{tank.Left:0.000} of its turning after {tank.Time:0.0} s, {tank.LeftAtFirstOrder:0.000} by a first-order step alone: damping {tank.Damping:0.00} of its; jitter {tank.Jitter:0.000} m/s");
        }

        static string Tube(int width, int depth, int height, in StepInput input, double seconds)
        {
            const float spacing = 0.025f;       // m
            double theory = UTube.Period(UTube.StraightLength(width, 2 * width, depth) * spacing);
            DampedCosine fit = DampedCosine.Fit(UTube.Run(width, 2 * width, depth, height, spacing, input, seconds > 0 ? seconds : 3 * theory));
            double first = FluidRun.FirstOrderDamping(theory, input);
            return Text($"period {fit.Period:0.000} s, {100 * (fit.Period / theory - 1):+0.0;-0.0} % of the theory's; damping {fit.Damping:0.000}/s, a first-order step's {first:0.000}; swings about {fit.Offset:0.00} d, misfit {100 * fit.Misfit:0.0} %");
        }

        static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
