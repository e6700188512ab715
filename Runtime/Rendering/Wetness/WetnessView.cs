using UnityEngine;

namespace Rill
{
    /// <summary>State that the draw of wet surfaces needs for one camera.</summary>
    sealed class WetnessView : CameraView
    {
        public readonly MaterialPropertyBlock Properties = new MaterialPropertyBlock();

        public WetnessView(Camera camera) : base(camera, "Rill.Wetness.Constants") => SetConstants(Properties);
    }
}
