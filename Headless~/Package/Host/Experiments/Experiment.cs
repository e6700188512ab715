using System;
using System.Collections.Generic;
using System.Linq;
using Host.Bench;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Experiments
{
    /// <summary>A scene run with one setting: statistics over time, and GPU time by window and stage.</summary>
    sealed class Experiment
    {
        const int InitialFirst = 3, InitialLast = 10, MovingFirst = 20, MovingLast = 60, SettledSteps = 100;
        const double SettledSeconds = 2, MovingFrom = 0.2, MovingTo = 2;

        public readonly ExperimentScene Scene;
        public readonly StepInput Input;
        public readonly List<FluidStatistics> Samples = new();
        /// <summary>Milliseconds of each timed step by window ("initial", "moving", "settled") and stage; "step" is the whole.</summary>
        public readonly Dictionary<string, Dictionary<string, List<double>>> Times = new();
        /// <summary>Bytes of all buffers of the solver.</summary>
        public long Bytes { get; private set; }

        Experiment(ExperimentScene scene, in StepInput input)
        {
            Scene = scene;
            Input = input;
        }

        /// <param name="seconds">Fluid time.</param>
        /// <param name="sampleEvery">Steps between statistics; a step that follows one is not timed.</param>
        public static Experiment Run(ExperimentScene scene, in StepInput input, double seconds, int sampleEvery)
        {
            using var solver = new PackageSolver(scene.LayoutFor(input.settings), input);
            return Run(solver, scene, input, seconds, sampleEvery, _ => false);
        }

        /// <param name="solver">Empty, and made for this input.</param>
        /// <param name="isOver">Whether a run that has come to this is not worth its end.</param>
        public static Experiment Run(PackageSolver solver, ExperimentScene scene, in StepInput input, double seconds, int sampleEvery,
            Func<Experiment, bool> isOver)
        {
            var experiment = new Experiment(scene, input);
            scene.Fill(solver.Add);
            experiment.Play(solver, (int)Math.Round(seconds / input.timeStep), sampleEvery, isOver);
            experiment.Bytes = solver.Bytes;
            return experiment;
        }

        public double Time(FluidStatistics sample) => sample.step * (double)Input.timeStep;
        public double End => Time(Samples[^1]);

        public IEnumerable<FluidStatistics> SettledSamples => Samples.Where(s => Time(s) > End - SettledSeconds - 1e-6);
        public double Settled(Func<FluidStatistics, double> value) => SettledSamples.Average(value);
        public double Moving(Func<FluidStatistics, double> value)
            => Samples.Where(s => Time(s) >= MovingFrom - 1e-6 && Time(s) <= MovingTo + 1e-6).Select(value).DefaultIfEmpty(double.NaN)
            .Average();

        /// <summary>Times of the steps of a window; NaN where nothing was timed.</summary>
        public StepTimes.Spread TimesOf(string window, string stage = StepTimes.Step)
            => Times.TryGetValue(window, out Dictionary<string, List<double>> stages) && stages.TryGetValue(stage, out List<double> values)
                ? StepTimes.Spread.Of(values) : StepTimes.Spread.None;

        /// <summary>Median; NaN where nothing was timed.</summary>
        public double Milliseconds(string window, string stage = StepTimes.Step) => TimesOf(window, stage).Median;

        void Play(PackageSolver solver, int steps, int sampleEvery, Func<Experiment, bool> isOver)
        {
            IGraphicsDevice device = Player.Device;
            using var cmd = new CommandBuffer { name = "experiment" };
            Measure(solver, cmd);
            for (int step = 1; step <= steps; step++)
            {
                string window = step is >= InitialFirst and <= InitialLast ? "initial" : step is >= MovingFirst and <= MovingLast ? "moving"
                    : step > steps - SettledSteps ? "settled" : null;
                bool afterSample = (step - 1) % sampleEvery == 0;
                device.Timing = window != null && !afterSample;
                cmd.Clear();
                cmd.BeginSample("step");
                solver.Step(cmd);
                cmd.EndSample("step");
                Graphics.ExecuteCommandBuffer(cmd);
                if (device.Timing)
                {
                    device.Flush();
                    Collect(window, device.CollectSamples());
                    device.Timing = false;
                }
                if (step % sampleEvery != 0 && step != steps)
                    continue;
                Measure(solver, cmd);
                if (isOver(this))
                    return;
            }
        }

        void Measure(PackageSolver solver, CommandBuffer cmd)
        {
            cmd.Clear();
            solver.RecordStatistics(cmd);
            Graphics.ExecuteCommandBuffer(cmd);
            Samples.Add(solver.FetchStatistics());
        }

        void Collect(string window, IEnumerable<DeviceSample> samples)
        {
            if (!Times.TryGetValue(window, out Dictionary<string, List<double>> stages))
                Times[window] = stages = new Dictionary<string, List<double>>();
            foreach (IGrouping<string, DeviceSample> stage in samples.GroupBy(sample => sample.Name))
            {
                if (!stages.TryGetValue(stage.Key, out List<double> values))
                    stages[stage.Key] = values = new List<double>();
                values.Add(stage.Sum(sample => sample.Milliseconds));
            }
        }
    }
}
