using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;
using Random = Unity.Mathematics.Random;

namespace Rill.Tests
{
    /// <summary>The controller on a simulated GPU. Costs of the six rungs there, ms at load 1: 0.84, 1.02, 1.21, 1.40, 1.77, 2.14.</summary>
    public class BudgetControllerTests
    {
        const float SettledAfter = 1f;

        [Test]
        public void A_controller_without_hysteresis_fails_the_detector_of_oscillation()
        {
            BudgetPlant plant = Naive();
            plant.Run(10f);
            Assert.That(plant.MaxChangesInASecond(SettledAfter), Is.GreaterThan(10));
        }

        [TestCase(1.2f)]
        [TestCase(1.5f)]
        [TestCase(2f)]
        [TestCase(2.6f)]
        [TestCase(4f)]
        public void Under_a_steady_load_it_settles_within_a_second_and_never_changes_again(float target)
        {
            BudgetPlant plant = new BudgetPlant { Target = target }.Run(20f);
            Assert.That(plant.Worst(SettledAfter, 20f), Is.LessThanOrEqualTo(1.1f));
            Assert.That(plant.Changes(SettledAfter, 20f), Is.Zero);
            Assert.That(plant.TrueTime(Math.Min(plant.Last + 1, plant.Ladder.Count - 1), 20f),
                Is.GreaterThan(0.9f * target).Or.EqualTo(plant.TrueTime(plant.Last, 20f)), "better settings have no room");
        }

        [Test]
        public void With_noise_of_twenty_percent_it_holds_the_target_and_does_not_oscillate([Range(1, 8)] int seed,
            [Values(1.3f, 1.55f, 1.75f, 2.4f)] float target)
        {
            BudgetPlant plant = new BudgetPlant { Target = target, Told = BudgetPlant.Noise(0.2f, (uint)seed * 977) }.Run(60f);
            Assert.That(plant.Worst(SettledAfter, 60f), Is.LessThanOrEqualTo(1.1f));
            Assert.That(plant.MaxChangesInASecond(SettledAfter), Is.LessThanOrEqualTo(1));
            Assert.That(plant.Changes(SettledAfter, 60f), Is.LessThanOrEqualTo(6), "in a minute");
        }

        [Test]
        public void A_load_that_doubles_and_halves_is_followed_within_a_second([Range(1, 8)] int framesLate, [Values(0f, 0.2f)] float noise)
        {
            var plant = new BudgetPlant
            {
                Target = 2.5f, FramesLate = framesLate, Told = BudgetPlant.Noise(noise, 31u + (uint)framesLate),
                Load = time => time < 5f || time >= 10f ? 1f : 2.2f,
            };
            plant.Run(15f);
            Assert.That(plant.Worst(1f, 5f), Is.LessThanOrEqualTo(1.1f));
            Assert.That(plant.Worst(6f, 10f), Is.LessThanOrEqualTo(1.1f), "more than twice the load");
            Assert.That(plant.Rungs[(int)(9.9f / BudgetPlant.Frame)], Is.EqualTo(plant.BestFit(9f)));
            Assert.That(plant.Rungs[(int)(11f / BudgetPlant.Frame)], Is.EqualTo(plant.Rungs[(int)(4.9f / BudgetPlant.Frame)]),
                "the first load again");
            Assert.That(plant.MaxChangesInASecond(6f), Is.LessThanOrEqualTo(1));
        }

        [Test]
        public void Where_the_model_is_wrong_about_better_settings_it_tries_them_once_and_waits([Values(1.15f, 1.25f, 1.4f)] float wrong)
        {
            // 1.40 is expected to fit into 1.64; it takes more.
            var plant = new BudgetPlant { Target = 1.64f, ModelError = rung => rung >= 3 ? wrong : 1f, Told = BudgetPlant.Noise(0.1f, 5) };
            plant.Run(60f);
            Assert.That(plant.Worst(1.5f, 28f), Is.LessThanOrEqualTo(1.1f));
            Assert.That(plant.MaxChangesInASecond(SettledAfter), Is.LessThanOrEqualTo(2), "one try is two changes");
            Assert.That(plant.Changes(SettledAfter, 60f), Is.LessThanOrEqualTo(4));
        }

