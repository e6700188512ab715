using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The shadow of a fluid's surface: its ellipsoids, drawn into shadow maps alone.</summary>
    sealed class SurfaceShadow : IDisposable
    {
        Material material = new Material(StageShader.Load("SurfaceShadow").Shader) { hideFlags = HideFlags.HideAndDontSave };

        public MaterialPropertyBlock Properties { get; } = new MaterialPropertyBlock();

        /// <param name="parameters">Made with <see cref="Properties"/>.</param>
        /// <param name="opacity">How much of the light is gone, 0 to 1.</param>
        public void Draw(RenderParams parameters, in SurfaceFrame fluid, float opacity)
        {
            fluid.SetOn(Properties);
            Properties.SetFloat(Ids.ShadowOpacity, opacity);
            parameters.material = material;
            // The depth of the scene must not hold it.
            parameters.shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            parameters.motionVectorMode = MotionVectorGenerationMode.Camera;
            Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, fluid.surfaceArguments, 1, StereoInstancing.MonoCommand);
        }

        public void Dispose() => EngineObject.Destroy(ref material);

        static class Ids
        {
            public static readonly int ShadowOpacity = Shader.PropertyToID("_ShadowOpacity");
        }
    }
}
