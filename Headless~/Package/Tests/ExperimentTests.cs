using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using Host;
using Host.Bench;
using Host.Commands;
using Host.Experiments;
using Host.Report;
using Host.Studies;
using NUnit.Framework;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>The scenes that figures are measured on.</summary>
    public class ExperimentTests
    {
        [TestCase("dam:100000", 100_000, 0.02f)]
        [TestCase("dam:1000000", 1_000_000, 0.01f)]
        [TestCase("dam:1000000:0.004", 1_000_000, 0.004f)]
        [TestCase("column:120:0.05", 24 * 120 * 24, 0.05f)]
        [TestCase("drop:4", 540_672, 0.0125f)]
        [TestCase("drop:0.5", 24 * 4 * 24 + 8 * 12 * 8, 0.1f)]
        [TestCase("tank:8", 112 * 8 * 112, 0.02f)]
        [TestCase("tank:6:20:0.05", 20 * 6 * 20, 0.05f)]
        [TestCase("dam", 100_000, 0.02f)]
        [TestCase("dam:8", 8, 0.5f)]
        [TestCase("spill:1.5:16:0.05", 16 * 16 * 16, 0.05f)]
        public void A_scene_has_the_particles_that_its_name_says(string text, int particles, float spacing)
        {
            ExperimentScene scene = ExperimentScene.Parse(text);
            Assert.That(scene.Particles, Is.EqualTo(particles));
            Assert.That(scene.Spacing, Is.EqualTo(spacing));
            foreach ((float3 corner, int3 counts, float3 _) in scene.Blocks)
                Assert.That(math.all(corner + counts <= scene.Box), "a block reaches out of the box");
        }

        [Test]
        public void The_mean_of_step_times_counts_what_the_median_hides()
        {
            StepTimes.Spread times = StepTimes.Spread.Of(new List<double> { 1, 3, 1, 1, 3, 1, 1 });
            Assert.That((times.Mean, times.Median, times.Low, times.High, times.Count), Is.EqualTo((11.0 / 7.0, 1.0, 1.0, 3.0, 7)));
        }

        [Test]
        public void Another_kind_of_scene_is_refused_with_what_would_do()
        {
            var error = Assert.Throws<HostException>(() => ExperimentScene.Parse("pond"));
            Assert.That(error.Message, Does.Contain("\"pond\"").And.Contain("dam:<particles>").And.Contain("spill:2:16:0.05"));
        }

        [TestCase("dam:0", "particles is 0; give a whole number from 8 to 16,777,216, as in dam:100000")]
        [TestCase("dam:many", "particles is many; give a whole number from 8 to 16,777,216")]
        [TestCase("dam:20000000", "particles is 20000000; give a whole number from 8 to 16,777,216")]
        [TestCase("dam:NaN", "particles is NaN; give a whole number")]
        [TestCase("dam:", "particles is empty; give a whole number")]
        [TestCase("column:10:0.05:3", "has 3 numbers; give column:<layers>:<spacing in m>, as in column:120:0.05")]
        [TestCase("column:9999", "layers is 9999; give a whole number from 1 to 2,730")]
        [TestCase("column:2.5", "layers is 2.5; give a whole number")]
        [TestCase("column:8:0", "spacing in m is 0; give a number from 0.0001 to 10, as in column:120:0.05")]
        [TestCase("column:8:1e30", "spacing in m is 1e30; give a number from 0.0001 to 10")]
        [TestCase("tank:-1", "layers is -1; give a whole number from 1 to 2,730, as in tank:8:112:0.02")]
        [TestCase("tank:8:1", "side of the floor in spacings is 1; give a whole number from 2 to 8,192")]
        [TestCase("tank:2000:8000", "is 128,000,000,000 particles; a simulation holds 16,777,216. Give smaller numbers")]
        [TestCase("drop:0.3", "scale is 0.3; give a multiple of 0.125, as in drop:4:0.0125")]
        [TestCase("drop:0", "scale is 0; give a number from 0.125 to 51.2")]
        [TestCase("drop:1:0.0001", "spacing in m is 0.0001, too fine for the box")]
        [TestCase("spill:20:16", "layers is 20, more than the cube is tall; give at most 16")]
        [TestCase("spill:0.1:250", "layers is 0.1, for which the floor is more than 8,192 spacings wide; give at least 0.233")]
        public void A_number_out_of_range_is_named_with_its_limits(string text, string problem) =>
            Assert.That(Assert.Throws<HostException>(() => ExperimentScene.Parse(text)).Message, Does.Contain($"\"{text}\"").And.Contain(problem));

        [TestCase("bucket:0:0", "particles across the radius is 0; give a whole number from 6 to 171, as in bucket:24:1")]
        [TestCase("bucket:-3:1", "particles across the radius is -3; give")]
        [TestCase("bucket:1000:1", "particles across the radius is 1000; give")]
        [TestCase("bucket:12", "friction of its wall is missing; give a number from 0 to 1, as in bucket:24:1")]
        [TestCase("bucket:12:rough", "friction of its wall is rough; give")]
        public void A_bucket_that_cannot_be_is_refused(string text, string problem) =>
            Assert.That(Assert.Throws<HostException>(() => MeasureCommand.ParseBucket(text)).Message,
            Does.Contain($"\"{text}\"").And.Contain(problem));

        [TestCase("cup:2:4", "degrees of its path is missing; give a number from 0 to 90, as in cup:2:4:20")]
        [TestCase("cup:2:20:0", "acceleration is 20; give a number from 0.5 to 8")]
        [TestCase("cup:thin:4:0", "thickness of its walls is thin; give")]
        public void A_moving_cup_that_cannot_be_is_refused(string text, string problem) =>
            Assert.That(Assert.Throws<HostException>(() => MeasureCommand.ParseCup(text)).Message,
            Does.Contain($"\"{text}\"").And.Contain(problem));

        [TestCase("slosh:0:20:2", "particles along 1 m is 0; give a whole number from 8 to 1,000, as in slosh:40:20:2")]
        [TestCase("slosh:40:20", "wave in spacings is missing; give a number from 0.01 to 1,000")]
        [TestCase("slosh:40:20:30", "wave in spacings is 30, as high as the water is deep; give less than its 20 layers")]
        [TestCase("vortex:40:8:fast", "speed in m/s is fast; give a number")]
        [TestCase("vortex:2000:1000:1", "is 4,000,000,000 particles; a simulation holds 16,777,216")]
        [TestCase("bucket:12:12:-1", "turning in rad/s is -1; give")]
        [TestCase("bucket:12:12:50", "turning in rad/s is 50, at which the center of the floor falls dry; give at most 11.43")]
        [TestCase("utube:8:24:20", "height in spacings is 20, which leaves the lower leg less than the passage of 8 below; give at most 16")]
        [TestCase("wavemaker:2:1:4", "layers is 2; give a whole number from 4")]
        [TestCase("wavemaker:24:0:4", "kh, wave number times depth, is 0")]
        [TestCase("wavemaker:24:1", "stroke in spacings is missing; give a number from 0.1 to 100")]
        [TestCase("utube:8:24:6:1", "has 4 numbers; give utube:<width in spacings>:<depth in spacings>:<height in spacings>, as in utube:8:24:6")]
        [TestCase("wave:1:1:1", "give slosh:<particles along 1 m>")]
        public void Motion_that_cannot_be_is_refused(string text, string problem) =>
            Assert.That(Assert.Throws<HostException>(() => DampingCommand.Parse(text, 0)).Message, Does.Contain($"\"{text}\"").And.Contain(problem));

        [TestCase("slosh:40:20:2", 0.5, "--seconds 0.5: that is 0.4 swings, and a period is fitted to at least 2; give 2.37 or more")]
        [TestCase("utube:8:24:6", 1.0, "swings, and a period is fitted to at least 2; give")]
        [TestCase("vortex:8:8:1", 0.01, "--seconds 0.01: give 0.1 to 3,600")]
        public void Time_too_short_for_a_figure_is_refused(string text, double seconds, string problem)
        {
            Assert.That(Assert.Throws<HostException>(() => DampingCommand.Parse(text, seconds)).Message, Does.Contain(problem));
            Assert.DoesNotThrow(() => DampingCommand.Parse(text, 0));
            Assert.DoesNotThrow(() => DampingCommand.Parse(text, 6));
        }

        [TestCase("measure", "dam:1000", "--seconds", "0", "rill: --seconds 0: give 0.05 to 3,600.")]
        [TestCase("measure", "bucket:12:1", "--seconds", "1.6", "rill: --seconds 1.6: give 1.7 to 3,600.")]
        [TestCase("measure", "dam:1000", "--every", "0", "rill: --every 0: give 1 to 1,000,000.")]
        [TestCase("measure", "dam:1000", "--seconds", "long", "rill: Cannot parse argument 'long' for option '--seconds'")]
        [TestCase("measure", "bucket:0:0", "--iterations", "0", "rill: measure: iterations 0 is outside 1 to 50; using 1.")]
        [TestCase("damping", "slosh:40:20:2", "--seconds", "-1", "rill: --seconds -1: give 0 to 3,600.")]
        [TestCase("bench", "--particles", "0", "--deep-water=on", "rill: --particles 0: give 8 to 16,777,216.")]
        public void The_commands_refuse_such_an_option(string command, string first, string second, string third, string problem)
        {
            string host = Path.Combine(Path.GetDirectoryName(typeof(Session).Assembly.Location), "Host.dll");
            using Process process = Process.Start(new ProcessStartInfo("dotnet",
                new[] { host, command, first, second, third }) { RedirectStandardError = true });
            string errors = process.StandardError.ReadToEnd();
            process.WaitForExit();
            Assert.That(errors, Does.StartWith(problem));
            Assert.That(process.ExitCode, Is.EqualTo(2));
        }
    }
}
