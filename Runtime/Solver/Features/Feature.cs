using System;

namespace Rill
{
    /// <summary>Part of a fluid that it can do without: its name, its shaders, what asks for it and how it is turned off.</summary>
    /// <remarks>Beside its own class, setting and shader it is named by its row in <see cref="Features"/> and, where it is a stage of the step, in
    /// PbfSolver.Step.cs.</remarks>
    sealed class Feature
    {
        /// <summary>Whether a step asks for it.</summary>
        public delegate bool Asking(PbfSolver solver, in StepInput step);

        /// <summary>Takes it out of a step.</summary>
        public delegate void TurningOff(ref StepInput step);

        /// <summary>Makes the stage of the solver that does it.</summary>
        public delegate Stage Making(PbfSolver solver, in StepInput step);

        /// <summary>Name in messages, as in "goes on without vorticity confinement".</summary>
        public readonly string Name;

        /// <summary>Remedy for a device that does not hold it, as in "set vorticity to 0"; null if no device is
        /// asked about it.</summary>
        public readonly string Remedy;

        /// <summary>Assets of Runtime/Stages that it needs.</summary>
        public readonly string[] Stages;

        /// <summary>Compute shaders whose kernels the device must hold for it, without extension.</summary>
        public readonly string[] Kernels;

        /// <summary>Names that a kernel defines, and keywords, by which a kernel of another shader belongs to it.</summary>
        public readonly string[] Defines;

        /// <summary>Whether settings stored with a fluid ask for it: a build with the fluid then contains its shaders.</summary>
        public readonly bool OfSettings;

        readonly Asking asked;
        readonly TurningOff turnOff;
        readonly Making make;

        /// <param name="stages">Null for none.</param>
        /// <param name="kernels">Null for those of the stages.</param>
        /// <param name="defines">Null for none.</param>
        /// <param name="asked">Null where no step asks for it: a component or a call does.</param>
        /// <param name="turnOff">Null where who asks looks whether it is there.</param>
        /// <param name="make">Null where its stage, if it has one, is not made and released with each step's input.</param>
        /// <param name="ofSettings">Whether <paramref name="asked"/> reads nothing but settings and material.</param>
        public Feature(string name, string remedy = null, string[] stages = null, string[] kernels = null, string[] defines = null,
            Asking asked = null, TurningOff turnOff = null, Making make = null,
            bool ofSettings = false)
        {
            Name = name;
            Remedy = remedy;
            Stages = stages ?? Array.Empty<string>();
            Kernels = kernels ?? Stages;
            Defines = defines ?? Array.Empty<string>();
            this.asked = asked;
            this.turnOff = turnOff;
            this.make = make;
            OfSettings = ofSettings;
        }

        /// <summary>Index in <see cref="Features.All"/>.</summary>
        public int Index { get; internal set; }

        public bool IsAsked(PbfSolver solver, in StepInput step) => asked != null && asked(solver, step);

        public void TurnOff(ref StepInput step) => turnOff?.Invoke(ref step);

        /// <summary>Whether its stage is there while a step asks for it, and no longer.</summary>
        public bool FollowsSteps => make != null;

        /// <summary>Returns a new stage for a step that asks for it.</summary>
        public Stage Make(PbfSolver solver, in StepInput step) => make(solver, step);

        /// <summary>Returns the first of its stages whose asset is not loaded; null where all are there.</summary>
        public string FirstMissing()
        {
            foreach (string stage in Stages)
                if (StageShader.Find(stage) == null)
                    return stage;
            return null;
        }

        public override string ToString() => Name;

        public static FeatureSet operator |(Feature a, Feature b) => (FeatureSet)a | b;
    }
}
