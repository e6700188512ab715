using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using Host.Fluids;
using Host.Report.Obstacles;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report
{
    /// <summary><c>damping</c>: what the time step takes of motion that ideal water keeps, for numerical dampings and substeps.</summary>
    static class DampingCommand
    {
        const string Scenes = "slosh:<particles along 1 m>:<layers>:<wave, d>, vortex:<side, d>:<layers>:<m/s> or bucket:<radius, d>:<layers>:<rad/s>.";
        const float SettlingTime = 1f;      // s

        public static Command Create()
        {
            var scene = new Argument<string>("scene") { Description = Scenes };
            var damping = new Option<float[]>("--damping") { Description = "Numerical dampings, as fractions of a first-order step's.", AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => new[] { 1f, 0.5f, 0f } };
            var substeps = new Option<int[]>("--substeps") { AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => new[] { 1, 2, 4 } };
            var iterations = new Option<int>("--iterations") { DefaultValueFactory = _ => 2 };
            var deep = new Option<DeepWater>("--deep-water") { DefaultValueFactory = _ => DeepWater.On };
            var seconds = new Option<double>("--seconds") { Description = "Fluid time of the motion; 0: four periods of a wave, 1 s of a vortex, 3.8 s of a bucket." };
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
                _ => throw BadScene(scene),
            };
        }

        static bool TryParse(string word, out int count) => int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out count) && count > 0;

        static HostException BadScene(string scene) => new HostException($"scene \"{scene}\": give {Scenes} Two whole numbers and one number, all above 0, as in slosh:40:20:2 or bucket:12:12:6.3.");

        static string Slosh(int along, int layers, double wave, in StepInput input, double seconds)
        {
            double depth = (double)layers / along, lean = Math.Atan(2 * wave / along), theory = Sloshing.Period(depth);
            DampedCosine fit = DampedCosine.Fit(Sloshing.Run(along, depth, lean, input, seconds > 0 ? seconds : 4 * theory));
            double frequency = 2 * Math.PI / theory, first = frequency * frequency * Substep(input) / 2;
            return Text($"period {fit.Period:0.000} s, {100 * (fit.Period / theory - 1):+0.0;-0.0} % of the theory's; damping {fit.Damping:0.000}/s, a first-order step's {first:0.000}; offset {(fit.Offset - Sloshing.Middle) / Sloshing.Offset(depth, lean):0.00}, misfit {100 * fit.Misfit:0.0} %");
        }

        // The slowest flow along the walls of a square tank, in turns about the vertical: u = U (sin x cos z, -cos x sin z), a Taylor-Green
        // vortex. What the step takes of the energy is q Δt times the mean of the squared acceleration, so dU/dt = -q Δt (π/L)² U³ / 2.
        static string Vortex(int side, int layers, float speed, in StepInput input, double seconds)
        {
            const float spacing = 0.05f;
            float wave = math.PI / side;
            float3 Flow(float3 p) => new float3(math.sin(wave * p.x) * math.cos(wave * p.z), 0f, -math.cos(wave * p.x) * math.sin(wave * p.z));
            double Amplitude(FluidRun run)
            {
                float4[] positions = run.ReadPositions(), velocities = run.ReadVelocities();
                return Enumerable.Range(0, positions.Length).Sum(i => (double)math.dot(velocities[i].xyz, Flow(positions[i].xyz))) / positions.Sum(p => math.lengthsq(Flow(p.xyz))) * spacing;
            }
            var still = new List<float3>();
            var random = new Random(7);
            for (int i = 0; i < side * side * layers; i++)
                still.Add(new float3(i % side, i / (side * side), i / side % side) + 0.5f + random.NextFloat3(-0.02f, 0.02f));
            float3 box = new float3(side, layers + side / 2f, side);
            using (var settling = new FluidRun("vortex", box, spacing, still, _ => 0f, input))
            {
                while (settling.Time < SettlingTime)
                    settling.Step();
                still = settling.ReadPositions().Select(p => p.xyz).ToList();
            }
            using var turning = new FluidRun("vortex", box, spacing, still, p => speed * Flow(p), input);
            double highest = 0, start = turning.Measure().Energy;
            while (turning.Time < seconds)
            {
                turning.Step();
                highest = Math.Max(highest, turning.Measure().Energy);
            }
            double left = Amplitude(turning) / speed, k = wave / spacing;
            return Text($"{left:0.000} of the amplitude after {turning.Time:0.0} s, {1 / Math.Sqrt(1 + k * k * speed * speed * Substep(input) * turning.Time):0.000} by a first-order step alone; highest energy {highest / start:0.0000}");
        }

        // Water that turns in a cylinder without friction.
        static string Bucket(int radius, int layers, double speed, in StepInput input, double seconds)
        {
            const float spacing = 0.025f;
            float middle = radius + 1f;
            double Surface(double r) => layers + speed * speed / (2 * FluidRun.Gravity) * (r * r - radius * radius / 2.0) * spacing;
            var random = new Random(7);
            var places = new List<float3>();
            for (int x = -radius; x < radius; x++)
                for (int z = -radius; z < radius; z++)
                {
                    double r = Math.Sqrt((x + 0.5) * (x + 0.5) + (z + 0.5) * (z + 0.5));
                    for (int y = 0; y < Math.Round(Surface(r)) && r <= radius - 0.3; y++)
                        places.Add(new float3(middle + x + 0.5f, y + 0.5f, middle + z + 0.5f) + random.NextFloat3(-0.02f, 0.02f));
                }
            float height = (float)Surface(radius) + radius;
            using var run = new FluidRun("bucket", new float3(2f * middle, height, 2f * middle), spacing, places, p => (float)speed * spacing * new float3(p.z - middle, 0f, middle - p.x), input);
            run.Use(Solids.RoundTank(radius, height, new float3(middle, height / 2f, middle)));
            while (run.Time < seconds)
                run.Step();
            float4[] positions = run.ReadPositions(), velocities = run.ReadVelocities();
            double momentum = 0, moment = 0;
            for (int i = 0; i < positions.Length; i++)
            {
                float2 arm = positions[i].xz - middle;
                momentum += arm.y * velocities[i].x - arm.x * velocities[i].z;
                moment += math.lengthsq(arm);
            }
            return Text($"{momentum / moment / speed:0.000} of its turning after {run.Time:0.0} s, {RotatingBucket.TurningLeft(speed, Substep(input), run.Time):0.000} by a first-order step alone; jitter {run.Measure().jitter:0.000} m/s");
        }

        static double Substep(in StepInput input) => input.timeStep / input.settings.substeps;

        static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
