using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The shadow of a fluid's water, drawn into shadow maps alone.</summary>
    sealed class WaterShadow : IDisposable
    {
        const int BoxVertices = 36;

        Material material = new Material(StageShader.Load("WaterShadow").Shader) { hideFlags = HideFlags.HideAndDontSave };
        SunPaths sunPaths;      // made when first needed

        public MaterialPropertyBlock Properties { get; } = new MaterialPropertyBlock();

        /// <param name="parameters">Made with <see cref="Properties"/>.</param>
        /// <param name="opacity">How much of the light is gone, 0 to 1.</param>
        /// <param name="isBehind">Whether it falls on nothing that stands in the water.</param>
        /// <param name="sun">Light whose shadow is wanted for sure; null where none is known.</param>
        public void Draw(RenderParams parameters, in MeshFrame mesh, float opacity, bool isBehind, Light sun)
        {
            mesh.SetOn(Properties);
            if (SunPaths.Knows(sun))
                (sunPaths ??= new SunPaths(StageShader.LoadCompute("WaterShadow"))).Update(mesh, -sun.transform.forward, Properties);
            else
                SunPaths.SetNone(Properties);
            Properties.SetFloat(Ids.ShadowIsBehind, isBehind ? 1f : 0f);
            Properties.SetFloat(Ids.ShadowOpacity, opacity);
            parameters.material = material;
            // The depth of the scene must not hold it.
            parameters.shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            parameters.motionVectorMode = MotionVectorGenerationMode.Camera;
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, BoxVertices);
        }

        public void Describe(StageDescription stage)
        {
            stage.Draw("WaterShadow", 0);       // in shadow maps alone
            sunPaths?.Describe(stage);
        }

        public void Dispose()
        {
            sunPaths?.Dispose();
            sunPaths = null;
            EngineObject.Destroy(ref material);
        }

        static class Ids
        {
            public static readonly int ShadowIsBehind = Shader.PropertyToID("_ShadowIsBehind");
            public static readonly int ShadowOpacity = Shader.PropertyToID("_ShadowOpacity");
        }
    }
}
