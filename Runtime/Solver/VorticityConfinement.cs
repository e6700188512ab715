using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Vorticity confinement (Macklin and Müller 2013, eq. 15-16) with XSPH in its last pass. Made when first needed.</summary>
    sealed class VorticityConfinement : IDisposable
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Vorticity");

        readonly ComputeShader shader = StageShader.LoadCompute("VorticityConfinement");
        readonly int curlKernel, confineKernel, confineBesideKernel;
        readonly LocalKeyword twoLists;
        GraphicsBuffer curl, confined;

        public VorticityConfinement(int capacity)
        {
            curlKernel = shader.FindKernel("Curl");
            confineKernel = shader.FindKernel("Confine");
            confineBesideKernel = shader.FindKernel("ConfineWithColliders");
            twoLists = new LocalKeyword(shader, NeighborLists.TwoListsKeyword);
            curl = GpuBuffer.Structured<float4>("Rill.Curl", capacity);
            confined = GpuBuffer.Structured<float4>("Rill.Confined", capacity);
        }

        /// <summary>float4 [capacity], xyz vorticity, 1/s; w its magnitude.</summary>
        public GraphicsBuffer Curl => curl;

        public static bool IsNeeded(in StepInput input) => input.material.vorticity > 0f;

        /// <summary>Records both passes; the particles' velocity buffer and this stage's output change places.</summary>
        public void Record(CommandBuffer cmd, GraphicsBuffer constants, ParticleBuffers particles, NeighborLists lists, Colliders colliders = null)
        {
            cmd.BeginSample(Marker);
            lists.RecordKeyword(cmd, shader, twoLists);
            cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            Dispatch(cmd, curlKernel, particles, lists);
            int confine = colliders == null ? confineKernel : confineBesideKernel;
            colliders?.BindDensity(cmd, shader, confine);
            cmd.SetComputeBufferParam(shader, confine, Ids.Confined, confined);
            Dispatch(cmd, confine, particles, lists);
            cmd.EndSample(Marker);
            (particles.Velocities, confined) = (confined, particles.Velocities);
        }

        public void Dispose()
        {
            GpuBuffer.Release(ref curl);
            GpuBuffer.Release(ref confined);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(VorticityConfinement stage, in StepInput input, NeighborLists lists, Colliders colliders)
        {
            bool needed = IsNeeded(input);
            var description = new StageDescription("Vorticity confinement", needed, $"vorticity is {input.material.vorticity} m/s");
            if (needed)
            {
                description.Kernel("VorticityConfinement", "Curl", input.settings.substeps, lists.Variant);
                description.Kernel("VorticityConfinement", colliders == null ? "Confine" : "ConfineWithColliders", input.settings.substeps, lists.Variant);
            }
            if (stage != null)
            {
                description.Buffer("Rill.Curl", stage.curl);
                description.Buffer("Rill.Confined", stage.confined);
            }
            return description;
        }

        void Dispatch(CommandBuffer cmd, int kernel, ParticleBuffers particles, NeighborLists lists)
        {
            lists.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, particles.Predicted);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Velocities, particles.Velocities);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Curl, curl);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, particles.Counters);
            cmd.DispatchCompute(shader, kernel, particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int Curl = Shader.PropertyToID("_Curl");
            public static readonly int Confined = Shader.PropertyToID("_Confined");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
