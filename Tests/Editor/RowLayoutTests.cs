using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>Rows of inspectors clip nothing in narrow views. Laid out, not drawn.</summary>
    public class RowLayoutTests
    {
        // Sizes of an inspector: what its margins and a scroll bar leave, and the editor's own label column.
        const float Margins = 36f, LabelColumn = 120f, Line = 18f, Indent = 15f;

        static readonly float[] ViewWidths = { 300f, 350f, 600f };

        static readonly LetterMeasure Texts = new LetterMeasure();

        static readonly Type[] Components =
        {
            typeof(FluidSimulation), typeof(FluidEmitter), typeof(FluidDrain), typeof(FluidForceField), typeof(FluidProbe),
                typeof(FluidDetector), typeof(FluidVolume), typeof(FluidCollider),
            typeof(ParticleRenderer), typeof(DomainRenderer),
        };

        [Test]
        public void Every_field_of_a_component_has_room_for_its_label_its_value_and_its_unit(
            [ValueSource(nameof(Components))] Type component, [ValueSource(nameof(ViewWidths))] float view)
        {
            using (var scene = new EditorScene())
            {
                var editor = (RillEditor)scene.Inspect(scene.Add(component));
                foreach (InspectorField field in editor.Sections.SelectMany(section => section.Fields))
                {
                    SerializedProperty property = editor.serializedObject.FindProperty(field.Path);
                    string unit = field.Unit(editor.serializedObject);
                    bool isVector = property.propertyType == SerializedPropertyType.Vector3;
                    CheckField(view - Margins, isVector && view <= 330f ? 2f * Line : Line, property.displayName, unit);
                }
            }
        }

        static void CheckField(float width, float valueHeight, string label, string unit)
        {
            string what = $"'{label}' in {unit ?? "no unit"} at {width}";
            FieldRowLayout layout = FieldRowLayout.Of(width, Indent, LabelColumn, Line, valueHeight, label, unit, Texts);
            var row = new Rect(18f, 40f, width, layout.Height);
            Rect field = layout.FieldIn(row), suffix = layout.UnitIn(row), above = layout.LabelIn(row);
            bool ownsLine = valueHeight > Line;
            float labelRoom = layout.IsStacked ? above.width : (ownsLine ? field.width : layout.LabelWidth) - Indent;
            float valueRoom = layout.IsStacked || ownsLine ? field.width - Indent : field.width - layout.LabelWidth;
            Assert.That(labelRoom, Is.GreaterThanOrEqualTo(layout.IsStacked ? Texts.WidestWord(label) : Texts.Width(label)), "label of " + what);
            Assert.That(valueRoom, Is.GreaterThanOrEqualTo(FieldRowLayout.MinValue), "value of " + what);
            Assert.That(suffix.width, Is.GreaterThanOrEqualTo(unit == null ? 0f : Texts.Width(unit)), "unit of " + what);
            Assert.That(suffix.xMin, Is.GreaterThanOrEqualTo(unit == null ? 0f : field.xMax), "the unit stands behind the value of " + what);
            foreach (Rect part in unit == null ? new[] { field } : new[] { field, suffix })
                Assert.That(part.xMin >= row.xMin && part.xMax <= row.xMax + 0.01f && part.yMin >= row.yMin && part.yMax <= row.yMax + 0.01f, what);
            if (layout.IsStacked)
                Assert.That(above.yMax, Is.LessThanOrEqualTo(field.yMin + 0.01f), "the label stands above " + what);
        }

        [Test]
        public void A_short_label_keeps_the_column_a_longer_one_widens_it_and_the_longest_stands_above()
        {
            Assert.That(Field("Size", "m").LabelWidth, Is.EqualTo(LabelColumn));
            FieldRowLayout longer = Field("Boundary Friction Of", "m");
            Assert.That(longer.IsStacked, Is.False);
            Assert.That(longer.LabelWidth, Is.EqualTo(Indent + Texts.Width("Boundary Friction Of") + FieldRowLayout.Gap));
            FieldRowLayout longest = Field("Artificial Pressure Distance", "support radii");
            Assert.That(longest.IsStacked);
            Assert.That(longest.Height, Is.EqualTo(LetterMeasure.Line + Line));
        }

        [Test]
        public void A_unit_takes_its_room_from_the_value()
        {
            var row = new Rect(0f, 0f, 264f, Line);
            Assert.That(Field("Size", null).FieldIn(row).width, Is.EqualTo(264f));
            Assert.That(Field("Size", "kg/m³").FieldIn(row).width, Is.EqualTo(264f - Texts.Width("kg/m³") - FieldRowLayout.Gap));
        }

        static FieldRowLayout Field(string label, string unit) => FieldRowLayout.Of(264f, Indent, LabelColumn, Line, Line, label, unit, Texts);

        static IEnumerable<(string label, string text)> Rows()
        {
            var statistics = new FluidStatistics
            {
                time = 12345.6f, step = 987654, droppedTime = 12.5f, particles = 1000000, added = 1000000, emitted = 123456,
                drained = 234567, nonFinite = 12345, refused = 45678, blocked = 12345,
                waiting = 23456, recycling = 34567, densityError = 0.01234f, densityError999 = 0.1234f, densityErrorMax = 12.34f,
                volumeRatio = 0.999f, speed = 12.34f, speedMax = 123.4f, jitter = 0.123f,
                neighborsMean = 31.4f, neighborOverflow = 12345, substeps = 10, relaxation = 0.35f, relaxationClamped = true,
            };
            foreach ((string label, string text) row in StatisticsSummary.Rows(statistics, 1000000))
                yield return row;
            var budget = new BudgetState
            {
                reason = BudgetReason.MinStable, substeps = 4, iterations = 12, relaxation = 0.35f,
                milliseconds = 12.345f, targetMilliseconds = 2.5f, source = GpuTimeKind.Modeled, densityError = 0.0123f,
                deviceFactor = 1.25f
            };
            foreach ((string label, string text) row in BudgetSummary.Rows(budget))
                yield return row;
        }

        [TestCaseSource(nameof(ViewWidths))]
        public void Statistics_and_the_budget_wrap(float view)
        {
            foreach ((string label, string text) in Rows())
            {
                float width = view - Margins;
                TextRowLayout layout = TextRowLayout.Of(width, Indent, LabelColumn, label, text, Texts);
                var row = new Rect(18f, 40f, width, layout.Height);
                Rect name = layout.LabelIn(row), words = layout.TextIn(row);
                Assert.That(name.width, Is.GreaterThanOrEqualTo(Texts.Width(label)), label);
                Assert.That(words.width, Is.GreaterThanOrEqualTo(Texts.WidestWord(text)), text);
                Assert.That(words.height, Is.EqualTo(Texts.Height(text, words.width)), text);
                Assert.That(words.yMax <= row.yMax && name.yMax <= row.yMax && words.xMax <= row.xMax && name.xMin >= row.xMin, label);
                Assert.That(name.Overlaps(words), Is.False, label);
            }
            if (view == 300f)
                Assert.That(Rows().Count(row => TextRowLayout.Of(view - Margins, Indent, LabelColumn, row.label, row.text, Texts).Height
                    > LetterMeasure.Line), Is.GreaterThan(5), "rows that are longer than a line");
        }

        [Test]
        public void A_text_stands_below_a_label_that_leaves_it_no_room()
        {
            TextRowLayout layout = TextRowLayout.Of(264f, Indent, LabelColumn, "A label of thirty letters, say",
                "and a text that is longer than that", Texts);
            var row = new Rect(0f, 0f, 264f, layout.Height);
            Assert.That(layout.IsStacked);
            Assert.That(layout.TextIn(row).yMin, Is.EqualTo(layout.LabelIn(row).yMax));
            Assert.That(TextRowLayout.Of(264f, Indent, LabelColumn, "A label of twenty-five l.", "short", Texts).IsStacked, Is.False);
        }

        [TestCaseSource(nameof(ViewWidths))]
        public void Charts_have_room_for_every_stage_and_its_figure(float view)
        {
            foreach ((string marker, string label) in StageTimes.Stages)
            {
                float width = view - Margins;
                BarRowLayout layout = BarRowLayout.Of(width, 0f, Line, label, "12.345 ms", Texts);
                var row = new Rect(18f, 40f, width, layout.Height);
                Rect name = layout.LabelIn(row), figure = layout.FigureIn(row);
                Assert.That(name.width, Is.GreaterThanOrEqualTo(Texts.WidestWord(label)), label);
                Assert.That(name.height, Is.GreaterThanOrEqualTo(Texts.Height(label, name.width)), label);
                Assert.That(figure.width, Is.GreaterThanOrEqualTo(Texts.Width("12.345 ms")));
                Assert.That(figure.xMin, Is.GreaterThanOrEqualTo(name.xMax));
                Assert.That(layout.BarIn(row, 0.5f).width, Is.EqualTo(0.5f * width));
                Assert.That(layout.BarIn(row, 2f).xMax, Is.LessThanOrEqualTo(row.xMax));
            }
        }
    }
}
