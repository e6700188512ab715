using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Finds what a camera sees of the mesh of a fluid's surface, and follows the light that it sees through it; see
    /// WaterRays.compute.</summary>
    /// <remarks>Not in the draw that shades: triangles of a few pixels shade most of them several times. Records into the caller's command buffer;
    /// sets no globals.</remarks>
    sealed class WaterRays : IDisposable
    {
        static readonly ProfilerMarker FacesMarker = GpuMarker.Create("Rill.Water.Faces");
        static readonly ProfilerMarker RaysMarker = GpuMarker.Create("Rill.Water.Rays");
        static readonly ProfilerMarker TilesMarker = GpuMarker.Create("Rill.Water.Tiles");

        const int FacePass = 0, CopyPass = 1;       // of WaterFaces.shader
        const string SceneArrayKeyword = "RILL_SCENE_ARRAY";

        readonly ComputeShader shader;
        readonly BufferClear clear = new BufferClear();
        readonly KernelVariants traceRays;      // with phases; with the light of the sun
        readonly Kernel findFaces, storeChords, listTiles;
        readonly LocalKeyword sceneArray;
        readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();
        Material raster;

        public WaterRays()
        {
            StageShader stage = StageShader.Load("WaterRays");
            shader = stage.Compute;
            raster = new Material(stage.Shader) { hideFlags = HideFlags.HideAndDontSave };
            findFaces = new Kernel(shader, "FindFaces");
            traceRays = new KernelVariants(shader, "TraceRays", "TracePhases", "TraceSun", "TraceSunAndPhases");
            storeChords = new Kernel(shader, "StoreChords");
            listTiles = new Kernel(shader, "ListTiles");
            sceneArray = new LocalKeyword(stage.Shader, SceneArrayKeyword);
        }

        /// <summary>Why light cannot be followed on this device; null where it can.</summary>
        public static string DeviceProblem => GpuTexture.WhyNot(RenderTextureFormat.Depth, false)
            ?? GpuTexture.WhyNot(RenderTextureFormat.RFloat, false) ?? GpuTexture.WhyNot(RenderTextureFormat.ARGBHalf, false)
            ?? GpuTexture.WhyNot(RenderTextureFormat.ARGBFloat, true) ?? GpuTexture.WhyNot(RenderTextureFormat.ARGBHalf, true);

        /// <summary>Fills the textures of the view, whose window is placed and whose constants are written.</summary>
        /// <param name="refracts">Else the straight path through the water is found alone.</param>
        public void Record(CommandBuffer cmd, in FluidViews camera, in MeshFrame mesh, WaterView view, bool refracts)
        {
            WaterScratch scratch = WaterScratch.Instance;
            RecordFaces(cmd, camera, mesh, view);
            Kernel trace = traceRays.For(mesh.phases != null, mesh.caustics != null);
            cmd.BeginSample(RaysMarker);
            clear.Record(cmd, scratch.TileMarks, WaterTiles.MarksOf(view.CoarseWindow.Width, view.CoarseWindow.Height));
            view.SetConstants(cmd, shader);
            mesh.SetOn(cmd, shader);
            mesh.SetField(cmd, shader, trace);
            mesh.phases?.SetOn(cmd, shader, trace);
            mesh.caustics?.SetOn(cmd, shader, trace);
            cmd.SetComputeFloatParam(shader, Ids.RaysBend, refracts ? 1f : 0f);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                cmd.SetComputeIntParam(shader, SurfaceIds.SurfaceEye, eye);
                SetFaces(cmd, findFaces);
                cmd.SetComputeBufferParam(shader, findFaces, Ids.TileMarks, scratch.TileMarks);
                cmd.SetComputeTextureParam(shader, findFaces, WaterView.Ids.RayFaces, view.Faces);
                SurfaceIds.Dispatch(cmd, shader, findFaces, view.Window.Width, view.Window.Height);
                cmd.SetComputeTextureParam(shader, trace, Ids.Faces, scratch.Faces);
                cmd.SetComputeTextureParam(shader, trace, Ids.SceneCopy, scratch.SceneCopy);
                cmd.SetComputeTextureParam(shader, trace, WaterView.Ids.RayFaces, view.Faces);
                cmd.SetComputeTextureParam(shader, trace, WaterView.Ids.RayEnds, view.Ends);
                cmd.SetComputeTextureParam(shader, trace, WaterView.Ids.RayDirections, view.Directions);
                cmd.SetComputeTextureParam(shader, trace, WaterView.Ids.RayMirrors, view.Mirrors);
                if (mesh.phases != null)
                    cmd.SetComputeTextureParam(shader, trace, WaterView.Ids.RayPhases, view.Phases);
                if (mesh.caustics != null)
                    cmd.SetComputeTextureParam(shader, trace, WaterView.Ids.RaySun, view.Sun);
                SurfaceIds.Dispatch(cmd, shader, trace, view.CoarseWindow.Width, view.CoarseWindow.Height);
                if (view.Chords == null)
                    continue;
                SetFaces(cmd, storeChords);
                cmd.SetComputeTextureParam(shader, storeChords, WaterView.Ids.RayChords, view.Chords);
                SurfaceIds.Dispatch(cmd, shader, storeChords, view.Window.Width, view.Window.Height);
            }
            cmd.EndSample(RaysMarker);
        }

        /// <summary>Lists the tiles that show something, after all that marks them.</summary>
        public void RecordTiles(CommandBuffer cmd, WaterView view)
        {
            cmd.BeginSample(TilesMarker);
            view.Tiles.RecordStart(cmd, StereoInstancing.IsActive ? 2 : 1);
            cmd.SetComputeBufferParam(shader, listTiles, Ids.TileMarks, WaterScratch.Instance.TileMarks);
            cmd.SetComputeBufferParam(shader, listTiles, WaterView.Ids.WaterTiles, view.Tiles.Tiles);
            cmd.SetComputeBufferParam(shader, listTiles, Ids.TileArguments, view.Tiles.Arguments);
            SurfaceIds.Dispatch(cmd, shader, listTiles, WaterTiles.MarksOf(view.CoarseWindow.Width, view.CoarseWindow.Height), 1);
            cmd.EndSample(TilesMarker);
        }

        public void Describe(StageDescription stage, WaterView view)
        {
            int eyes = view.Faces.volumeDepth;
            clear.Describe(stage, sizeof(uint), 1);
            stage.Draw("WaterFaces", 2 * eyes);
            stage.Kernel(findFaces, eyes);
            stage.Kernel(traceRays.For(view.Phases != null, view.Sun != null), eyes);
            if (view.Chords != null)
                stage.Kernel(storeChords, eyes);
            stage.Kernel(listTiles, 1);
        }

        public void Dispose() => EngineObject.Destroy(ref raster);

        void SetFaces(CommandBuffer cmd, Kernel kernel)
        {
            cmd.SetComputeTextureParam(shader, kernel, Ids.FaceDepth, WaterScratch.Instance.FaceDepth, 0, RenderTextureSubElement.Depth);
            cmd.SetComputeTextureParam(shader, kernel, Ids.Faces, WaterScratch.Instance.Faces);
        }

        void RecordFaces(CommandBuffer cmd, in FluidViews camera, in MeshFrame mesh, WaterView view)
        {
            WaterScratch scratch = WaterScratch.Instance;
            cmd.BeginSample(FacesMarker);
            cmd.SetKeyword(raster, sceneArray, camera.sceneIsArray);
            view.SetConstants(properties);
            mesh.SetOn(properties);
            var window = new Rect(0f, 0f, view.Window.Width, view.Window.Height);
            var picture = new Rect(0f, 0f, view.CoarseWindow.Grid.x, view.CoarseWindow.Grid.y);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                properties.SetInt(SurfaceIds.SurfaceEye, eye);
                cmd.SetRenderTarget(scratch.Faces, scratch.FaceDepth, 0, CubemapFace.Unknown, eye);
                cmd.ClearRenderTarget(true, false, Color.clear);        // the depth says where there are faces
                cmd.SetViewport(window);
                cmd.DrawProceduralIndirect(mesh.indices, Matrix4x4.identity, raster, FacePass, MeshTopology.Triangles, mesh.arguments,
                    0, properties);
                cmd.SetRenderTarget(new RenderTargetIdentifier(scratch.SceneCopy, 0, CubemapFace.Unknown, eye), RenderBufferLoadAction.DontCare,
                    RenderBufferStoreAction.Store);
                cmd.SetViewport(picture);
                cmd.DrawProcedural(Matrix4x4.identity, raster, CopyPass, MeshTopology.Triangles, 3, 1, properties);
            }
            cmd.EndSample(FacesMarker);
        }

        /// <summary>Properties of WaterRays.compute and WaterSpray.compute.</summary>
        public static class Ids
        {
            public static readonly int FaceDepth = Shader.PropertyToID("_FaceDepth");
            public static readonly int Faces = Shader.PropertyToID("_Faces");
            public static readonly int SceneCopy = Shader.PropertyToID("_SceneCopy");
            public static readonly int TileMarks = Shader.PropertyToID("_TileMarks");
            public static readonly int TileArguments = Shader.PropertyToID("_TileArguments");
            public static readonly int RaysBend = Shader.PropertyToID("_RaysBend");
        }
    }
}
