using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using UnityEngine;

namespace Host.Report.Extremes
{
    /// <summary>Emitters whose settings are not numbers.</summary>
    static class EmitterCases
    {
        const string Subject = "Emitters";
        const float Spacing = 0.05f, Rate = 0.003f;     // m³/s: 24 particles a second

        public static IEnumerable<ExtremeCase> All()
        {
            yield return Bad("rate", "FluidEmitter 'Tap': rate NaN is outside", 2, tap => tap.Rate = float.NaN, tap => tap.Rate = Rate);
            yield return Bad("speed", "FluidEmitter 'Tap': speed NaN is outside", 3, tap => tap.Speed = float.NaN, tap => tap.Speed = 2f);
            yield return Bad("spread", "FluidEmitter 'Tap': spread NaN is outside", 3, tap => tap.Spread = float.NaN, tap => tap.Spread = 0f);
            yield return Bad("transform", "FluidEmitter 'Tap': its transform is not finite", 2,
                tap => tap.transform.parent.parent.localScale = 3e38f * Vector3.one, tap
                => tap.transform.parent.parent.localScale = Vector3.one);
        }

        /// <param name="emittingSeconds">Of the three seconds, in which it lets water in.</param>
        static ExtremeCase Bad(string what, string message, int emittingSeconds, Action<FluidEmitter> spoil, Action<FluidEmitter> fix)
            => new(Subject, $"emitter whose {what} is NaN or infinite in the second of three seconds", (setting, check) =>
        {
            const int capacity = 400;
            FluidEmitter tap = null;
            using var fluid = new ExtremeComponent(20f * Spacing * Vector3.one, Spacing, capacity, new Vector3(20f, 0f, 20f) * Spacing, f =>
            {
                f.Settings = setting.Solver;
                tap = Tap(f);
            });
            fluid.Frames(60).Measure();
            spoil(tap);
            fluid.Frames(30).Measure();
            fluid.Frames(30).Measure();
            fix(tap);
            fluid.Frames(60).Measure();

            FluidStatistics last = fluid.Samples[^1];
            check.That("is logged by the emitter's name", fluid.Said(message), fluid.Messages.Count == 0 ? "no message"
                : string.Join(" ", fluid.Messages).Replace(',', ';'));
            check.Exactly("messages", fluid.Messages.Count, 1);
            double due = emittingSeconds * Rate / Math.Pow(Spacing, 3);
            check.Between("let in", last.emitted, Math.Floor(due) - 1, Math.Ceiling(due) + 1);
            check.Exactly("blocked or refused or waiting", last.blocked + last.refused + last.waiting, 0);
            check.Exactly("let in less alive less culled", last.emitted - last.particles - last.nonFinite, 0);
            check.Exactly("not finite", fluid.Read().Count(p => !Unity.Mathematics.math.all(Unity.Mathematics.math.isfinite(p))), 0);
            return fluid.Counts(last.emitted);
        });

        static FluidEmitter Tap(FluidSimulation fluid)
        {
            // Far off and back: a scale that overflows between leaves no valid pose.
            Transform pipe = Below(fluid.transform, "Pipe", Vector3.zero), bend = Below(pipe, "Bend", 2f * Vector3.up);
            GameObject thing = Below(bend, "Tap", -1.7f * Vector3.up).gameObject;
            thing.transform.localRotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            FluidEmitter tap = thing.AddComponent<FluidEmitter>();
            tap.Rate = Rate;
            tap.Speed = 2f;
            return tap;
        }

        static Transform Below(Transform parent, string name, Vector3 position)
        {
            Transform thing = new GameObject(name).transform;
            thing.SetParent(parent, false);
            thing.localPosition = position;
            return thing;
        }
    }
}
