using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Adds up foam on the picture of a fluid's surface, as SurfaceFoam.compute says.</summary>
    sealed class SurfaceFoam
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Surface.Foam");

        const float UnderWater = 1f;        // d below the surface

        readonly ComputeShader shader = StageShader.LoadCompute("SurfaceFoam");
        readonly BufferClear clear = new BufferClear();
        readonly Kernel addFoam, resolveFoam;

        public SurfaceFoam()
        {
            addFoam = new Kernel(shader, "AddFoam");
            resolveFoam = new Kernel(shader, "ResolveFoam");
        }

        /// <summary>Fills <see cref="SurfaceView.Foam"/> of each eye, after the surface's depth and the distance of the scene.</summary>
        public void Record(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view)
        {
            SurfaceScratch scratch = SurfaceScratch.Shared;
            cmd.BeginSample(Marker);
            clear.Record(cmd, scratch.FoamAmounts, view.FoamWindow.Texels * camera.eyes);
            view.SetConstants(cmd, shader);
            fluid.SetOn(cmd, shader);
            cmd.SetComputeVectorParam(shader, Ids.FoamLook, fluid.foam.look);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                cmd.SetComputeIntParam(shader, SurfaceIds.SurfaceEye, eye);
                cmd.SetComputeVectorParam(shader, Ids.FoamRange,
                    new Vector4(FarthestDepth(camera.ViewOf(eye), fluid), UnderWater * fluid.spacing, 0f, 0f));
                cmd.SetComputeTextureParam(shader, addFoam, Ids.SceneDistance, scratch.SceneDistance);
                cmd.SetComputeTextureParam(shader, addFoam, SurfaceIds.Depth, view.Smoothed);
                cmd.SetComputeBufferParam(shader, addFoam, Ids.FoamParticles, fluid.foam.particles);
                cmd.SetComputeBufferParam(shader, addFoam, Ids.FoamCounters, fluid.foam.counters);
                cmd.SetComputeBufferParam(shader, addFoam, Ids.FoamAmounts, scratch.FoamAmounts);
                cmd.DispatchCompute(shader, addFoam, fluid.foam.arguments, GpuBuffer.DispatchArgumentsAt);
                cmd.SetComputeBufferParam(shader, resolveFoam, Ids.FoamAmounts, scratch.FoamAmounts);
                cmd.SetComputeTextureParam(shader, resolveFoam, Ids.Foam, view.Foam);
                SurfaceIds.Dispatch(cmd, shader, resolveFoam, view.FoamWindow.Width, view.FoamWindow.Height);
            }
            cmd.EndSample(Marker);
        }

        public void Describe(StageDescription stage, int eyes)
        {
            clear.Describe(stage, SurfaceScratch.Shared.FoamAmounts.stride, 1);
            stage.Kernel(addFoam, eyes);
            stage.Kernel(resolveFoam, eyes);
        }

        // Of the fluid's box along the view, or more; m.
        public static float FarthestDepth(Matrix4x4 worldToView, in SurfaceFrame fluid)
        {
            Vector3 middle = worldToView.MultiplyPoint3x4(fluid.domainToWorld.MultiplyPoint3x4(0.5f * fluid.domainSize));
            return Mathf.Max(-middle.z, 0f) + 0.5f * fluid.spacing * fluid.domainSize.magnitude;
        }

        static class Ids
        {
            public static readonly int FoamRange = Shader.PropertyToID("_FoamRange");
            public static readonly int FoamLook = Shader.PropertyToID("_FoamLook");
            public static readonly int FoamParticles = Shader.PropertyToID("_FoamParticles");
            public static readonly int FoamCounters = Shader.PropertyToID("_FoamCounters");
            public static readonly int FoamAmounts = Shader.PropertyToID("_FoamAmounts");
            public static readonly int Foam = Shader.PropertyToID("_Foam");
            public static readonly int SceneDistance = Shader.PropertyToID("_SceneDistance");
        }
    }
}
