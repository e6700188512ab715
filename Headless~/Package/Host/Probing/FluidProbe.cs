using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Host.Output;
using Rill;
using Object = UnityEngine.Object;

namespace Host.Probing
{
    /// <summary>A simulation's own statistics in a run's table: a value at the step at which a new measurement has come back.</summary>
    sealed class FluidProbe : IRunProbe
    {
        static readonly (string Column, Func<FluidStatistics, double> Value)[] Measures =
        {
            ("density_error_mean", s => s.densityError),
            ("density_error_p999", s => s.densityError999),
            ("density_error_max", s => s.densityErrorMax),
            ("interior_error", s => s.interiorError),
            ("volume_ratio", s => s.volumeRatio),
            ("kinetic_J", s => s.kineticEnergy),
            ("potential_J", s => s.potentialEnergy),
            ("energy_J", s => s.Energy),
            ("speed_rms_m_s", s => s.speed),
            ("speed_max_m_s", s => s.speedMax),
            ("jitter_m_s", s => s.jitter),
            ("front_m", s => s.furthest.x),
            ("neighbors_mean", s => s.neighborsMean),
            ("particles", s => s.particles),
            ("emitted", s => s.emitted),
            ("drained", s => s.drained),
            ("waiting", s => s.waiting),
            ("blocked", s => s.blocked),
            ("refused", s => s.refused),
            ("not_finite", s => s.nonFinite),
            ("escaped", s => s.escaped),
            ("coincident", s => s.coincident),
            ("list_overflow", s => s.neighborOverflow),
        };

        readonly FluidSimulation simulation;
        readonly string prefix;
        int lastStep = -1;

        FluidProbe(FluidSimulation simulation, string prefix)
        {
            this.simulation = simulation;
            this.prefix = prefix;
        }

        /// <summary>One probe for each simulation of the scene; columns carry its name where there are several.</summary>
        public static IEnumerable<IRunProbe> OfScene()
        {
            FluidSimulation[] simulations = Object.FindObjectsOfType<FluidSimulation>();
            return simulations.Select(simulation => new FluidProbe(simulation, simulations.Length > 1 ? simulation.name + "_" : ""));
        }

        public string[] Columns => Measures.Select(measure => prefix + measure.Column).ToArray();

        public void Sample(double time, double[] values)
        {
            Array.Fill(values, double.NaN);
            if (!simulation.TryGetStatistics(out FluidStatistics statistics) || statistics.step == lastStep)
                return;
            lastStep = statistics.step;
            for (int i = 0; i < values.Length; i++)
                values[i] = Measures[i].Value(statistics);
        }

        public Plot[] Plots => new[]
        {
            Plot("density-error", "Density error C+", "max(0, rho / rho0 - 1)", "density_error_mean",
                "density_error_p999") with { Logarithmic = true },
            Plot("volume", "Volume", "twice the mean height x floor / rest volume", "volume_ratio"),
            Plot("energy", "Energy", "J", "energy_J", "kinetic_J", "potential_J"),
            Plot("speed", "Speed", "m/s", "speed_rms_m_s", "speed_max_m_s", "jitter_m_s"),
        };

        public IEnumerable<(string Name, string Value)> Settings
        {
            get
            {
                SolverSettings solver = simulation.Settings;
                FluidMaterial material = simulation.Material;
                UnityEngine.Vector3 size = simulation.DomainSize;
                yield return Row("domain", $"{size.x} x {size.y} x {size.z} m");
                yield return Row("particle spacing", $"{simulation.ParticleSpacing} m");
                yield return Row("solver", $"{solver.substeps} substeps x {solver.iterations} iterations, relaxation " +
                    $"{solver.relaxation}, step {simulation.FixedStep * 1000f:0.##} ms");
                yield return Row("material", $"viscosity {material.dynamicViscosity} Pa s, velocity smoothing " +
                    $"{material.velocitySmoothing}, vorticity {material.vorticity} m/s, artificial pressure " +
                    $"{material.artificialPressure}, tension {material.allowedTension}, shear modulus {material.shearModulus} Pa " +
                    $"relaxing in {material.relaxationTime} s, surface tension {material.surfaceTension} N/m at {material.contactAngle}°");
                if (simulation.TryGetStatistics(out FluidStatistics last))
                    yield return Row("particles", last.particles.ToString("N0", CultureInfo.InvariantCulture));
            }
        }

        (string, string) Row(string name, FormattableString value) => (prefix + name, value.ToString(CultureInfo.InvariantCulture));
        (string, string) Row(string name, string value) => (prefix + name, value);

        Plot Plot(string file, string title, string label, params string[] columns)
        {
            return new Plot(prefix + file, prefix.Length > 0 ? $"{title} ({simulation.name})" : title, label,
                columns.Select(column => prefix + column).ToArray());
        }
    }
}
