using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;

namespace Host.Report
{
    /// <summary>The report's numerical damping: what the time step takes of motion at each setting, and what still water pays for less.</summary>
    static class NumericalDampingReport
    {
        const string Front = "experiment-damping", Fits = "experiment-damping-fits";
        const int NoiseSteps = 60, NoiseEvery = 5;
        const float ColumnSpacing = 0.05f;      // m
        const float VortexSpeed = 3f;           // m/s: fast, so that the time step takes more than the solver's own viscosity

        public static void Measure(ReportRun run)
        {
            float[] dampings = run.Quick ? new[] { 1f, 0.33f } : new[] { 1f, 0.67f, 0.5f, 0.33f, 0.2f, 0f };
            int[] substeps = run.Quick ? new[] { 1 } : new[] { 1, 2, 4 };
            (int side, int layers) vortex = run.Quick ? (16, 4) : (40, 8);
            (int radius, int layers) tank = run.Quick ? (8, 6) : (24, 24);
            (int along, double depth, double lean) wave = run.Quick ? (32, 0.35, 0.1) : (80, 0.35, 0.1);
            (int layers, int side, double settle) column = run.Quick ? (12, 8, 1) : (40, 24, 6);
            double theory = Sloshing.Period(Sloshing.NearestDepth(wave.along, wave.depth)), swings = run.Quick ? 1.6 : 4;

            var front = new ReportTable("damping", "substeps", "vortex", "tank", "period_error", "wave_damping_per_s", "jitter");
            var waves = new Dictionary<(float, int), double>();
            foreach (float damping in dampings)
                foreach (int count in substeps)
                {
                    StepInput input = FluidRun.Water(count, 2);
                    input.settings.numericalDamping = damping;
                    TaylorGreenVortex turns = TaylorGreenVortex.Run(vortex.side, vortex.layers, VortexSpeed, input, 1);
                    TurningTank turning = TurningTank.Run(tank.radius, tank.layers, 5, input, run.Quick ? 1 : 3.8);
                    DampedCosine swing = DampedCosine.Fit(Sloshing.Run(wave.along, Sloshing.NearestDepth(wave.along, wave.depth), wave.lean,
                        input, swings * theory));
                    double jitter = JitterOfColumn(column.layers, column.side, column.settle, input);
                    front.Add(damping, count, turns.Damping, turning.Damping, swing.Period / theory - 1, swing.Damping, jitter);
                    waves[(damping, count)] = swing.Damping;
                    run.Log($"  damping {damping}, {count} x 2: vortex {turns.Damping:0.00}, tank {turning.Damping:0.00}, wave " +
                        $"{swing.Damping:0.000}/s, jitter {jitter:0.000} m/s");
                }
            string settled = FormattableString.Invariant(
                $"60 steps a second, 2 iterations, deep water on; box of the vortex {vortex.side} x {vortex.layers} x {vortex.side} d, ") +
                FormattableString.Invariant($"{VortexSpeed} m/s, 1 s; tank of radius {tank.radius} d without friction, {tank.layers} layers, 5 rad/s; wave L/d ") +
                FormattableString.Invariant($"{wave.along}, H {wave.depth} m, {Sloshing.Wave(wave.lean) * wave.along:0.#} d high, {swings} periods; column of ") +
                FormattableString.Invariant($"{column.layers} layers, {column.settle} s");
            run.Save(Front, front, settled);

            var fits = new ReportTable("damping", "by_step_per_s", "left_per_s");
            foreach (float damping in dampings)
            {
                (double slope, double left) = Line(substeps.Select(count => (1.0 / count, waves[(damping, count)])).ToArray());
                fits.Add(damping, slope, left);
            }
            run.Save(Fits, fits, settled);
        }

        // Mean over the second after it has settled, m/s.
        static double JitterOfColumn(int layers, int side, double settle, StepInput input)
        {
            using var column = new FluidRun(ExperimentScene.Column(layers, ColumnSpacing, side), input);
            while (column.Time < settle)
                column.Step();
            var jitter = new List<double>();
            for (int step = 1; step <= NoiseSteps; step++)
            {
                column.Step();
                if (step % NoiseEvery == 0)
                    jitter.Add(column.Measure().jitter);
            }
            return jitter.Average();
        }

        // Least squares: y = slope x + offset.
        static (double Slope, double Offset) Line((double X, double Y)[] points)
        {
            double x = points.Average(p => p.X), y = points.Average(p => p.Y);
            double slope = points.Sum(p => (p.X - x) * (p.Y - y)) / points.Sum(p => (p.X - x) * (p.X - x));
            return (slope, y - slope * x);
        }

        public static void Write(ReportPage page)
        {
            ReportTable front = page.Load(Front), fits = page.Load(Fits);
            page.Heading("Damping against noise");
            page.Line("A step takes motion from water that ideal water keeps. *Numerical Damping* sets how much; still water pays for " +
                "less with noise. Vortex: the slowest flow along the walls of a flat box full of water (Taylor and Green 1937), " +
                "without a surface or curved walls. Tank: water that turns in a round tank. For both, what was lost over what a " +
                "first-order step takes. Wave: water that sloshes in its first mode, 4 d high. Noise: jitter of a still column.");
            page.Line();
            List<ReportTable.Row> all = front.Rows.ToList();
            page.Table(new[] { "numerical damping", "substeps", "vortex", "tank", "wave: period", "wave: damping, 1/s", "noise, m/s" },
                front.Rows.Select(row => new[]
            {
                row["damping"], row["substeps"], Figures.Fixed(row.Number("vortex"), 2), Figures.Fixed(row.Number("tank"), 2),
                    Figures.Percent(row.Number("period_error")), Figures.Fixed(row.Number("wave_damping_per_s"), 3),
                    Figures.Fixed(row.Number("jitter"), 3),
            }), i => all[i]["substeps"] == "1");
            page.Line($"({front.Settings}.)");
            page.Line();
            page.Line("Part of the wave's damping falls as the substeps rise, the step's, and part does not. Fitted as left + by step / substeps:");
            page.Line();
            page.Table(new[] { "numerical damping", "by step, 1/s", "left, 1/s" },
                fits.Rows.Select(row => new[] { row["damping"], Figures.Fixed(row.Number("by_step_per_s"), 3),
                Figures.Fixed(row.Number("left_per_s"), 3) }));
            string file = page.DataFile(Front);
            string[] substeps = front.Rows.Select(row => row["substeps"]).Distinct().ToArray();
            IEnumerable<string> lines = substeps.Select((count, i) => $"'{file}' using ($2=={count} ? $4 : NaN):(1000*$7):1 with " +
                $"linespoints ls {i + 1} title '{count} substeps', '{file}' using ($2=={count} ? $4 : NaN):(1000*$7):1 with labels " +
                $"offset 1.2,0.6 font ',8' tc ls {i + 1} notitle");
            page.Plot("experiment-damping", "Noise of still water over the damping of turning water, for numerical dampings from 0 to 1",
                "set xlabel 'damping of turning water, of a first-order step'\nset ylabel 'noise of still water, mm/s'\nset yrange " +
                "[0:*]\nplot " + string.Join(", \\\n", lines));
        }
    }
}
