using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Velocities from the corrected positions and, in the same pass, XSPH; ends a substep.</summary>
    sealed class VelocityUpdate
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Velocity");

        readonly ComputeShader shader = StageShader.LoadCompute("VelocityUpdate");
        readonly int update, updateViscous, updateViscousWithColliders, updateExtrapolated, updateExtrapolatedWithColliders;
        readonly LocalKeyword twoLists, sleep;

        public VelocityUpdate()
        {
            update = shader.FindKernel("UpdateVelocity");
            updateViscous = shader.FindKernel("UpdateVelocityViscous");
            updateViscousWithColliders = shader.FindKernel("UpdateVelocityViscousWithColliders");
            updateExtrapolated = shader.FindKernel("UpdateVelocityExtrapolated");
            updateExtrapolatedWithColliders = shader.FindKernel("UpdateVelocityExtrapolatedWithColliders");
            twoLists = new LocalKeyword(shader, NeighborLists.TwoListsKeyword);
            sleep = new LocalKeyword(shader, RestingRegions.Keyword);
        }

        /// <summary>Whether the pass visits the neighbors: to extrapolate, or for smoothing or the density unless a later stage does both.</summary>
        public static bool VisitsNeighbors(in StepInput input)
        {
            return VelocityExtrapolation.IsNeeded(input) || (input.material.velocitySmoothing > 0f || input.needsDensity) && !VorticityConfinement.IsNeeded(input);
        }

        public void Record(CommandBuffer cmd, GraphicsBuffer constants, ParticleBuffers particles, NeighborLists lists, in StepInput input, RestingRegions resting = null, Colliders colliders = null, VelocityExtrapolation extrapolation = null)
        {
            bool visits = VisitsNeighbors(input);
            int kernel = extrapolation != null ? colliders == null ? updateExtrapolated : updateExtrapolatedWithColliders
                : !visits ? update : colliders == null ? updateViscous : updateViscousWithColliders;
            cmd.BeginSample(Marker);
            lists.RecordKeyword(cmd, shader, twoLists);
            RestingRegions.RecordKeyword(cmd, shader, sleep, resting);
            resting?.Bind(cmd, shader, kernel);
            cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            if (visits)
                lists.Bind(cmd, shader, kernel);
            extrapolation?.Bind(cmd, shader, kernel, input);
            if (visits && colliders != null)
                colliders.BindDensity(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Predicted);
            cmd.SetComputeBufferParam(shader, kernel, Ids.StartPositions, particles.Start);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Velocities, particles.Velocities);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            cmd.SetComputeBufferParam(shader, kernel, Ids.AliveArguments, particles.AliveArguments);
            particles.DispatchSorted(cmd, shader, kernel);
            cmd.EndSample(Marker);
        }

        /// <param name="resting">Null for none.</param>
        /// <param name="colliders">Null for none.</param>
        public StageDescription Describe(in StepInput input, NeighborLists lists, RestingRegions resting, Colliders colliders, VelocityExtrapolation extrapolation)
        {
            bool visits = VisitsNeighbors(input);
            string reason = visits
                ? input.material.velocitySmoothing > 0f ? $"with XSPH: velocity smoothing is {input.material.velocitySmoothing}" : "with neighbors: the density is shown"
                : VorticityConfinement.IsNeeded(input) ? "without XSPH: vorticity confinement does it" : "without XSPH: velocity smoothing is 0";
            var stage = new StageDescription("Velocity update", true, reason);
            string kernel = VelocityExtrapolation.IsNeeded(input) ? "UpdateVelocityExtrapolated" : visits ? "UpdateVelocityViscous" : "UpdateVelocity";
            stage.Kernel("VelocityUpdate", visits && colliders != null ? kernel + "WithColliders" : kernel, input.settings.substeps, RestingRegions.Variant(lists.Variant, resting));
            return stage;
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
            public static readonly int AliveArguments = Shader.PropertyToID("_AliveArguments");
        }
    }
}
