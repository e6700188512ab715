using System;

namespace Rill
{
    /// <summary>
    /// Climbs a <see cref="BudgetLadder"/> by what steps were seen to cost. Plain arithmetic: no Unity, no clock of its own,
    /// no allocation after construction.
    /// </summary>
    /// <remarks>
    /// Costs of rungs that do not run are the cost model's times the factor by which it is off for the one that does. It goes
    /// down when the mean exceeds the target by 5 %, to what is expected to take 95 % of it; up when better settings are expected
    /// to take less than 90 % of it for half a second. Settings that were left soon after they were reached are not tried
    /// again before steps have become cheaper or a growing time has passed.
    /// </remarks>
    sealed class BudgetController
    {
        const float Over = 1.05f, AimBelow = 0.95f, Room = 0.9f;
        const float DownSeconds = 0.2f, UpSeconds = 0.5f, OverSeconds = 0.5f;
        const float LostSeconds = 1f;
        /// <summary>An up that is undone this soon was a mistake.</summary>
        const float TrialSeconds = 3f;
        const float FirstBlockSeconds = 30f, MaxBlockSeconds = 300f;
        /// <summary>Steps this much cheaper than at the mistake make it worth another try; this much more expensive afterwards excuse it.</summary>
        const float Cheaper = 0.9f, Dearer = 1.2f;
        /// <summary>The model is wrong by less than this; what is more is another load.</summary>
        const float ModelError = 1.5f;
        const float BackSeconds = 0.5f;
        /// <summary>Down for the sake of the error only when this fraction of its target is expected.</summary>
        const float ErrorMargin = 0.8f;
        const float FirstSaveSeconds = 2f, MaxSaveSeconds = 60f;
        const float ErrorGain = 0.3f;
        /// <summary>Time after which the effect of a change on the error shows, s.</summary>
        const float ErrorSeconds = 1f, SavedSeconds = 2f;

        readonly CostFactor factor = new CostFactor();
        float sinceReading, sinceChange, roomFor, overFor, saveFor, saveSeconds, error, lastError;
        float factorBeforeUp, blockedFor, blockSeconds;
        int rungBeforeUp, blockedRung;
        bool isBlockJudged;
        Step lastStep;

        enum Step { None, Up, Down, Back, Save }

        public BudgetController() => Restart(0);

        /// <summary>Index on the ladder.</summary>
        public int Rung { get; private set; }

        /// <summary>How often <see cref="Rung"/> changed since the start.</summary>
        public int Changes { get; private set; }

        public BudgetReason Reason { get; private set; }

        /// <summary>Steps of a frame with the present rung and with the next, ms; 0 while unknown.</summary>
        public float Milliseconds { get; private set; }
        public float NextMilliseconds { get; private set; }

        /// <summary>Time of steps over the model's; 0 while unknown.</summary>
        public float Factor => factor.IsKnown ? factor.Value : 0f;

        /// <summary>Forgets everything.</summary>
        public void Restart(int rung)
        {
            factor.Reset();
            Changes = 0;
            error = lastError = float.NaN;
            saveSeconds = FirstSaveSeconds;
            sinceReading = LostSeconds;
            MoveTo(rung);
        }

        /// <summary>Takes up a rung of another ladder; what is known of the costs stays.</summary>
        public void MoveTo(int rung)
        {
            Rung = rung;
            lastStep = Step.None;
            blockedRung = int.MaxValue;
            blockSeconds = 0f;
            sinceChange = roomFor = overFor = saveFor = 0f;
        }

        /// <summary>Hears of a frame and decides.</summary>
        /// <param name="target">What the steps of a frame may take, ms.</param>
        /// <param name="targetError">C+ that is good enough; 0 for none.</param>
        /// <returns>The rung for the next steps.</returns>
        public int Update(in BudgetReading reading, BudgetLadder ladder, float target, float targetError)
        {
            Collect(reading);
            if (!factor.IsKnown || sinceReading >= LostSeconds)
            {
                Reason = BudgetReason.TimeUnknown;
                Milliseconds = NextMilliseconds = 0f;
                return Rung;
            }
            float scale = factor.Value * reading.stepsPerFrame;
            bool decided = LowerForTime(ladder, reading, scale, target) || Raise(ladder, reading, scale, target, targetError)
                || LowerForError(ladder, targetError, reading.seconds);
            if (decided)
                Changes++;
            Milliseconds = scale * ladder.Cost(Rung, reading.particles);
            NextMilliseconds = Rung + 1 < ladder.Count ? scale * ladder.Cost(Rung + 1, reading.particles) : 0f;
            Reason = Explain(ladder, target, targetError);
            return Rung;
        }

