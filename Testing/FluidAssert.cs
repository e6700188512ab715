using System;
using System.Collections;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Testing
{
    /// <summary>
    /// Assertions about a fluid for play-mode tests. Each measures the fluid at once and waits for the GPU, so none
    /// belongs into a game. A failure says what was expected, what was found, and which particles are the cause.
    /// </summary>
    public static class FluidAssert
    {
        /// <summary>Particles that a message names at most.</summary>
        const int MaxNamed = 5;

        /// <summary>Frames of a game at 1,000 Hz beside a fluid at 10 steps a second, and some.</summary>
        const int MaxFramesWithoutStep = 300;

        /// <summary>Fluid time for which water stays calm that has settled, s.</summary>
        const double CalmTime = 0.25;

        /// <summary>Measures the fluid now, and waits for the GPU.</summary>
        /// <exception cref="ArgumentNullException">The fluid is null.</exception>
        /// <exception cref="InvalidOperationException">The fluid does not run, or has taken no step yet.</exception>
        public static FluidStatistics Measure(FluidSimulation fluid)
        {
            if (fluid == null)
                throw new ArgumentNullException(nameof(fluid));
            return fluid.Results.Measurements.MeasureNow();
        }

        /// <summary>
        /// Fails where particles were lost since the last restart: refused by a full capacity, given up by an emitter
        /// without room, removed because their position was not finite, or not accounted for at all.
        /// Removal by a drain or at the end of a lifetime is intended.
        /// </summary>
        /// <remarks>A particle that is gone has no place any more, so the message cannot name those that were lost. It tells their numbers by
        /// cause, and names the emitters that gave some up with the particles that are nearest to them.</remarks>
        /// <exception cref="FluidAssertionException">Some were lost.</exception>
        /// <exception cref="InvalidOperationException">As for <see cref="Measure"/>.</exception>
        public static void NothingLost(FluidSimulation fluid)
        {
            FluidStatistics now = Measure(fluid);
            string why = "";
            if (now.refused > 0)
                why += Invariant($" {now.refused} were refused, since the capacity is {fluid.Capacity}: raise it or add less.");
            if (now.blocked > 0)
                why += Invariant($" {now.blocked} were given up by emitters, which found no room for a second: lower their rate, or let the ") +
                    "water flow off." + NameBlocked(fluid);
            if (now.nonFinite > 0)
                why += Invariant($" {now.nonFinite} were removed, since their position was not finite: look for NaN in what adds or pushes them.");
            int missing = now.added + now.emitted + now.handedIn - now.drained - now.handedOut - now.nonFinite - now.particles;
            if (missing != 0)
                why += Invariant($" {missing} are not accounted for: {now.added} added and {now.emitted} emitted, {now.handedIn} handed in ") +
                    Invariant($"and {now.handedOut} out, {now.drained} drained, {now.nonFinite} not finite, {now.particles} alive.");
            if (why.Length > 0)
                Fail(fluid, now, "particles were lost." + why);
        }

        /// <summary>Fails where particles are more than a tenth of a spacing beyond the box's walls or inside a collider.</summary>
        /// <exception cref="FluidAssertionException">Some are; the message names those that are furthest out.</exception>
        /// <exception cref="InvalidOperationException">As for <see cref="Measure"/>.</exception>
        public static void NothingEscaped(FluidSimulation fluid)
        {
            FluidStatistics now = Measure(fluid);
            if (now.escaped > 0)
                Fail(fluid, now, Invariant($"{now.escaped} of {now.particles} particles are outside the box or inside a collider.")
                    + NameFurthest(fluid, now.escaped));
        }

        /// <summary>
        /// Lets the scene play until the water is calm and stays so for a quarter of a second, for a test that returns IEnumerator:
        /// <c>yield return FluidAssert.Settles(fluid, within: 5f);</c>
        /// </summary>
        /// <param name="within">Fluid time from now on in which it has to become calm, s; above 0.</param>
        /// <param name="volume">How far <see cref="FluidStatistics.volumeRatio"/> may be from 1, at least 0; infinite where the water does
        /// not fill the floor of its box.</param>
        /// <param name="noise">Calm water has no more than this of jitter and of rms speed, m/s; above 0.</param>
        /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
        /// <exception cref="FluidAssertionException">It is not calm in that time, or is not of its rest volume then; the message names the
        /// fastest particles.</exception>
        public static IEnumerator Settles(FluidSimulation fluid, float within, float volume = float.PositiveInfinity, float noise = 0.05f)
        {
            if (fluid == null)
                throw new ArgumentNullException(nameof(fluid));
            if (!(within > 0f))
                throw Limit.OutOfRange(nameof(within), within, "The fluid time to settle in has to be above 0 s.");
            if (!(volume >= 0f))
                throw Limit.OutOfRange(nameof(volume), volume, "The volume's tolerance has to be at least 0.");
            if (!(noise > 0f))
                throw Limit.OutOfRange(nameof(noise), noise, "The noise of calm water has to be above 0 m/s.");
            return Settle(fluid, within, volume, noise);
        }

        /// <summary>Fails where a detector finds less or more water than that in its shape, now.</summary>
        /// <param name="min">Volume at rest that there has to be at least, m³; 0 or more.</param>
        /// <param name="max">Volume that there may be, m³; at least <paramref name="min"/>, infinite for any.</param>
        /// <exception cref="ArgumentNullException">The detector is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">A volume is out of its range.</exception>
        /// <exception cref="InvalidOperationException">The detector measures nothing: it or its fluid is off, or no step was taken.</exception>
        /// <exception cref="FluidAssertionException">The volume is another; the message names the particles that are nearest to the shape's
        /// boundary, in or out.</exception>
        public static void VolumeIn(FluidDetector detector, float min, float max = float.PositiveInfinity)
        {
            if (detector == null)
                throw new ArgumentNullException(nameof(detector));
            if (!(min >= 0f))
                throw Limit.OutOfRange(nameof(min), min, "The least volume has to be at least 0 m³.");
            if (!(max >= min))
                throw Limit.OutOfRange(nameof(max), max, "The largest volume has to be at least the least.");
            detector.Flush();
            if (!detector.TryGetSample(out FluidDetectorSample sample))
                throw new InvalidOperationException($"FluidDetector '{detector.name}' measures nothing. Put it below its fluid, enable both, " +
                    "give it a size above 0, and let the fluid take a step.");
            if (!(sample.volume >= min && sample.volume <= max))
                Fail(detector.Simulation, Measure(detector.Simulation), VolumeProblem(detector, sample, min, max) + NameAtBoundary(detector));
        }

        static string VolumeProblem(FluidDetector detector, in FluidDetectorSample sample, float min, float max)
        {
            string wanted = float.IsInfinity(max) ? Invariant($"at least {min:0.#####}") : Invariant($"{min:0.#####} to {max:0.#####}");
            return Invariant($"detector '{detector.name}' has {sample.volume:0.#####} m³ of water in its shape of ")
                + Invariant($"{detector.ShapeVolume:0.#####} m³, {100f * sample.fill:0.#} % full; {wanted} m³ asked for.");
        }

        /// <summary>Fails where the fluid's steps take more GPU time than that, as its budget measures it. A modeled time does not count.</summary>
        /// <param name="milliseconds">What the steps of a frame may take, ms, above 0.</param>
        /// <exception cref="ArgumentOutOfRangeException">The time is not above 0.</exception>
        /// <exception cref="InvalidOperationException">The budget is off, or nothing was measured: this player or device tells no GPU time
        /// of parts of a frame.</exception>
        /// <exception cref="FluidAssertionException">They take more.</exception>
        public static void CostBelow(FluidSimulation fluid, float milliseconds)
        {
            if (fluid == null)
                throw new ArgumentNullException(nameof(fluid));
            if (!(milliseconds > 0f))
                throw Limit.OutOfRange(nameof(milliseconds), milliseconds, "The time has to be above 0 ms.");
            BudgetState state = fluid.BudgetState;
            if (state.source != GpuTimeKind.Measured || !(state.milliseconds > 0f))
                throw new InvalidOperationException($"The GPU time of FluidSimulation '{fluid.name}' was not measured " +
                    Invariant($"({state}). Switch its budget on, let some frames pass, and run this in the Editor or a development ") +
                    "player on a device with SystemInfo.supportsGpuRecorder.");
            if (state.milliseconds > milliseconds)
                throw new FluidAssertionException(Invariant($"FluidSimulation '{fluid.name}': its steps take {state.milliseconds:0.000} ms a ") +
                    Invariant($"frame, more than {milliseconds:0.000} ms ({state.substeps} substeps x {state.iterations} iterations)."));
        }

        static IEnumerator Settle(FluidSimulation fluid, float within, float volume, float noise)
        {
            double start = fluid.FluidTime;
            int framesWithoutStep = 0;
            FluidStatistics now = default;
            double calmSince = double.PositiveInfinity;
            while (fluid.FluidTime - start < within || !double.IsInfinity(calmSince))
            {
                int step = fluid.StepCount;
                yield return null;
                framesWithoutStep = fluid.StepCount == step ? framesWithoutStep + 1 : 0;
                if (fluid.IsRunning && !fluid.Paused && framesWithoutStep > 0 && framesWithoutStep < MaxFramesWithoutStep)
                    continue;
                now = Measure(fluid);
                if (framesWithoutStep > 0)
                    Fail(fluid, now, "it cannot settle, since time stands still: " + (fluid.Paused ? "it is paused."
                        : Invariant($"{framesWithoutStep} frames without a step. Look at Time.timeScale.")));
                // Water that begins to fall, or turns back, is slow for a moment too.
                bool isCalm = now.jitter <= noise && now.speed <= noise && Math.Abs(now.volumeRatio - 1f) <= volume;
                calmSince = isCalm ? Math.Min(calmSince, fluid.FluidTime) : double.PositiveInfinity;
                if (fluid.FluidTime - calmSince >= CalmTime)
                    yield break;
            }
            string size = float.IsInfinity(volume) ? ""
                : Invariant($", volume {now.volumeRatio:0.000} of its rest volume, {1f - volume:0.000} to {1f + volume:0.000} asked for");
            Fail(fluid, now, Invariant($"it has not settled in {within:0.##} s: jitter {now.jitter:0.000} m/s and rms speed {now.speed:0.000} ") +
                Invariant($"m/s of {noise:0.000}, fastest particle {now.speedMax:0.00} m/s") + size + "."
                + NameFastest(fluid));
        }

        static string NameFurthest(FluidSimulation fluid, int count)
            => Name(" ", Find(fluid, particle => particle.outside > 0f ? -particle.outside : float.NaN, Math.Min(count, MaxNamed)),
                particle => Invariant($"{particle.outside:0.000} m too far"));

        static string NameFastest(FluidSimulation fluid)
            => Name(" The fastest: ", Find(fluid, particle => -math.length(particle.velocity)), particle => Invariant(
                $"{-particle.measure:0.000} m/s by {particle.velocity.x:0.00}, {particle.velocity.y:0.00}, {particle.velocity.z:0.00}"));

        static string NameAtBoundary(FluidDetector detector)
            => Name(" Nearest to its boundary: ",
                Find(detector.Simulation, particle => math.abs(detector.DistanceTo(particle.world))),
                particle => Invariant($"{particle.measure:0.000} m {(detector.DistanceTo(particle.world) < 0f ? "inside" : "outside")}"));

        // Lists what is in the way of emitters that found no room.
        static string NameBlocked(FluidSimulation fluid)
        {
            var named = "";
            foreach (FluidEmitter emitter in fluid.Inputs.Parts.FindBlockedEmitters())
                named += Invariant($" Emitter '{emitter.name}' gave up {emitter.Blocked};") + Name(" nearest to it: ",
                    Find(fluid, particle => math.distance(particle.world, emitter.transform.position)),
                    particle => Invariant($"{particle.measure:0.000} m away"));
            return named;
        }

        static List<FoundParticle> Find(FluidSimulation fluid, Func<FoundParticle, float> measure, int maxCount = MaxNamed)
            => fluid.Results.Measurements.FindParticles(maxCount, measure);

        static string Name(string heading, List<FoundParticle> particles, Func<FoundParticle, string> what)
        {
            if (particles.Count == 0)
                return "";
            var named = new List<string>();
            foreach (FoundParticle particle in particles)
                named.Add(Invariant($"Particle {particle.id} is at {particle.position.x:0.000}, {particle.position.y:0.000}, ") +
                    Invariant($"{particle.position.z:0.000} m in the box's frame, ")
                    + what(particle));
            return heading + string.Join("; ", named) + ".";
        }

        static void Fail(FluidSimulation fluid, in FluidStatistics now, string problem) =>
            throw new FluidAssertionException(Invariant($"FluidSimulation '{fluid.name}', step {now.step} at {now.time:0.000} s: {problem}"));
    }
}
