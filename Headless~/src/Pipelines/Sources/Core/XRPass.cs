using UnityEngine.Rendering;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>The eyes that a pass over the frame draws: none where there is no headset, two in one pass here.</summary>
    public class XRPass
    {
        internal Matrix4x4[] views, projections;

        public bool enabled => views != null;
        public int viewCount => views?.Length ?? 0;
        public bool singlePassEnabled => viewCount > 1;
        public int multipassId => 0;

        public Matrix4x4 GetViewMatrix(int viewIndex = 0) => views[viewIndex];
        public Matrix4x4 GetProjMatrix(int viewIndex = 0) => projections[viewIndex];
    }
}
