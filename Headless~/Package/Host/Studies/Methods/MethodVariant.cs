using System;
using Host.Experiments;
using Rill;
using Unity.Mathematics;

namespace Host.Studies.Methods
{
    /// <summary>One point of a study's curve: a method, what it may spend, and the value that the study varies.</summary>
    sealed record MethodVariant
    {
        /// <summary>Of one curve; what the verdicts are on.</summary>
        public string Series { get; init; }
        /// <summary>Position on the curve.</summary>
        public double Value { get; init; }
        /// <summary>The value as text, where the number does not say it.</summary>
        public string Label { get; init; }
        public bool TwoLevel { get; init; }
        public int Substeps { get; init; } = 1;
        public int Iterations { get; init; }
        public float Relaxation { get; init; } = SolverSettings.Default.relaxation;
        public int NeighborCapacity { get; init; } = SolverSettings.Default.neighborCapacity;
        public float Smoothing { get; init; } = FluidMaterial.Water.velocitySmoothing;
        public Func<ConstraintMethod> Method { get; init; } = () => new Jacobi();
        public CoarseVariation Coarse { get; init; } = new();
        /// <summary>Passes over all neighbors in an iteration; Gauss-Seidel does in one what Jacobi does in two.</summary>
        public int PassesPerIteration { get; init; } = 2;

        /// <summary>60 steps a second, water; relaxation not clamped, since what lies beyond is the question.</summary>
        public StepInput Input()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = TwoLevel ? DeepWater.On : DeepWater.Off;
            settings.substeps = Substeps;
            settings.iterations = Iterations;
            settings.relaxation = Relaxation;
            settings.neighborCapacity = NeighborCapacity;
            FluidMaterial material = FluidMaterial.Water;
            material.velocitySmoothing = Smoothing;
            return ExperimentFigures.Input(settings, material);
        }

        /// <summary>Passes over all neighbors in a step: the list, the iterations, the velocities. What a run costs where there is no time.</summary>
        public int Passes => Substeps * (1 + PassesPerIteration * Iterations);
    }

    /// <summary>A question with its curves.</summary>
    /// <param name="Logarithmic">The axis of the values.</param>
    /// <param name="Alike">Figures so near each other that only a linear axis shows their differences.</param>
    sealed record MethodStudy(string Name, string Title, string Axis, MethodVariant[] Variants, bool Logarithmic = false, bool Alike = false);
}
