using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The shadow of a fluid's surface, of its ellipsoids or of the water that is drawn as a mesh, drawn into shadow maps alone.</summary>
    sealed class SurfaceShadow : IDisposable
    {
        const int BoxVertices = 36;

        Material material, ofMesh;
        SunPaths sunPaths;      // made when first needed

        public MaterialPropertyBlock Properties { get; } = new MaterialPropertyBlock();

        /// <param name="parameters">Made with <see cref="Properties"/>.</param>
        /// <param name="opacity">How much of the light is gone, 0 to 1.</param>
        public void Draw(RenderParams parameters, in SurfaceFrame fluid, float opacity)
        {
            fluid.SetOn(Properties);
            Prepare(ref parameters, ref material, "SurfaceShadow", opacity);
            Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, fluid.surfaceArguments, 1, StereoInstancing.MonoCommand);
        }

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
            Prepare(ref parameters, ref ofMesh, "WaterShadow", opacity);
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, BoxVertices);
        }

        public void Describe(StageDescription stage) => sunPaths?.Describe(stage);

        public void Dispose()
        {
            sunPaths?.Dispose();
            sunPaths = null;
            EngineObject.Destroy(ref material);
            EngineObject.Destroy(ref ofMesh);
        }

        void Prepare(ref RenderParams parameters, ref Material drawn, string stage, float opacity)
        {
            if (drawn == null)
                drawn = new Material(StageShader.Load(stage).Shader) { hideFlags = HideFlags.HideAndDontSave };
            Properties.SetFloat(Ids.ShadowOpacity, opacity);
            parameters.material = drawn;
            // The depth of the scene must not hold it.
            parameters.shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            parameters.motionVectorMode = MotionVectorGenerationMode.Camera;
        }

        static class Ids
        {
            public static readonly int ShadowIsBehind = Shader.PropertyToID("_ShadowIsBehind");
            public static readonly int ShadowOpacity = Shader.PropertyToID("_ShadowOpacity");
        }
    }
}
