using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Adds up for each ray of a camera how much water it goes through in front of the scene, as SurfaceThickness.compute says.</summary>
    sealed class SurfaceThickness
    {
        static readonly ProfilerMarker SceneMarker = GpuMarker.Create("Rill.Surface.Scene");
        static readonly ProfilerMarker ThicknessMarker = GpuMarker.Create("Rill.Surface.Thickness");
        static readonly ProfilerMarker BlurMarker = GpuMarker.Create("Rill.Surface.Blur");

        const string SceneArrayKeyword = "RILL_SCENE_ARRAY";
        const int ScenePass = 1;                            // of SurfaceRaster.shader
        const int MinDivisor = 2, MaxDivisor = 8;
        const float Hysteresis = 1.25f;
        const float BlurRadius = 2f;                        // two standard deviations, d

        readonly ComputeShader shader = StageShader.LoadCompute("SurfaceThickness");
        readonly BufferClear clear = new BufferClear();
        readonly Kernel addParticles, addPhases, blurThickness, blurPhases;
        readonly LocalKeyword sceneArray;
        readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();

        /// <param name="raster">Shader of the material that <see cref="Record"/> gets.</param>
        public SurfaceThickness(Shader raster)
        {
            addParticles = new Kernel(shader, "AddParticles");
            addPhases = new Kernel(shader, "AddPhases");
            blurThickness = new Kernel(shader, "BlurThickness");
            blurPhases = new Kernel(shader, "BlurPhases");
            sceneArray = new LocalKeyword(raster, SceneArrayKeyword);
        }

        /// <summary>How many times smaller the textures of thickness are: their texels are about as wide as a particle, since the sums are
        /// blurred over two.</summary>
        /// <param name="pixelsPerSpacing">Of a particle in the middle of the fluid, pixels.</param>
        /// <param name="last">Of the frame before, which it keeps to while it is near to what fits; 0 for none.</param>
        public static int DivisorFor(float pixelsPerSpacing, int last) => last == 0 ? DivisorFor(pixelsPerSpacing)
            : Mathf.Clamp(last, DivisorFor(pixelsPerSpacing / Hysteresis), DivisorFor(pixelsPerSpacing * Hysteresis));

        static int DivisorFor(float pixelsPerSpacing)
        {
            int divisor = MinDivisor;
            while (divisor < MaxDivisor && 2 * divisor <= pixelsPerSpacing)
                divisor *= 2;
            return divisor;
        }

        /// <summary>Fills <see cref="SurfaceView.Thickness"/> of each eye.</summary>
        /// <param name="raster">Of SurfaceRaster.shader.</param>
        public void Record(CommandBuffer cmd, Material raster, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view)
        {
            SurfaceScratch scratch = SurfaceScratch.Shared;
            RecordScene(cmd, raster, camera, view);
            int add = fluid.phases.AreShown ? addPhases : addParticles, blur = fluid.phases.AreShown ? blurPhases : blurThickness;

            cmd.BeginSample(ThicknessMarker);
            clear.Record(cmd, scratch.Amounts, view.ThicknessWindow.Texels * camera.eyes * view.Phases);
            cmd.SetComputeFloatParam(shader, Ids.ParticleSpacing, fluid.spacing);
            fluid.SetOn(cmd, shader);
            view.SetConstants(cmd, shader);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                cmd.SetComputeIntParam(shader, SurfaceIds.SurfaceEye, eye);
                cmd.SetComputeTextureParam(shader, add, Ids.SceneDistance, scratch.SceneDistance);
                cmd.SetComputeBufferParam(shader, add, Ids.Amounts, scratch.Amounts);
                cmd.SetComputeBufferParam(shader, add, Ids.Positions, fluid.positions);
                cmd.SetComputeBufferParam(shader, add, Ids.StartPositions, fluid.startPositions);
                cmd.SetComputeBufferParam(shader, add, Ids.Velocities, fluid.velocities);
                cmd.SetComputeBufferParam(shader, add, Ids.Counters, fluid.counters);
                if (fluid.phases.AreShown)
                    cmd.SetComputeBufferParam(shader, add, ParticleTags.Ids.Tags, fluid.phases.Tags);
                cmd.DispatchCompute(shader, add, fluid.particleArguments, GpuBuffer.DispatchArgumentsAt);
            }
            cmd.EndSample(ThicknessMarker);

            cmd.BeginSample(BlurMarker);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                cmd.SetComputeIntParam(shader, SurfaceIds.SurfaceEye, eye);
                cmd.SetComputeFloatParam(shader, Ids.BlurRadius,
                    BlurRadius * fluid.spacing * SurfaceConstants.PixelsPerMeter(camera.ProjectionOf(eye), view.ThicknessWindow.Grid.y));
                cmd.SetComputeBufferParam(shader, blur, Ids.Amounts, scratch.Amounts);
                cmd.SetComputeTextureParam(shader, blur, SurfaceIds.Depth, view.Smoothed);
                cmd.SetComputeTextureParam(shader, blur, Ids.Thickness, view.Thickness);
                SurfaceIds.Dispatch(cmd, shader, blur, view.ThicknessWindow.Width, view.ThicknessWindow.Height);
            }
            cmd.EndSample(BlurMarker);
        }

        public void Describe(StageDescription stage, int eyes, SurfaceView view)
        {
            bool hasPhases = view.Phases > 1;
            stage.Draw("SurfaceRaster", eyes);
            clear.Describe(stage, SurfaceScratch.Shared.Amounts.stride, 1);
            stage.Kernel(hasPhases ? addPhases : addParticles, eyes);
            stage.Kernel(hasPhases ? blurPhases : blurThickness, eyes);
        }

        void RecordScene(CommandBuffer cmd, Material raster, in FluidViews camera, SurfaceView view)
        {
            cmd.BeginSample(SceneMarker);
            cmd.SetKeyword(raster, sceneArray, camera.sceneIsArray);
            view.SetConstants(properties);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                properties.SetInt(SurfaceIds.SurfaceEye, eye);
                cmd.SetRenderTarget(SurfaceScratch.Shared.SceneDistance, 0, CubemapFace.Unknown, eye);
                cmd.ClearRenderTarget(false, true, Color.clear);        // as for the depth: a tiler need not load it
                cmd.SetViewport(new Rect(0f, 0f, view.ThicknessWindow.Width, view.ThicknessWindow.Height));
                cmd.DrawProcedural(Matrix4x4.identity, raster, ScenePass, MeshTopology.Triangles, 3, 1, properties);
            }
            cmd.EndSample(SceneMarker);
        }

        static class Ids
        {
            public static readonly int SceneDistance = Shader.PropertyToID("_SceneDistance");
            public static readonly int Amounts = Shader.PropertyToID("_Amounts");
            public static readonly int Thickness = Shader.PropertyToID("_Thickness");
            public static readonly int BlurRadius = Shader.PropertyToID("_BlurRadius");
            public static readonly int ParticleSpacing = Shader.PropertyToID("_ParticleSpacing");
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
