using UnityEngine;

namespace Rill
{
    /// <summary>Rectangle of a fluid's box on a camera's picture, for all eyes together.</summary>
    readonly struct BoxOnPicture
    {
        /// <summary>Lowest x and y, highest x and y, -1 to 1; the whole picture where a corner is not in front of the camera.</summary>
        public readonly Vector4 Bounds;

        BoxOnPicture(Vector4 bounds) => Bounds = bounds;

        public bool IsSeen => Bounds.x < Bounds.z && Bounds.y < Bounds.w;

        /// <param name="sweep">World, m: the box is taken anywhere along this vector.</param>
        public static BoxOnPicture Of(in FluidViews camera, in FluidBox box, Vector3 sweep = default)
        {
            var bounds = new Vector4(1f, 1f, -1f, -1f);
            bool isWhole = false, isInFront = false;
            Matrix4x4 left = camera.WorldToClipOf(0), right = camera.eyes > 1 ? camera.WorldToClipOf(1) : left;
            int corners = 16 * camera.eyes;      // of the box at both ends of the sweep
            for (int i = 0; i < corners; i++)
            {
                var corner = new Vector4((i & 1) != 0 ? box.Size.x + 1f : -1f, (i & 2) != 0 ? box.Size.y + 1f : -1f,
                    (i & 4) != 0 ? box.Size.z + 1f : -1f, 1f);
                Vector4 world = box.DomainToWorld * corner;
                if ((i & 8) != 0)
                    world += (Vector4)sweep;
                Vector4 clip = (i < 16 ? left : right) * world;
                isWhole |= clip.w <= 1e-4f;
                isInFront |= clip.w > 0f;
                Vector2 at = new Vector2(clip.x, clip.y) / Mathf.Max(clip.w, 1e-4f);
                bounds = new Vector4(Mathf.Min(bounds.x, at.x), Mathf.Min(bounds.y, at.y), Mathf.Max(bounds.z, at.x), Mathf.Max(bounds.w, at.y));
            }
            if (isWhole)
                bounds = isInFront ? new Vector4(-1f, -1f, 1f, 1f) : Vector4.zero;
            bounds = new Vector4(Mathf.Clamp(bounds.x, -1f, 1f), Mathf.Clamp(bounds.y, -1f, 1f), Mathf.Clamp(bounds.z, -1f, 1f),
                Mathf.Clamp(bounds.w, -1f, 1f));
            return new BoxOnPicture(bounds);
        }
    }
}