        void Collect(in BudgetReading reading)
        {
            sinceChange += reading.seconds;
            sinceReading += reading.seconds;
            blockedFor += reading.seconds;
            if (reading.milliseconds > 0f && reading.modeled > 0f && reading.source != GpuTimeKind.None)
            {
                factor.Add(reading.milliseconds / reading.modeled, Math.Min(sinceReading, LostSeconds));
                sinceReading = 0f;
            }
            if (reading.densityError != lastError && !float.IsNaN(reading.densityError))
                error = float.IsNaN(error) ? reading.densityError : error + ErrorGain * (reading.densityError - error);
            lastError = reading.densityError;
            if (blockedRung != int.MaxValue)
                JudgeBlock();
        }

        void JudgeBlock()
        {
            bool wasLoad = !isBlockJudged && blockedFor >= BackSeconds && factor.Value > factorBeforeUp * Dearer;
            isBlockJudged |= blockedFor >= BackSeconds;
            if (wasLoad || blockedFor > blockSeconds || isBlockJudged && factor.Value < factorBeforeUp * Cheaper)
                blockedRung = int.MaxValue;
        }

        bool LowerForTime(BudgetLadder ladder, in BudgetReading reading, float scale, float target)
        {
            if (scale * ladder.Cost(Rung, reading.particles) <= target * Over)
            {
                overFor = 0f;
                return false;
            }
            overFor += reading.seconds;
            if (Rung == 0 || sinceChange < (lastStep == Step.Back ? BackSeconds : DownSeconds))
                return false;
            if (lastStep == Step.Up && sinceChange < TrialSeconds && factor.Value < factorBeforeUp * ModelError)
            {
                Block();
                Change(ladder, rungBeforeUp, Step.Back);
                return true;
            }
            int lower = Rung - 1;
            while (lower > 0 && scale * ladder.Cost(lower, reading.particles) > target * AimBelow)
                lower--;
            Change(ladder, lower, Step.Down);
            return true;
        }

        // The rung that is left was a mistake.
        void Block()
        {
            bool again = blockSeconds > 0f && blockedFor < blockSeconds + 2f * TrialSeconds;
            blockSeconds = again ? Math.Min(blockSeconds * 2f, MaxBlockSeconds) : FirstBlockSeconds;
            blockedRung = Rung;
            blockedFor = 0f;
            isBlockJudged = false;
        }

        bool Raise(BudgetLadder ladder, in BudgetReading reading, float scale, float target, float targetError)
        {
            bool judgesError = targetError > 0f && !float.IsNaN(error);
            int higher = Rung;
            if (!judgesError || error > targetError)
                while (higher + 1 < ladder.Count && higher + 1 < blockedRung && scale * ladder.Cost(higher + 1, reading.particles) <= target * Room)
                {
                    higher++;
                    if (judgesError && Expected(ladder, higher) <= targetError * ErrorMargin)
                        break;
                }
            if (higher == Rung)
            {
                roomFor = 0f;
                return false;
            }
            roomFor += reading.seconds;
            float wait = lastStep == Step.Save ? SavedSeconds : lastStep == Step.Up && judgesError ? ErrorSeconds : UpSeconds;
            if (roomFor < UpSeconds || sinceChange < wait)
                return false;
            // The saving was too much: the next one waits longer.
            if (lastStep == Step.Save)
                saveSeconds = Math.Min(saveSeconds * 2f, MaxSaveSeconds);
            factorBeforeUp = factor.Value;
            rungBeforeUp = Rung;
            Change(ladder, higher, Step.Up);
            return true;
        }

        bool LowerForError(BudgetLadder ladder, float targetError, float seconds)
        {
            bool saves = targetError > 0f && !float.IsNaN(error) && Rung > 0 && Expected(ladder, Rung - 1) <= targetError * ErrorMargin;
            saveFor = saves ? saveFor + seconds : 0f;
            if (saveFor < saveSeconds)
                return false;
            Change(ladder, Rung - 1, Step.Save);
            return true;
        }

        BudgetReason Explain(BudgetLadder ladder, float target, float targetError)
        {
            if (Rung == 0 && overFor >= OverSeconds)
                return BudgetReason.MinStable;
            if (Milliseconds > target * Over)
                return BudgetReason.OverBudget;
            if (targetError > 0f && error <= targetError)
                return BudgetReason.ErrorIsReached;
            return Rung == ladder.Count - 1 ? BudgetReason.BestFits : BudgetReason.TimeIsSpent;
        }

        /// <summary>C+ to expect of a rung: what is measured, in the proportion that the rungs have on their own scene.</summary>
        float Expected(BudgetLadder ladder, int rung) => error * ladder[rung].Error / ladder[Rung].Error;

        void Change(BudgetLadder ladder, int rung, Step step)
        {
            error = Expected(ladder, rung);     // until measurements of the new rung say otherwise
            Rung = rung;
            lastStep = step;
            sinceChange = roomFor = overFor = saveFor = 0f;
        }
    }
}
