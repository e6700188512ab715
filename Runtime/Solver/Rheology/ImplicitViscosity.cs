using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// The viscosity of a fluid in Pa s, solved implicitly before the prediction (see ImplicitViscosity.compute): the same fluid at
    /// every spacing and time step. Made when first needed.
    /// </summary>
    sealed class ImplicitViscosity : Stage
    {
        /// <summary>Passes at most, however viscous the fluid.</summary>
        public const int MaxPasses = 96;

        /// <summary>Fraction of the first error that the passes leave if they are fewer than <see cref="MaxPasses"/>.</summary>
        public const double Tolerance = 0.004;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.ImplicitViscosity");

        readonly ComputeShader shader = StageShader.LoadCompute("ImplicitViscosity");
        readonly Kernel applyProjection, findResidual, firstPass, nextPass;
        readonly KernelVariants findCoefficients;     // with colliders
        readonly StepKeywords keywords;
        GraphicsBuffer solution, nextSolution;

        public ImplicitViscosity(int capacity)
        {
            applyProjection = new Kernel(shader, "ApplyProjection");
            findCoefficients = new KernelVariants(shader, "FindCoefficients", "FindCoefficientsWithColliders");
            findResidual = new Kernel(shader, "FindResidual");
            firstPass = new Kernel(shader, "FirstPass");
            nextPass = new Kernel(shader, "NextPass");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true, weighs: true);
            solution = Buffers.Structured<float4>("Rill.ViscousVelocities", capacity, "_Solution");
            nextSolution = Buffers.Structured<float4>("Rill.NextViscousVelocities", capacity, "_NextSolution");
            Buffers.Structured<float4>("Rill.ViscousChanges", capacity, "_Changes");
            Buffers.Structured<float4>("Rill.ViscousHolds", 2L * capacity, "_Holds");
        }

        public override bool Survives(ParticleChange change) => change == ParticleChange.Shifted;

        public static bool IsNeeded(in StepInput input) => input.phases.MaxViscosity(input.material) > 0f;

        /// <summary>ν Δt / d² of a substep, of the phase with the largest; less where velocities are extrapolated, as of all that
        /// lasts.</summary>
        public static double Strength(in StepInput input, SolverLayout layout)
        {
            return Scaled(input.phases.MaxKinematicViscosity(input.material), input, layout);
        }

        // The largest viscosity in the heaviest phase: what kernels weigh by the viscosities and masses of a pair.
        static double StrengthOfHeaviest(in StepInput input, SolverLayout layout)
            => Scaled(input.phases.MaxViscosity(input.material) / (double)input.phases.Heaviest(input.material), input, layout);

        static double Scaled(double kinematicViscosity, in StepInput input, SolverLayout layout)
            => (double)VelocityExtrapolation.FractionAtOnce(input) * kinematicViscosity
            * ((double)input.timeStep / input.settings.substeps) / ((double)layout.Spacing * layout.Spacing);

        /// <summary>Passes of Chebyshev's iteration that leave <see cref="Tolerance"/> of the error where no particle is braked more than
        /// twice as hard as in the lattice, <see cref="MaxPasses"/> at most.</summary>
        /// <remarks>The error falls to 1 / T_n(θ/δ), with the eigenvalues within θ ± δ.</remarks>
        /// <param name="strength">ν Δt / d².</param>
        public static int PassesFor(double strength)
        {
            double needed = Math.Log(2.0 / Tolerance) / LogPerPass(strength);
            return (int)Math.Min(Math.Ceiling(needed), MaxPasses);
        }

        /// <summary>ν Δt / d² up to which <see cref="MaxPasses"/> leave no more than <see cref="Tolerance"/> of the error: 39.</summary>
        /// <remarks>Where x = (largest + 1) / (largest − 1) of the eigenvalues is cosh(ln(2 / tolerance) / passes).</remarks>
        public static readonly double MaxStrength =
            1.0 / ((Math.Cosh(Math.Log(2.0 / Tolerance) / MaxPasses) - 1.0) * LatticeKernels.ViscosityEigenvalue);

        /// <summary>Fraction of a motion's error that <see cref="MaxPasses"/> leave at most in a substep.</summary>
        /// <param name="strength">ν Δt / d².</param>
        public static double ErrorLeft(double strength) => 1.0 / Math.Cosh(MaxPasses * LogPerPass(strength));

        // arcosh x of T_n(x) = cosh(n arcosh(x)), where no eigenvalue is above twice the lattice's: they are 1.6 to 2 times that at surfaces
        // and in flowing water.
        static double LogPerPass(double strength)
        {
            double largest = 1.0 + 2.0 * strength * LatticeKernels.ViscosityEigenvalue;
            double x = (largest + 1.0) / Math.Max(largest - 1.0, 1e-6);
            return Math.Log(x + Math.Sqrt(x * x - 1.0));
        }

        /// <summary>Records the solve: velocities of the particles that were in the last substep, whose lists there have to be, where they
        /// are now. The coarse grid's projection is added to the velocities of all first.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            if (step.Coarse != null)
            {
                step.Coarse.BindChange(step, shader, applyProjection);
                step.Materials?.Bind(step, shader, applyProjection);
                Dispatch(step, applyProjection);
            }

            double strength = Strength(step.Input, step.Layout);
            double unit = StrengthOfHeaviest(step.Input, step.Layout);
            int coefficients = findCoefficients.For(step.Colliders != null);
            Ids.Lattice.Bind(cmd, shader, coefficients, (float)(0.5 * LatticeKernels.ViscosityScale * unit), (float)LatticeKernels.ViscosityBlend,
                new float4((float)LatticeKernels.ViscositySurface, (float)LatticeKernels.ViscosityDisorder, 0f, 0f),
                (float)(MinFill * LatticeKernels.ViscosityMoment),
                (float)(MinReach * LatticeKernels.ViscosityMoment / LatticeKernels.ViscositySquares));
            Ids.Walls.Bind(cmd, shader, coefficients, step.Input.material.wallFriction,
                (float)(2.0 / LatticeKernels.ViscosityScale * LatticeKernels.ViscosityWallHold),
                new float4((float)LatticeKernels.ViscosityWallMoment, (float)LatticeKernels.ViscosityWallSquares,
                    (float)LatticeKernels.ViscosityWallLean, 0f));

            Bind(step, coefficients);
            step.Colliders?.BindShapes(cmd, shader, coefficients);
            Dispatch(step, coefficients);
            Bind(step, findResidual);
            Dispatch(step, findResidual);

            int passes = PassesFor(strength);
            for (int pass = 0; pass < passes; pass++)
            {
                int kernel = pass == 0 ? firstPass : nextPass;
                Ids.Pass.Bind(cmd, shader, kernel, pass, pass == passes - 1);
                Bind(step, kernel);
                Dispatch(step, kernel);
                if (pass > 0)
                    Buffers.Swap(ref solution, ref nextSolution);
            }
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(ImplicitViscosity stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Implicit viscosity", needed, needed
                ? Invariant($"{step.Input.phases.MaxViscosity(step.Input.material)} Pa s") : "the dynamic viscosity is 0");
            if (!needed || stage == null)
                return description;
            string variant = stage.keywords.Variant(step);
            int substeps = step.Substeps, passes = PassesFor(Strength(step.Input, step.Layout));
            if (step.Coarse != null)
                description.Kernel(stage.applyProjection, substeps, variant);
            description.Kernel(stage.findCoefficients.For(step.Colliders != null), substeps, variant);
            description.Kernel(stage.findResidual, substeps, variant);
            description.Kernel(stage.firstPass, substeps, variant);
            if (passes > 1)
                description.Kernel(stage.nextPass, substeps * (passes - 1), variant);
            stage.Buffers.Describe(description);
            return description;
        }

        // Fractions of the lattice's Σ w r⁴, below which a particle with few neighbors resists less, and of its reach Σ w r⁴ / Σ w r²,
        // which limits how much more than the lattice crowded particles resist.
        const double MinFill = 0.25, MinReach = 0.5;

        void Bind(in StepContext step, int kernel)
        {
            step.BindLists(shader, kernel);
            step.Materials?.Bind(step, shader, kernel);
            Buffers.Bind(step.Commands, shader, kernel);
        }

        void Dispatch(in StepContext step, int kernel)
        {
            CommandBuffer cmd = step.Commands;
            step.Particles.Bind(cmd, shader, kernel);
            cmd.DispatchCompute(shader, kernel, step.Particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
        }

        static class Ids
        {
            public static readonly ShaderParameters Lattice = new ShaderParameters("_Strength", "_Blend", "_Surface", "_MinMoment", "_MinReach");
            public static readonly ShaderParameters Walls = new ShaderParameters("_WallFriction", "_WallHold", "_WallMissing");
            public static readonly ShaderParameters Pass = new ShaderParameters("_Pass", "_IsLast");
        }
    }
}