        // Settings that would fit by the model and take three tenths more. Twenty-five minutes of the controller: the times between tries are 30 s,
        // doubled up to 5 minutes.
        [Test]
        public void Better_settings_that_were_a_mistake_are_tried_again_after_times_that_double_up_to_five_minutes()
        {
            BudgetPlant plant = Mistaken().Run(1500f);
            AssertTries(plant, 30f, 60f, 120f, 240f, 300f, 300f, 300f);
            Assert.That(plant.TriesOf(4), Is.Empty);
        }

        [Test]
        public void A_mistake_long_after_the_last_one_waits_the_first_time_again()
        {
            // From 20 to 60 s no rung fits: 1.21 x 1.25 is within the target, and 1.40 x 1.25 above nine tenths of it.
            BudgetPlant plant = Mistaken();
            plant.Load = time => time > 20f && time < 60f ? 1.25f : 1f;
            plant.Run(200f);
            List<float> tries = plant.TriesOf(3);
            TestContext.Out.WriteLine(string.Join(" ", tries));
            Assert.That(tries.Count, Is.GreaterThanOrEqualTo(4));
            Assert.That(tries[1], Is.EqualTo(60f).Within(2f), "as soon as there is room");
            Assert.That(tries[2] - tries[1], Is.EqualTo(30f).Within(2f));
            Assert.That(tries[3] - tries[2], Is.EqualTo(60f).Within(2f));
        }

        // Steps become cheaper by a tenth: not yet by 8 %.
        [TestCase(0.92f, 30f)]
        [TestCase(0.88f, 10f)]
        public void Cheaper_steps_make_a_mistake_worth_another_try(float load, float again)
        {
            BudgetPlant plant = Mistaken();
            plant.Load = time => time > 10f ? load : 1f;
            plant.Run(40f);
            List<float> tries = plant.TriesOf(3);
            TestContext.Out.WriteLine(string.Join(" ", tries));
            Assert.That(tries[1], Is.EqualTo(again).Within(2f));
        }

        // The load grows right after the step up, and falls again at 12 s. By 19 % it was the model's mistake; by 25 and by 70 % it was the load.
        [TestCase(0.2f, 1.25f, 12f)]
        [TestCase(0.2f, 1.19f, 30f)]
        [TestCase(0.2f, 1.7f, 12f)]
        [TestCase(2f, 1.19f, 30f)]
        [TestCase(3.5f, 1.19f, 12f)]
        public void A_load_that_grows_after_the_step_up_is_no_mistake_where_it_stays_or_comes_late(float after, float load, float again)
        {
            // The step up to 1.40 is at 5.5 s, from 1.21; until then 1.40 takes too much.
            var plant = new BudgetPlant { Target = 1.56f, ModelError = rung => rung == 4 ? 5f : 1f };
            float up = float.PositiveInfinity;
            plant.Load = time =>
            {
                if (time > 5f && plant.Rungs.Count > 0 && plant.Last == 3)
                    up = Math.Min(up, time);
                return time < 5f ? 1.15f : time > up + after && time < 12f ? load : 1f;
            };
            plant.Run(50f);
            List<float> tries = plant.TriesOf(3);
            TestContext.Out.WriteLine($"{up:0.00}; " + string.Join(" ", tries));
            Assert.That(tries.Count, Is.EqualTo(2));
            if (load >= 1.5f)
                Assert.That(plant.Worst(up + after + 0.4f, 12f), Is.LessThanOrEqualTo(1.05f), "down at once, and not back to 1.21 first");
            Assert.That(tries[1] - (again > 20f ? tries[0] + after : 0f), Is.EqualTo(again).Within(2f));
        }

