using System;
using System.Collections.Generic;
using System.Linq;
using Random = Unity.Mathematics.Random;

namespace Rill.Tests
{
    /// <summary>A GPU that steps a million deep particles sixty times a second under a budget: what it truly takes, and the little of it
    /// that is told.</summary>
    sealed class BudgetPlant
    {
        public const float Frame = 1f / 60f;
        public const float Particles = 1e6f;

        /// <summary>Something that chooses a rung from a frame's reading.</summary>
        public delegate int Chooser(in BudgetReading reading, BudgetLadder ladder, float target);

        /// <summary>ms.</summary>
        public float Target = 2f;
        /// <summary>Time of steps over the model's, by fluid time in s.</summary>
        public Func<float, float> Load = _ => 1f;
        /// <summary>Over the model's, by rung: how wrong the model is about each.</summary>
        public Func<int, float> ModelError = _ => 1f;
        /// <summary>C+ by rung and time; NaN for unmeasured.</summary>
        public Func<int, float, float> Error = (rung, time) => float.NaN;
        /// <summary>Measurement that is reported for a true time, by frame; 0 is nothing.</summary>
        public Func<int, float, float> Told = (frame, milliseconds) => milliseconds;
        public int FramesLate = 4;
        public float StepsPerFrame = 1f;
        public float TargetError;
        public GpuTimeKind Source = GpuTimeKind.Measured;
        /// <summary>Whether the newest C+ is told in every frame until the next, as the statistics are.</summary>
        public bool RepeatsError;

        public readonly BudgetLadder Ladder = new BudgetLadder();
        public readonly BudgetController Controller = new BudgetController();
        /// <summary>Rung of each frame.</summary>
        public readonly List<int> Rungs = new List<int>();
        public readonly List<float> Times = new List<float>();
        readonly List<float> stepTimes = new List<float>(), modeled = new List<float>(), changes = new List<float>();
        float newestError = float.NaN;
        public Chooser Choose;

        public BudgetPlant()
        {
            Ladder.Build(true, 0.27f, SolverBudget.Default);
            Choose = (in BudgetReading reading, BudgetLadder ladder, float target) => Controller.Update(reading, ladder, target, TargetError);
        }

        public int Last => Rungs[Rungs.Count - 1];

        public BudgetPlant Run(float seconds)
        {
            int frames = (int)Math.Round(seconds / Frame);
            for (int i = 0; i < frames; i++)
                Advance();
            return this;
        }

        public float TrueStep(int rung, float time) => Ladder.Cost(rung, Particles) * ModelError(rung) * Load(time);

        /// <summary>ms of a frame with a rung.</summary>
        public float TrueTime(int rung, float time) => TrueStep(rung, time) * StepsPerFrame;

        /// <summary>The best rung that truly fits into the target.</summary>
        public int BestFit(float time)
        {
            int best = 0;
            for (int i = 0; i < Ladder.Count; i++)
                if (TrueTime(i, time) <= Target)
                    best = i;
            return best;
        }

        public int Changes(float from, float to) => changes.Count(time => time > from && time <= to);

        /// <summary>Each change and what it led to.</summary>
        public List<(float time, int rung)> ChangesOfRung()
            => changes.Select(time => (time, Rungs[(int)Math.Round(time / Frame)])).ToList();

        /// <summary>Times at which it stepped up to a rung.</summary>
        public List<float> TriesOf(int rung)
            => Enumerable.Range(1, Rungs.Count - 1).Where(i => Rungs[i] == rung && Rungs[i - 1] < rung).Select(i => i * Frame).ToList();

        /// <summary>The detector of oscillation: most changes in any one second after a time.</summary>
        public int MaxChangesInASecond(float from)
        {
            int most = 0;
            foreach (float change in changes)
                if (change > from)
                    most = Math.Max(most, Changes(change - 0.001f, change + 1f));
            return most;
        }

        /// <summary>Largest true time over the target in a window.</summary>
        public float Worst(float from, float to) => Times.Where((_, i) => i * Frame >= from && i * Frame < to).Max() / Target;

        /// <summary>Uniform noise of a fraction on every reading.</summary>
        public static Func<int, float, float> Noise(float fraction, uint seed)
        {
            var random = new Random(seed);
            return (frame, milliseconds) => milliseconds * random.NextFloat(1f - fraction, 1f + fraction);
        }

        void Advance()
        {
            int frame = Rungs.Count, of = frame - FramesLate;
            float time = frame * Frame;
            var reading = new BudgetReading
            {
                seconds = Frame,
                milliseconds = of >= 0 ? Told(frame, stepTimes[of]) : 0f,
                modeled = of >= 0 ? modeled[of] : 0f,
                source = Source,
                stepsPerFrame = StepsPerFrame,
                particles = Particles,
                densityError = MeasureError(frame, time),
            };
            int rung = Choose(reading, Ladder, Target);
            if (frame > 0 && rung != Last)
                changes.Add(time);
            Rungs.Add(rung);
            stepTimes.Add(TrueStep(rung, time));
            modeled.Add(Ladder.Cost(rung, Particles));
            Times.Add(TrueTime(rung, time));
        }

        float MeasureError(int frame, float time)
        {
            float measured = frame > 0 && frame % 10 == 0 ? Error(Last, time) : float.NaN;
            if (!float.IsNaN(measured))
                newestError = measured;
            return RepeatsError ? newestError : measured;
        }
    }
}
