using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Adds up foam, spray and small droplets on a camera's picture of the water, as WaterSpray.compute says.</summary>
    sealed class WaterSpray
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Water.Spray");

        const float UnderWater = 1f;        // d below the surface
        const int Words = 3, FoamWords = 6;

        readonly ComputeShader shader = StageShader.LoadCompute("WaterSpray");
        readonly BufferClear clear = new BufferClear();
        readonly Kernel addFoam, addDroplets, resolveSpray, resolveFoam;

        public WaterSpray()
        {
            addFoam = new Kernel(shader, "AddFoam");
            addDroplets = new Kernel(shader, "AddDroplets");
            resolveSpray = new Kernel(shader, "ResolveSpray");
            resolveFoam = new Kernel(shader, "ResolveFoam");
        }

        /// <summary>Words of a texel that are added up.</summary>
        public static int WordsOf(in MeshFrame mesh) => mesh.HasFoam ? FoamWords : Words;

        /// <summary>Fills the layers of the view, after its faces and the copy of the scene's depth.</summary>
        public void Record(CommandBuffer cmd, in FluidViews camera, in MeshFrame mesh, WaterView view)
        {
            WaterScratch scratch = WaterScratch.Instance;
            cmd.BeginSample(Marker);
            clear.Record(cmd, scratch.SprayAmounts, view.CoarseWindow.Texels * camera.eyes * WordsOf(mesh));
            view.SetConstants(cmd, shader);
            mesh.SetOn(cmd, shader);
            cmd.SetComputeIntParam(shader, Ids.SprayWords, WordsOf(mesh));
            FluidBox box = mesh.Box;
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                cmd.SetComputeIntParam(shader, SurfaceIds.SurfaceEye, eye);
                cmd.SetComputeVectorParam(shader, Ids.SprayRange,
                    new Vector4(FarthestDepth(camera.ViewOf(eye), box), UnderWater * mesh.spacing, 0f, 0f));
                if (mesh.drops != null)
                    AddDroplets(cmd, mesh);
                if (mesh.HasFoam)
                    AddFoam(cmd, mesh.foam);
                Kernel resolve = mesh.HasFoam ? resolveFoam : resolveSpray;
                cmd.SetComputeBufferParam(shader, resolve, Ids.SprayAmounts, scratch.SprayAmounts);
                cmd.SetComputeTextureParam(shader, resolve, WaterView.Ids.Spray, view.Spray);
                if (mesh.HasFoam)
                {
                    cmd.SetComputeTextureParam(shader, resolve, WaterView.Ids.Bubbles, view.Bubbles);
                    SetFaces(cmd, resolve);
                }
                cmd.SetComputeBufferParam(shader, resolve, WaterRays.Ids.TileMarks, scratch.TileMarks);
                SurfaceIds.Dispatch(cmd, shader, resolve, view.CoarseWindow.Width, view.CoarseWindow.Height);
            }
            cmd.EndSample(Marker);
        }

        public void Describe(StageDescription stage, int eyes, bool withFoam)
        {
            clear.Describe(stage, WaterScratch.Instance.SprayAmounts.stride, 1);
            stage.Kernel(addDroplets, eyes);
            if (withFoam)
                stage.Kernel(addFoam, eyes);
            stage.Kernel(withFoam ? resolveFoam : resolveSpray, eyes);
        }

        void AddDroplets(CommandBuffer cmd, in MeshFrame mesh)
        {
            SetPicture(cmd, addDroplets);
            mesh.SetDrops(cmd, shader, addDroplets);
            cmd.DispatchCompute(shader, addDroplets, mesh.arguments, SurfaceMesh.DropletArgumentsAt);
        }

        void AddFoam(CommandBuffer cmd, in FoamFrame foam)
        {
            SetPicture(cmd, addFoam);
            cmd.SetComputeVectorParam(shader, DrawnIds.FoamLook, foam.look);
            SetFaces(cmd, addFoam);
            cmd.SetComputeBufferParam(shader, addFoam, DrawnIds.FoamParticles, foam.particles);
            cmd.SetComputeBufferParam(shader, addFoam, Ids.FoamCounters, foam.counters);
            cmd.DispatchCompute(shader, addFoam, foam.arguments, GpuBuffer.DispatchArgumentsAt);
        }

        // Depth of the fluid's box along the view, or more; m.
        static float FarthestDepth(Matrix4x4 worldToView, in FluidBox box)
        {
            Vector3 center = worldToView.MultiplyPoint3x4(box.DomainToWorld.MultiplyPoint3x4(0.5f * box.Size));
            return Mathf.Max(-center.z, 0f) + 0.5f * box.Spacing * box.Size.magnitude;
        }

        void SetFaces(CommandBuffer cmd, Kernel kernel)
        {
            SetFaceDepth(cmd, kernel);
            cmd.SetComputeTextureParam(shader, kernel, WaterRays.Ids.Faces, WaterScratch.Instance.Faces);
        }

        void SetFaceDepth(CommandBuffer cmd, Kernel kernel)
            => cmd.SetComputeTextureParam(shader, kernel, WaterRays.Ids.FaceDepth, WaterScratch.Instance.FaceDepth, 0, RenderTextureSubElement.Depth);

        void SetPicture(CommandBuffer cmd, Kernel kernel)
        {
            WaterScratch scratch = WaterScratch.Instance;
            SetFaceDepth(cmd, kernel);
            cmd.SetComputeTextureParam(shader, kernel, WaterRays.Ids.SceneCopy, scratch.SceneCopy);
            cmd.SetComputeBufferParam(shader, kernel, Ids.SprayAmounts, scratch.SprayAmounts);
        }

        static class Ids
        {
            public static readonly int SprayAmounts = Shader.PropertyToID("_SprayAmounts");
            public static readonly int SprayWords = Shader.PropertyToID("_SprayWords");
            public static readonly int SprayRange = Shader.PropertyToID("_SprayRange");
            public static readonly int FoamCounters = Shader.PropertyToID("_FoamCounters");
        }
    }
}
