using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Rill.Universal
{
    /// <summary>
    /// Shows fluid surfaces to cameras that a script draws by UniversalRenderPipeline.RenderSingleCamera, and moves the pass that fills the
    /// textures of <see cref="FluidSurface"/> before other passes of a renderer. Cameras that URP draws itself need no feature: without it the
    /// pass runs just before the transparent draws.
    /// </summary>
    [DisallowMultipleRendererFeature("Rill Fluid Surface")]
    public sealed class FluidSurfaceFeature : ScriptableRendererFeature
    {
        /// <summary>Furthest that the pass can be moved: to just after the copy of the opaque scene.</summary>
        public const int MaxStepsBefore = 49;

        [Tooltip("How many steps of RenderPassEvent before the transparent draws, 0 to 49. Passes of the same step run in the order in " +
            "which they were added.")]
        [Range(0, MaxStepsBefore)]
        [SerializeField] int stepsBefore;

        /// <summary>Steps of <see cref="RenderPassEvent"/> before the transparent draws, 0 to <see cref="MaxStepsBefore"/>; clamped.</summary>
        public int StepsBefore { get => stepsBefore; set => stepsBefore = Mathf.Clamp(value, 0, MaxStepsBefore); }

        /// <inheritdoc/>
        public override void Create() => StepsBefore = stepsBefore;

        /// <inheritdoc/>
        public override void OnCameraPreCull(ScriptableRenderer renderer, in CameraData cameraData) =>
            UniversalSurfaces.Announce(cameraData.camera);

        /// <inheritdoc/>
        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            UniversalSurfaces.EnqueueWetness(renderingData.cameraData.camera);
            SurfacePass pass = UniversalSurfaces.PassOf(renderingData.cameraData.camera);
            if (pass == null)
                return;
            pass.Enqueue();
            pass.MoveBefore(stepsBefore);
        }
    }
}
