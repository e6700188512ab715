using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using NUnit.Framework;
using UnityEngine.Profiling;

namespace Rill.Editor.Tests
{
    /// <summary>Statistics that the inspector shows for a running fluid.</summary>
    public class StatisticsViewTests
    {
        [Test]
        public void Counts_of_particles_that_came_went_and_were_left_out_are_told()
        {
            var statistics = new FluidStatistics
            {
                particles = 900, added = 500, emitted = 450, drained = 40, nonFinite = 10, refused = 7,
                blocked = 6, waiting = 5, densityError = 0.0123f, neighborOverflow = 3, neighborOverflowMax = 80
            };
            string all = string.Join("\n", StatisticsSummary.Rows(statistics, 1000).Select(row => $"{row.label}: {row.text}"));
            foreach (string text in new[] { "900 of ", "added 500", "emitted 450", "drained 40", "not finite 10", "refused 7", "no room 6",
                "waiting 5", "mean 1.23 %", "over the list 3" })
                Assert.That(all, Does.Contain(text));
            string warnings = string.Join("\n", StatisticsSummary.Warnings(statistics));
            Assert.That(warnings, Does.Contain("Raise the neighbor capacity").And.Contain("Raise the capacity").And.Contain(
                "Look at what added them"));
            Assert.That(StatisticsSummary.Warnings(new FluidStatistics { particles = 10 }), Is.Empty);
        }

        [Test]
        public void Missing_statistics_say_why()
        {
            Assert.That(StatisticsSummary.WhyNone(0), Does.Contain("interval is 0"));
            Assert.That(StatisticsSummary.WhyNone(10), Does.Contain("yet"));
        }

        [Test]
        public void Stages_that_take_time_have_a_bar_in_the_order_of_the_step()
        {
            using (var times = new StageTimes())
            {
                Assert.That(times.Rows, Is.Empty);
                var readings = new float[StageTimes.Stages.Length];
                times.Add(readings);
                Assert.That(times.Rows, Is.Empty, "a frame of which nothing is known");
                int sort = Array.FindIndex(StageTimes.Stages, s => s.marker == "Rill.Sort"),
                    list = Array.FindIndex(StageTimes.Stages, s => s.marker == "Rill.List");
                readings[sort] = 0.25f;
                readings[list] = 0.5f;
                times.Add(readings);
                Assert.That(times.Rows.Select(row => row.Label), Is.EqualTo(new[] { "Sort", "Neighbor list" }));
                Assert.That(times.Rows.Select(row => row.Fraction), Is.EqualTo(new[] { 0.5f, 1f }));
                Assert.That(times.Total, Is.EqualTo(0.75f).Within(1e-6f));
                readings[list] = 0f;
                for (int i = 0; i < 100; i++)
                    times.Add(readings);
                Assert.That(times.Rows[1].Milliseconds, Is.LessThan(0.05f), "a stage that ended fades");
                Assert.That(times.Rows[0].Milliseconds, Is.EqualTo(0.25f).Within(1e-4f));
            }
        }

        [Test]
        public void Every_marker_of_a_step_is_in_the_chart()
        {
            foreach (Type type in typeof(FluidSimulation).Assembly.GetTypes())
                if (!type.ContainsGenericParameters)
                    RuntimeHelpers.RunClassConstructor(type.TypeHandle);
            var names = new List<string>();
            Sampler.GetNames(names);
            string[] markers = names.Where(name => name.StartsWith("Rill.") && !name.StartsWith("Rill.Steps")
                && !name.StartsWith("Rill.Bake.")).ToArray();
            Assert.That(markers, Is.SubsetOf(StageTimes.Stages.Select(stage => stage.marker)));
            Assert.That(markers.Length, Is.GreaterThan(5));
        }

        [Test]
        public void Buffers_are_listed_by_size_with_their_names()
        {
            var first = new StageDescription("First", true, "");
            first.Buffers.Add(("Rill.Small", 1024));
            var second = new StageDescription("Second", true, "");
            second.Buffers.Add(("Rill.Large", 4096));
            second.Buffers.Add(("Other", 1024));
            var rows = new List<MemoryRows.Row>();
            MemoryRows.List(new List<StageDescription> { first, second }, rows);
            Assert.That(rows.Select(row => row.Label), Is.EqualTo(new[] { "Large", "Other", "Small" }));
            Assert.That(rows.Select(row => row.Fraction), Is.EqualTo(new[] { 1f, 0.25f, 0.25f }));
            Assert.That(MemoryRows.Total(rows), Is.EqualTo(6144));
            MemoryRows.List(new List<StageDescription>(), rows);
            Assert.That(MemoryRows.Total(rows), Is.Zero);
        }
    }
}