        // A target between what the rungs take: 1.21 and 1.40 at load 1.
        [TestCase(1.04f, 0)]
        [TestCase(1.07f, 1)]
        public void Down_it_goes_only_where_the_target_is_exceeded_by_a_twentieth(float over, int changes)
        {
            var plant = new BudgetPlant { Target = 1.6f };
            plant.Run(10f);
            int settled = plant.Last;
            float fits = plant.TrueTime(settled, 0f);
            plant.Load = time => over * plant.Target / fits;
            plant.Run(20f);
            Assert.That(plant.Changes(10f, 30f), Is.EqualTo(changes));
            Assert.That(plant.Last, Is.EqualTo(settled - changes));
        }

        // 1.40 grows to 97 % of the target: below it, 1.21 is taken.
        [Test]
        public void Down_it_goes_to_what_takes_nineteen_twentieths_of_the_target_or_less()
        {
            var plant = new BudgetPlant { Target = 1.97f };
            plant.Run(10f);
            Assert.That(plant.Last, Is.EqualTo(4));
            plant.Load = _ => 0.97f * plant.Target / plant.Ladder.Cost(3, BudgetPlant.Particles);
            plant.Run(5f);
            Assert.That(plant.Last, Is.EqualTo(2));
            Assert.That(plant.Changes(10f, 15f), Is.EqualTo(1));
        }

        // By the ladder's own scene the rung below has four fifths of the target; here it has more than that.
        [Test]
        public void Savings_that_were_needed_come_again_after_times_that_double_up_to_a_minute()
        {
            var plant = new BudgetPlant { Target = 50f, TargetError = 0.005f, Error = (rung, time) => rung >= 3 ? 0.003f : 0.0051f };
            plant.Controller.Restart(3);
            plant.Run(400f);
            List<(float time, int rung)> changes = plant.ChangesOfRung();
            TestContext.Out.WriteLine(string.Join(" ", changes.Select(change => $"{change.time:0.0}:{change.rung}")));
            float[] waits = { 2f, 4f, 8f, 16f, 32f, 60f, 60f, 60f };
            float last = 0f;
            for (int i = 0; i < waits.Length; i++)
            {
                (float down, float up) = (changes[2 * i].time, changes[2 * i + 1].time);
                Assert.That(changes[2 * i].rung, Is.EqualTo(2), $"saving {i}");
                Assert.That(changes[2 * i + 1].rung, Is.EqualTo(3), $"after saving {i}");
                Assert.That(down - last, Is.InRange(waits[i], waits[i] + 1.5f), $"saving {i}: a second until the mean error is low");
                Assert.That(up - down, Is.EqualTo(2f).Within(0.15f), "what a change does to the error shows after two seconds");
                last = up;
            }
        }

        [Test]
        public void Times_that_are_unknown_nine_times_of_ten_slow_it_and_do_not_mislead_it()
        {
            var random = new Random(3);
            BudgetPlant plant = new BudgetPlant { Target = 1.5f, Told = (frame, ms) => random.NextFloat() < 0.9f ? 0f : ms }.Run(30f);
            Assert.That(plant.Worst(4f, 30f), Is.LessThanOrEqualTo(1.1f));
            Assert.That(plant.MaxChangesInASecond(4f), Is.LessThanOrEqualTo(1));
            Assert.That(plant.Last, Is.EqualTo(plant.BestFit(0f) - 1).Or.EqualTo(plant.BestFit(0f)));
        }

