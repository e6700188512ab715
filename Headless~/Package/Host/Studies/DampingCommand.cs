using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using Host.Experiments;
using Host.Report;
using Rill;

namespace Host.Studies
{
    /// <summary><c>damping</c>: what the time step takes of motion that ideal water keeps, for numerical dampings and substeps.</summary>
    static class DampingCommand
    {
        const string Scenes = "slosh:<particles along 1 m>:<layers>:<wave, d>, vortex:<side, d>:<layers>:<m/s>, bucket:<radius, " +
            "d>:<layers>:<rad/s>, utube:<width, d>:<depth, d>:<height, d> or wavemaker:<layers>:<kh>:<stroke, d>.";

        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = Scenes };
            var damping = new Option<float[]>("--damping") { Description = "Numerical dampings, as fractions of a first-order step's.",
                AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => new[] { 1f, 0.5f, 0f } };
            var substeps = new Option<int[]>("--substeps") { AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => new[] { 1, 2, 4 } };
            var iterations = new Option<int>("--iterations") { DefaultValueFactory = _ => 2 };
            var deep = new Option<DeepWater>("--deep-water") { DefaultValueFactory = _ => DeepWater.On };
            var seconds = new Option<double>("--seconds") {
                Description =
                "Fluid time of the motion; 0: four periods of a wave, three of a U-tube, 1 s of a vortex, 3.8 s of a bucket." };
            var smoothing = new Option<float>("--smoothing") { Description = "XSPH's.",
                DefaultValueFactory = _ => FluidMaterial.Water.velocitySmoothing };
            var command = new Command("damping", "Measures what the time step takes of sloshing and turning water.") { scene, damping,
                substeps, iterations, deep, seconds, smoothing };
            command.SetAction(parsed =>
            {
                string text = parsed.GetValue(scene);
                GivenNumber.CheckOption("--seconds", parsed.GetValue(seconds), 0, GivenNumber.MaxSeconds);
                List<StepInput> inputs = parsed.GetValue(damping).SelectMany(fraction => parsed.GetValue(substeps).Select(count =>
                {
                    StepInput input = FluidRun.Water(count, parsed.GetValue(iterations), parsed.GetValue(deep));
                    input.settings.numericalDamping = fraction;
                    input.material.velocitySmoothing = parsed.GetValue(smoothing);
                    GivenNumber.Clamp("damping", ref input.settings, ref input.material);
                    return input;
                })).ToList();
                // Before there is a device: what cannot be played or fitted is refused at once.
                Func<StepInput, string> run = Parse(text, parsed.GetValue(seconds));
                using var session = new Session(Session.Root());
                Console.WriteLine(session.DescribeDevice());
                foreach (StepInput input in inputs)
                    Console.WriteLine(Text($"{text} damping {input.settings.numericalDamping} {input.settings.substeps} x ") +
                        Text($"{input.settings.iterations}: {run(input)}"));
                return 0;
            });
            return command;
        }

        /// <summary>Returns a function that plays a scene and returns its figures.</summary>
        /// <param name="seconds">0 for what suits the scene.</param>
        /// <exception cref="HostException">The scene cannot be played, or the time is too short for its figures.</exception>
        public static Func<StepInput, string> Parse(string text, double seconds)
        {
            double[] n;
            switch (text.Split(':')[0])
            {
                case "slosh":
                    n = GivenNumber.Parse(text, "slosh:40:20:2", new GivenNumber("particles along 1 m", 8, 1000),
                        new GivenNumber("layers", 1, 1000), new GivenNumber("wave in spacings", 0.01, 1000, false));
                    GivenNumber.CheckParticles(text, n[0] * n[1] * Sloshing.Thickness);
                    if (n[2] >= n[1])
                        throw new HostException(Text($"scene \"{text}\": wave in spacings is {n[2]}, as high as the water is deep; give less ") +
                            Text($"than its {n[1]} layers, as in slosh:40:20:2."));
                    CheckSwings(seconds, Sloshing.Period(n[1] / n[0]));
                    return input => Slosh((int)n[0], (int)n[1], n[2], input, seconds);
                case "vortex":
                    n = GivenNumber.Parse(text, "vortex:40:8:3", new GivenNumber("side in spacings", 4, 2000),
                        new GivenNumber("layers", 2, 1000), new GivenNumber("speed in m/s", 0.001, 100, false));
                    GivenNumber.CheckParticles(text, n[0] * n[0] * n[1]);
                    CheckSteps(seconds);
                    return input => Vortex((int)n[0], (int)n[1], (float)n[2], input, seconds > 0 ? seconds : 1);
                case "bucket":
                    n = GivenNumber.Parse(text, "bucket:12:12:6.3", new GivenNumber("radius in spacings", 3, 1000),
                        new GivenNumber("layers", 1, 1000), new GivenNumber("turning in rad/s", 0.001, 100, false));
                    GivenNumber.CheckParticles(text, Math.PI * n[0] * n[0] * n[1]);
                    if (n[2] > TurningTank.MaxSpeed(n[0], n[1]))
                        throw new HostException(Text($"scene \"{text}\": turning in rad/s is {n[2]}, at which the center of the floor falls ") +
                            Text($"dry; give at most {Math.Floor(100 * TurningTank.MaxSpeed(n[0], n[1])) / 100}, or more layers."));
                    CheckSteps(seconds);
                    return input => Bucket((int)n[0], (int)n[1], n[2], input, seconds > 0 ? seconds : 3.8);
                case "utube":
                    n = GivenNumber.Parse(text, "utube:8:24:6", new GivenNumber("width in spacings", 2, 200),
                        new GivenNumber("depth in spacings", 3, 1000), new GivenNumber("height in spacings", 1, 1000));
                    GivenNumber.CheckParticles(text, (2.0 * n[1] + 2.0 * n[0]) * n[0] * UTube.Thickness);
                    if (n[1] - n[2] < n[0])
                        throw new HostException(Text($"scene \"{text}\": height in spacings is {n[2]}, which leaves the lower leg less than ") +
                            Text($"the passage of {n[0]} below; give at most {n[1] - n[0]}, that is depth less width, or more depth, as in ") +
                            "utube:8:24:6.");
                    CheckSwings(seconds, TubePeriod((int)n[0], (int)n[1]));
                    return input => Tube((int)n[0], (int)n[1], (int)n[2], input, seconds);
                case "wavemaker":
                    n = GivenNumber.Parse(text, "wavemaker:24:1:4", new GivenNumber("layers", 4, 1000),
                        new GivenNumber("kh, wave number times depth,", 0.1, 10, false), new GivenNumber("stroke in spacings", 0.1, 100, false));
                    GivenNumber.CheckParticles(text, Wavemaker.Particles((int)n[0], n[1]));
                    if (seconds > 0)
                        throw new HostException("--seconds: a wavemaker always runs for 4.5 periods; leave it out.");
                    return input => Waves((int)n[0], n[1], n[2], input);
                default:
                    throw new HostException($"scene \"{text}\": give {Scenes} As in slosh:40:20:2, vortex:40:8:3, bucket:12:12:6.3, " +
                        "utube:8:24:6 or wavemaker:24:1:4.");
            }
        }

        // A damped cosine fits less than that with any period.
        const double MinSwings = 2;

        static void CheckSwings(double seconds, double period)
        {
            if (seconds > 0 && seconds < MinSwings * period)
                throw new HostException(Text($"--seconds {seconds}: that is {seconds / period:0.0} swings, and a period is fitted to at least ") +
                    Text($"{MinSwings}; give {Math.Ceiling(100 * MinSwings * period) / 100} or more, or leave it out."));
        }

        static void CheckSteps(double seconds)
        {
            if (seconds > 0)
                GivenNumber.CheckOption("--seconds", seconds, 0.1, GivenNumber.MaxSeconds);
        }

        static string Slosh(int along, int layers, double wave, in StepInput input, double seconds)
        {
            double depth = (double)layers / along, lean = Math.Atan(2 * wave / along), theory = Sloshing.Period(depth);
            DampedCosine fit = DampedCosine.Fit(Sloshing.Run(along, depth, lean, input, seconds > 0 ? seconds : 4 * theory));
            double first = FluidRun.FirstOrderDamping(theory, input);
            return Text($"period {fit.Period:0.000} s, {100 * (fit.Period / theory - 1):+0.0;-0.0} % of the theory's; damping ") +
                Text($"{fit.Damping:0.000}/s, a first-order step's {first:0.000}; offset ") +
                Text($"{(fit.Offset - Sloshing.Center) / Sloshing.Offset(depth, lean):0.00}, misfit {100 * fit.Misfit:0.0} %");
        }

        static string Vortex(int side, int layers, float speed, in StepInput input, double seconds)
        {
            TaylorGreenVortex vortex = TaylorGreenVortex.Run(side, layers, speed, input, seconds);
            return Text($"{vortex.Left:0.000} of the amplitude after {vortex.Time:0.0} s, {vortex.LeftAtFirstOrder:0.000} by a first-order ") +
                Text($"step alone: damping {vortex.Damping:0.00} of its; highest energy {vortex.MaxEnergy:0.0000}");
        }

        static string Bucket(int radius, int layers, double speed, in StepInput input, double seconds)
        {
            TurningTank tank = TurningTank.Run(radius, layers, speed, input, seconds);
            return Text($"{tank.Left:0.000} of its turning after {tank.Time:0.0} s, {tank.LeftAtFirstOrder:0.000} by a first-order step ") +
                Text($"alone: damping {tank.Damping:0.00} of its; jitter {tank.Jitter:0.000} m/s");
        }

        const float TubeSpacing = 0.025f;       // m

        static double TubePeriod(int width, int depth) => UTube.Period(UTube.StraightLength(width, 2 * width, depth) * TubeSpacing);

        static string Tube(int width, int depth, int height, in StepInput input, double seconds)
        {
            double theory = TubePeriod(width, depth);
            DampedCosine fit = DampedCosine.Fit(UTube.Run(width, 2 * width, depth, height, TubeSpacing, input, seconds > 0 ? seconds : 3 * theory));
            double first = FluidRun.FirstOrderDamping(theory, input);
            return Text($"period {fit.Period:0.000} s, {100 * (fit.Period / theory - 1):+0.0;-0.0} % of the theory's; damping ") +
                Text($"{fit.Damping:0.000}/s, a first-order step's {first:0.000}; swings about {fit.Offset:0.00} d, misfit {100 * fit.Misfit:0.0} %");
        }

        static string Waves(int layers, double kh, double stroke, in StepInput input)
        {
            (double height, double speed) = Wavemaker.Run(layers, kh, stroke, WavemakerReport.Spacing, input);
            return Text($"height over stroke {height:0.000} of {Wavemaker.HeightOverStroke(kh):0.000}, speed {speed:0.000} of the theory's");
        }

        static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
