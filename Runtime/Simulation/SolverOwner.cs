using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Owns the solver of a fluid and the command buffer of its frames, and keeps the solver while the fluid is disabled.</summary>
    sealed class SolverOwner
    {
        static bool suspendsNothing;

        readonly FluidSimulation fluid;
        PbfSolver suspended;        // solver of a disabled fluid

        public SolverOwner(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Whether a fluid that is disabled gives everything back, whatever its settings say: from before scripts are loaded again until
        /// they are, since no reference to what is suspended would be left.</summary>
        public static bool SuspendsNothing { get => suspendsNothing; set => suspendsNothing = value; }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetSuspendsNothing() => suspendsNothing = false;

        /// <summary>Solver of the fluid; null while it does not run.</summary>
        public PbfSolver Solver { get; private set; }

        public CommandBuffer Commands { get; private set; }

        /// <summary>Whether the solver of the disabled fluid is kept.</summary>
        public bool IsSuspended => suspended != null;

        /// <summary>Whether the solver was made for other settings than the present ones.</summary>
        public bool IsOutdated => Solver != null && !Matches(Solver.Layout);

        /// <summary>Makes the solver.</summary>
        /// <returns>False, and why, where the settings or the device do not allow it.</returns>
        public bool TryMake(out string problem)
        {
            try
            {
                SolverLayout layout = MakeLayout();
                problem = fluid.Support.Begin(layout);
                if (problem != null)
                    return false;
                Solver = new PbfSolver(layout, fluid.Support.Limits);
            }
            catch (Exception refusal) when (refusal is ArgumentException || refusal is InvalidOperationException)
            {
                problem = refusal.Message;
                return false;
            }
            Commands = new CommandBuffer { name = "Rill" };
            return true;
        }

        /// <summary>Replaces the solver by another with the same water.</summary>
        public void Replace(PbfSolver next)
        {
            Solver.Dispose();
            Solver = next;
        }

        /// <summary>Keeps the solver while the fluid is disabled.</summary>
        public void Suspend()
        {
            suspended = Solver;
            Solver = null;
        }

        /// <summary>Takes the solver of a disabled fluid back.</summary>
        /// <returns>Whether there is one.</returns>
        public bool TryResume()
        {
            if (suspended == null)
                return false;
            Solver = suspended;
            suspended = null;
            return true;
        }

        /// <summary>Whether the solver of a disabled fluid was made for other settings than the present ones.</summary>
        public bool SuspendedIsOutdated => suspended != null && !Matches(suspended.Layout);

        public void Dispose()
        {
            Solver?.Dispose();
            Solver = null;
            Commands?.Dispose();
            Commands = null;
        }

        /// <summary>Memory that the buffers will take on the GPU, bytes, without optional stages; 0 where the fluid cannot run.</summary>
        public long EstimatedBytes => TryMakeLayout(out SolverLayout layout, out _) ? layout.EstimatedBytes : 0;

        /// <summary>Why the settings allow no solver; null where they do.</summary>
        public string LayoutProblem
        {
            get
            {
                TryMakeLayout(out _, out string problem);
                return problem;
            }
        }

        /// <exception cref="ArgumentException">The settings allow no solver; the message says why.</exception>
        SolverLayout MakeLayout() => MakeLayout(fluid.ParticleSpacing, fluid.Capacity);

        /// <exception cref="ArgumentException">The settings allow no solver; the message says why.</exception>
        public SolverLayout MakeLayout(float spacing, int capacity)
        {
            SolverSettings settings = fluid.Settings;
            return new SolverLayout(fluid.DomainSize, spacing, capacity, settings.neighborCapacity, settings.listMargin);
        }

        bool TryMakeLayout(out SolverLayout layout, out string problem)
        {
            layout = null;
            problem = null;
            try
            {
                layout = MakeLayout();
            }
            catch (ArgumentException refusal)
            {
                problem = refusal.Message;
            }
            return problem == null;
        }

        bool Matches(SolverLayout layout)
        {
            SolverSettings settings = fluid.Settings;
            return math.all(layout.DomainSize == (float3)fluid.DomainSize / fluid.ParticleSpacing) && layout.Spacing == fluid.ParticleSpacing
                && layout.Capacity == fluid.Capacity && layout.AskedNeighborCapacity == settings.neighborCapacity
                && layout.ListRadius == (float)LatticeKernels.Support * settings.listMargin;
        }
    }
}
