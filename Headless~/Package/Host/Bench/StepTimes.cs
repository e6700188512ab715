using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Bench
{
    /// <summary>GPU milliseconds of a solver's steps within a window of a scene that is played from its start until there are enough.</summary>
    static class StepTimes
    {
        /// <summary>The whole step among the stages.</summary>
        public const string Step = "step";
        public const int MinSteps = 100;

        const int WarmUpMilliseconds = 2000;

        // Steps 3-10 of the fresh block and 20-60 of the moving one.
        public static readonly (string Name, int First, int Last)[] Windows = { ("initial", 3, 10), ("moving", 20, 60) };

        // Long after: the lattice that the block began as, which is quicker to search than water, is gone with and without colliders.
        public static readonly (string Name, int First, int Last) Settled = ("settled", 600, 700);

        /// <param name="fill">Fills the solver, which was just cleared.</param>
        /// <param name="after">Recorded after each step and timed with it; null for nothing.</param>
        /// <param name="before">Called before each step that is measured; null for nothing.</param>
        /// <returns>By stage.</returns>
        public static Dictionary<string, Spread> Measure(PbfSolver solver, Action<PbfSolver> fill, in StepInput input, int first, int last,
            int steps, Action<CommandBuffer> after = null, Action before = null)
        {
            IGraphicsDevice device = Player.Device;
            var times = new Dictionary<string, List<double>>();
            using var cmd = new CommandBuffer { name = "bench" };
            WarmUp(device, cmd, solver, fill, input);
            int measured = 0;
            while (measured < steps)
            {
                solver.Clear();
                fill(solver);
                for (int step = 1; step <= last && measured < steps; step++)
                {
                    if (step < first)
                    {
                        Play(device, cmd, solver, input, after);
                        continue;
                    }
                    before?.Invoke();
                    measured++;
                    foreach (IGrouping<string, DeviceSample> stage in Time(device, cmd, solver, input, after).GroupBy(sample => sample.Name))
                    {
                        if (!times.TryGetValue(stage.Key, out List<double> list))
                            times[stage.Key] = list = new List<double>();
                        list.Add(stage.Sum(sample => sample.Milliseconds));
                    }
                }
                device.WaitIdle();
            }
            return times.ToDictionary(pair => pair.Key, pair => Spread.Of(pair.Value));
        }

        /// <summary>Takes one step and times it.</summary>
        public static IReadOnlyList<DeviceSample> Time(IGraphicsDevice device, CommandBuffer cmd, PbfSolver solver, in StepInput input,
            Action<CommandBuffer> after = null)
        {
            device.Timing = true;
            Play(device, cmd, solver, input, after);
            device.Timing = false;
            return device.CollectSamples();
        }

        static void Play(IGraphicsDevice device, CommandBuffer cmd, PbfSolver solver, in StepInput input, Action<CommandBuffer> after)
        {
            cmd.Clear();
            cmd.BeginSample(Step);
            solver.Step(cmd, input);
            after?.Invoke(cmd);
            cmd.EndSample(Step);
            Graphics.ExecuteCommandBuffer(cmd);
            device.Flush();
        }

        // A GPU that idled while a scene was made and its kernels were compiled lowers its clock, to a third on an H200, and raises it
        // only under steady load.
        static void WarmUp(IGraphicsDevice device, CommandBuffer cmd, PbfSolver solver, Action<PbfSolver> fill, in StepInput input)
        {
            if (device.Info.IsSoftware)
                return;
            solver.Clear();
            fill(solver);
            Play(device, cmd, solver, input, null);        // compiles
            for (var watch = Stopwatch.StartNew(); watch.ElapsedMilliseconds < WarmUpMilliseconds;)
                Play(device, cmd, solver, input, null);
            device.WaitIdle();
        }

        /// <summary>Median, the values that a tenth is below and above, and the mean, which counts what is done every second step or less.</summary>
        public readonly record struct Spread(double Median, double Low, double High, double Mean, int Count)
        {
            public static readonly Spread None = new(double.NaN, double.NaN, double.NaN, double.NaN, 0);

            public static Spread Of(List<double> values)
            {
                var sorted = values.OrderBy(value => value).ToList();
                double At(double fraction) => sorted[(int)Math.Round(fraction * (sorted.Count - 1))];
                return new Spread(At(0.5), At(0.1), At(0.9), sorted.Average(), sorted.Count);
            }
        }
    }
}
