using UnityEngine;
using UnityEngine.Rendering.HighDefinition;

namespace Rill.HighDefinition
{
    /// <summary>The hidden custom pass volume of one camera: what HDRP has for passes without a step by hand before it had global ones.</summary>
    sealed class SurfaceVolume : ICameraPart
    {
        readonly GameObject hidden;
        readonly CustomPassVolume volume;

        public Camera Camera { get; }
        public bool IsGone => Camera == null;
        public SurfacePass Pass { get; } = new SurfacePass();

        public SurfaceVolume(Camera camera)
        {
            Camera = camera;
            hidden = new GameObject("Rill.Surface") { hideFlags = HideFlags.HideAndDontSave };
            volume = hidden.AddComponent<CustomPassVolume>();
            volume.injectionPoint = CustomPassInjectionPoint.BeforePreRefraction;
            volume.targetCamera = camera;       // whatever the camera's volume layer mask
            volume.customPasses.Add(Pass);
        }

        /// <summary>Whether HDRP runs the pass; a volume that is off costs the camera nothing.</summary>
        public bool IsOn
        {
            set
            {
                if (volume != null && volume.enabled != value)
                    volume.enabled = value;
            }
        }

        public void Dispose()
        {
            GameObject gone = hidden;
            EngineObject.Destroy(ref gone);
        }
    }
}
