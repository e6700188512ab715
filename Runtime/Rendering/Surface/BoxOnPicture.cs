using UnityEngine;

namespace Rill
{
    /// <summary>Where the box of a fluid lies on a camera's picture and how far it is, for all eyes together.</summary>
    readonly struct BoxOnPicture
    {
        const float MinDepth = 4f;      // d: as near as water is taken to be

        /// <summary>Lowest x and y, highest x and y, -1 to 1; the whole picture where a corner is not in front of the camera.</summary>
        public readonly Vector4 Bounds;

        /// <summary>Along the view, m: of the nearest corner and of the middle of all, at least some particle spacings; 1 without
        /// perspective.</summary>
        public readonly float NearestDepth, MiddleDepth;

        BoxOnPicture(Vector4 bounds, float nearestDepth, float middleDepth)
        {
            Bounds = bounds;
            NearestDepth = nearestDepth;
            MiddleDepth = middleDepth;
        }

        public bool IsSeen => Bounds.x < Bounds.z && Bounds.y < Bounds.w;

        /// <param name="sweep">World, m: the box is taken anywhere along this vector.</param>
        public static BoxOnPicture Of(in FluidViews camera, in SurfaceFrame fluid, Vector3 sweep = default)
        {
            var bounds = new Vector4(1f, 1f, -1f, -1f);
            float nearest = float.MaxValue, sum = 0f;
            bool isWhole = false, isInFront = false;
            Matrix4x4 left = camera.WorldToClipOf(0), right = camera.eyes > 1 ? camera.WorldToClipOf(1) : left;
            int corners = 16 * camera.eyes;      // of the box at both ends of the sweep
            for (int i = 0; i < corners; i++)
            {
                var corner = new Vector4((i & 1) != 0 ? fluid.domainSize.x + 1f : -1f, (i & 2) != 0 ? fluid.domainSize.y + 1f : -1f,
                    (i & 4) != 0 ? fluid.domainSize.z + 1f : -1f, 1f);
                Vector4 world = fluid.domainToWorld * corner;
                if ((i & 8) != 0)
                    world += (Vector4)sweep;
                Vector4 clip = (i < 16 ? left : right) * world;
                nearest = Mathf.Min(nearest, clip.w);
                sum += clip.w;
                isWhole |= clip.w <= 1e-4f;
                isInFront |= clip.w > 0f;
                Vector2 at = new Vector2(clip.x, clip.y) / Mathf.Max(clip.w, 1e-4f);
                bounds = new Vector4(Mathf.Min(bounds.x, at.x), Mathf.Min(bounds.y, at.y), Mathf.Max(bounds.z, at.x), Mathf.Max(bounds.w, at.y));
            }
            if (isWhole)
                bounds = isInFront ? new Vector4(-1f, -1f, 1f, 1f) : Vector4.zero;
            bounds = new Vector4(Mathf.Clamp(bounds.x, -1f, 1f), Mathf.Clamp(bounds.y, -1f, 1f), Mathf.Clamp(bounds.z, -1f, 1f),
                Mathf.Clamp(bounds.w, -1f, 1f));
            bool isOrthographic = camera.projection.m32 == 0f;
            float least = MinDepth * fluid.spacing;
            return new BoxOnPicture(bounds, isOrthographic ? 1f : Mathf.Max(nearest, least), isOrthographic ? 1f : Mathf.Max(sum / corners, least));
        }
    }
}