        [Test]
        public void Times_that_stop_coming_leave_the_settings_and_are_told()
        {
            BudgetPlant plant = new BudgetPlant { Target = 1.5f, Told = (frame, ms) => frame < 300 ? ms : 0f }.Run(5f);
            int settled = plant.Last;
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.TimeIsSpent));
            plant.Load = _ => 3f;
            plant.Run(5f);
            Assert.That(plant.Last, Is.EqualTo(settled));
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.TimeUnknown));
            Assert.That(plant.Controller.Milliseconds, Is.Zero);
        }

        [Test]
        public void Without_any_time_it_stays_where_it_began()
        {
            var plant = new BudgetPlant { Told = (frame, ms) => 0f };
            plant.Controller.Restart(2);
            plant.Run(10f);
            Assert.That(plant.Rungs, Is.All.EqualTo(2));
            Assert.That(plant.Controller.Factor, Is.Zero);
        }

        [Test]
        public void Hitches_of_other_work_that_triple_a_frame_or_two_change_nothing()
        {
            BudgetPlant plant = new BudgetPlant { Target = 1.7f, Told = (frame, ms) => frame % 30 < 2 ? 3f * ms : ms }.Run(30f);
            Assert.That(plant.Changes(SettledAfter, 30f), Is.Zero);
            Assert.That(plant.TrueTime(plant.Last, 0f), Is.GreaterThan(0.8f * 1.7f));
        }

        [Test]
        public void A_target_below_the_least_settings_leaves_those_and_is_told()
        {
            BudgetPlant plant = new BudgetPlant { Target = 0.5f }.Run(5f);
            Assert.That(plant.Last, Is.Zero);
            Assert.That(plant.Changes(SettledAfter, 5f), Is.Zero);
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.MinStable));
            Assert.That(plant.Controller.Milliseconds, Is.EqualTo(plant.TrueTime(0, 5f)).Within(2).Percent);
        }

        [Test]
        public void A_target_far_above_takes_the_best_settings_and_is_told()
        {
            BudgetPlant plant = new BudgetPlant { Target = 50f }.Run(5f);
            Assert.That(plant.Last, Is.EqualTo(plant.Ladder.Count - 1));
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.BestFits));
        }

        [Test]
        public void Two_steps_a_frame_get_half_the_time_each()
        {
            BudgetPlant plant = new BudgetPlant { Target = 2.3f, StepsPerFrame = 2f }.Run(5f);
            Assert.That(plant.Worst(SettledAfter, 5f), Is.LessThanOrEqualTo(1.1f));
            Assert.That(plant.Last, Is.EqualTo(plant.BestFit(5f)));
        }

        // Steps that suddenly take four times as long are lowered after half a second: until then the error does not count.
        [Test]
        public void What_takes_longer_than_the_budget_is_told_from_the_next_reading_on_though_the_error_is_within_its_target()
        {
            var plant = new BudgetPlant { Target = 2f, TargetError = 0.005f, Error = (rung, time) => 0.001f };
            plant.Run(10f);
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.ErrorIsReached));
            plant.Load = _ => 8f;
            plant.Run(0.25f);
            Assert.That(plant.Controller.Milliseconds, Is.GreaterThan(2f * 1.2f));
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.OverBudget));
        }

        [Test]
        public void An_error_within_its_target_stops_the_spending_and_one_above_resumes_it()
        {
            // Twice the error of the ladder's scene, then four times.
            var plant = new BudgetPlant { Target = 4f, TargetError = 0.005f };
            plant.Error = (rung, time) => (time < 20f ? 2f : 4f) * plant.Ladder[rung].Error;
            plant.Run(20f);
            Assert.That(plant.Ladder[plant.Last].Error * 2f, Is.LessThanOrEqualTo(0.005f).And.GreaterThan(0.002f), "enough and not more");
            Assert.That(plant.Controller.Reason, Is.EqualTo(BudgetReason.ErrorIsReached));
            int calm = plant.Last;
            plant.Run(20f);
            Assert.That(plant.Last, Is.GreaterThan(calm));
            Assert.That(plant.Ladder[plant.Last].Error * 4f, Is.LessThanOrEqualTo(0.005f));
            Assert.That(plant.MaxChangesInASecond(SettledAfter), Is.LessThanOrEqualTo(1));
        }

        [Test]
        public void An_error_that_no_settings_lower_does_not_make_it_swing([Range(1, 5)] int seed)
        {
            var random = new Random((uint)seed);
            var plant = new BudgetPlant { Target = 4f, TargetError = 0.005f, Told = BudgetPlant.Noise(0.2f, (uint)seed) };
            plant.Error = (rung, time) => random.NextFloat(0.003f, 0.0065f);
            plant.Run(120f);
            Assert.That(plant.MaxChangesInASecond(SettledAfter), Is.LessThanOrEqualTo(1));
            Assert.That(plant.Changes(SettledAfter, 120f), Is.LessThanOrEqualTo(24), "in two minutes");
        }

        [Test]
        public void Whatever_the_load_does_it_changes_at_most_thrice_a_second_and_seldom_exceeds([Range(1, 12)] int seed)
        {
            var random = new Random((uint)seed * 7919);
            float[] loads = new float[64];
            for (int i = 0; i < loads.Length; i++)
                loads[i] = random.NextFloat(0.4f, 2.2f);
            var plant = new BudgetPlant
            {
                Target = random.NextFloat(1f, 4f), Told = BudgetPlant.Noise(0.2f, (uint)seed),
                FramesLate = random.NextInt(1, 6)
            };
            plant.Load = time => loads[(int)(time / 3f) % loads.Length];
            plant.Run(120f);
            Assert.That(plant.MaxChangesInASecond(SettledAfter), Is.LessThanOrEqualTo(3));
            for (int window = 0; window < 40; window++)
            {
                float begin = window * 3f;
                if (plant.TrueTime(0, begin + 1f) <= plant.Target)
                    Assert.That(plant.Worst(begin + 1f, begin + 3f), Is.LessThanOrEqualTo(1.1f),
                        $"load {plant.Load(begin)} from {begin} s, target {plant.Target}");
            }
        }

        [Test]
        public void An_update_allocates_nothing()
        {
            BudgetPlant plant = new BudgetPlant().Run(2f);
            var reading = new BudgetReading
            {
                seconds = BudgetPlant.Frame, milliseconds = 9f, modeled = 1f, source = GpuTimeKind.Measured,
                stepsPerFrame = 1f, particles = 1e6f, densityError = 0.01f
            };
            TestDelegate update = () =>
            {
                for (int i = 0; i < 100; i++)
                    plant.Controller.Update(reading, plant.Ladder, 2f, 0.005f);
            };
            update();
            Assert.That(update, UnityEngine.TestTools.Constraints.Is.Not.AllocatingGCMemory());
        }

        // It fits into 1.64 with 1.40 by the model, and takes three tenths more.
        static BudgetPlant Mistaken()
        {
            var plant = new BudgetPlant { Target = 1.64f, ModelError = rung => rung >= 3 ? 1.3f : 1f };
            plant.Controller.Restart(2);
            return plant;
        }

        static void AssertTries(BudgetPlant plant, params float[] waits)
        {
            List<float> tries = plant.TriesOf(3);
            TestContext.Out.WriteLine(string.Join(" ", tries));
            Assert.That(tries.Count, Is.EqualTo(waits.Length + 1));
            for (int i = 0; i < waits.Length; i++)
                Assert.That(tries[i + 1] - tries[i], Is.EqualTo(waits[i]).Within(2f), $"wait {i}");
        }

        // The first idea: up when time is left, down when it is not.
        static BudgetPlant Naive()
        {
            var plant = new BudgetPlant { Target = 1.5f, Told = BudgetPlant.Noise(0.2f, 11) };
            int rung = 0;
            plant.Choose = (in BudgetReading reading, BudgetLadder ladder, float target) =>
            {
                if (reading.milliseconds > 0f)
                    rung = reading.milliseconds > target ? Math.Max(rung - 1, 0) : Math.Min(rung + 1, ladder.Count - 1);
                return rung;
            };
            return plant;
        }
    }
}
