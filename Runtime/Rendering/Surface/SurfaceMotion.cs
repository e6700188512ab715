using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Motion vectors of a fluid's surface, drawn over a pipeline's texture of motion: how its water has moved since the frame
    /// before, and the camera.</summary>
    sealed class SurfaceMotion : IDisposable
    {
        const int Vertices = 6;         // of the rectangle around the fluid

        Material material = new Material(StageShader.Load("SurfaceMotion").Shader) { hideFlags = HideFlags.HideAndDontSave };

        /// <summary>Sets what SurfaceMotion.hlsl reads of this camera and frame.</summary>
        public static void Set(WaterView view, in MeshFrame mesh)
        {
            MaterialPropertyBlock block = view.Motion;
            view.SetConstants(block);
            block.SetVector(DrawnIds.FrameLag, mesh.lag);
            block.SetTexture(SurfaceIds.SurfaceDepth, view.Faces);
            block.SetTexture(Ids.SurfaceChords, view.Chords);
            block.SetMatrix(DrawnIds.WorldToDomain, mesh.domainToWorld.inverse);
            block.SetMatrix(DrawnIds.LastDomainToWorld, mesh.lastDomainToWorld);
            block.SetMatrix(Ids.DomainMotion, Difference(mesh.domainToWorld, mesh.lastDomainToWorld));
        }

        /// <summary>Draws into the texture of motion and the depth that are bound, with the pipeline's matrices.</summary>
        public void Record(CommandBuffer cmd, CameraView view) =>
            cmd.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, Vertices, 1, view.Motion);

        /// <summary>Submits the same among the opaque objects, for a pipeline that draws their motion after the water's textures are
        /// filled.</summary>
        /// <param name="parameters">Made with <see cref="CameraView.Motion"/>.</param>
        public void Submit(RenderParams parameters)
        {
            parameters.material = material;
            parameters.shadowCastingMode = ShadowCastingMode.Off;
            parameters.motionVectorMode = MotionVectorGenerationMode.Object;
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, Vertices);
        }

        public void Dispose() => EngineObject.Destroy(ref material);

        static Matrix4x4 Difference(Matrix4x4 a, Matrix4x4 b)
        {
            Matrix4x4 result = default;
            for (int i = 0; i < 4; i++)
                result.SetColumn(i, a.GetColumn(i) - b.GetColumn(i));
            return result;
        }

        static class Ids
        {
            public static readonly int SurfaceChords = Shader.PropertyToID("_SurfaceChords");
            public static readonly int DomainMotion = Shader.PropertyToID("_DomainMotion");
        }
    }
}
