using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Velocities from the corrected positions and, in the same pass, XSPH; ends a substep.</summary>
    sealed class VelocityUpdate
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Velocity");

        readonly ComputeShader shader = StageShader.LoadCompute("VelocityUpdate");
        readonly Kernel update;
        readonly KernelVariants updateWithNeighbors;      // extrapolated, with colliders
        readonly KernelVariants updateDeep;               // with colliders
        readonly StepKeywords keywords;
        readonly bool holdsDeep;        // whether the device holds them

        public VelocityUpdate()
        {
            update = new Kernel(shader, "UpdateVelocity");
            updateWithNeighbors = new KernelVariants(shader, "UpdateVelocityViscous", "UpdateVelocityExtrapolated",
                "UpdateVelocityViscousWithColliders", "UpdateVelocityExtrapolatedWithColliders");
            updateDeep = new KernelVariants(shader, "UpdateVelocityDeep", "UpdateVelocityDeepWithColliders");
            holdsDeep = DeviceLimits.Current.Holds("VelocityUpdate", "UpdateVelocityDeep");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true, weighs: true);
        }

        /// <summary>Whether the pass visits the neighbors: to extrapolate, for slips, or for smoothing or the density
        /// unless a later stage does both.</summary>
        static bool VisitsNeighbors(in StepContext step) => step.Extrapolation != null || step.Materials != null
            || (step.Input.material.velocitySmoothing > 0f || step.Input.needsDensity) && !step.SmoothsLater;

        /// <summary>Whether particles deep in the water are left out of the smoothing: the blend to the coarse flow has calmed them as much
        /// as water's own smoothing would. Who shows densities or asks for more smoothing gets it everywhere.</summary>
        bool LeavesOutDeep(in StepContext step) => holdsDeep && VisitsNeighbors(step) && step.Coarse?.DeepFlow != null
            && step.Extrapolation == null && !step.Input.needsDensity
            && step.Input.material.velocitySmoothing <= FluidMaterial.Water.velocitySmoothing;

        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            bool visits = VisitsNeighbors(step);
            int kernel = KernelFor(step);
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindAsleep(shader, kernel);
            step.BindConstants(shader);
            if (visits)
                step.Lists.Bind(cmd, shader, kernel);
            cmd.SetComputeFloatParam(shader, Ids.SmoothingHere, step.SmoothsLater ? 0f : SolverConstants.Smoothing(step.Input));
            step.Materials?.Bind(step, shader, kernel);
            step.Extrapolation?.Bind(step, shader, kernel);
            if (visits && step.Colliders != null)
                step.Colliders.Bind(cmd, shader, kernel);
            if (LeavesOutDeep(step))
            {
                step.BindCoarseConstants(shader);
                cmd.SetComputeBufferParam(shader, kernel, CoarseIds.DeepFlow, step.Coarse.DeepFlow);
            }
            particles.Bind(cmd, shader, kernel);
            ParticleIds.Motion.Bind(cmd, shader, kernel, particles.Predicted, step.NewVelocities);
            particles.DispatchSorted(cmd, shader, kernel);
            cmd.EndSample(Marker);
        }

        public StageDescription Describe(in StepContext step)
        {
            FluidMaterial material = step.Input.material;
            string reason = VisitsNeighbors(step)
                ? material.velocitySmoothing > 0f ? Invariant($"with XSPH: velocity smoothing is {material.velocitySmoothing}")
                    + (LeavesOutDeep(step) ? "; in deep water the coarse flow smooths" : "")
                    : step.Materials != null ? "with neighbors: there are several materials" : "with neighbors: the density is shown"
                : step.SmoothsLater ? "without XSPH: vorticity confinement does it" : "without XSPH: velocity smoothing is 0";
            var stage = new StageDescription("Velocity update", true, reason);
            stage.Kernel(KernelFor(step), step.Substeps, keywords.Variant(step));
            return stage;
        }

        Kernel KernelFor(in StepContext step) => LeavesOutDeep(step) ? updateDeep.For(step.Colliders != null) : VisitsNeighbors(step)
            ? updateWithNeighbors.For(step.Extrapolation != null, step.Colliders != null) : update;

        static class Ids
        {
            public static readonly int SmoothingHere = Shader.PropertyToID("_SmoothingHere");
        }
    }
}
