using UnityEngine.Headless;

namespace UnityEngine
{
    public class CapsuleCollider : Collider
    {
        public Vector3 center { get; set; }
        public float radius { get; set; } = 0.5f;
        public float height { get; set; } = 2f;

        /// <summary>0 along x, 1 along y, 2 along z.</summary>
        public int direction { get; set; } = 1;

        private protected override Vector3 Center => center;

        internal override ShapeDescription Describe() => Along(direction, radius, height, AbsoluteScale);

        /// <summary>The height follows the scale along it, the radius the larger of the other two.</summary>
        internal static ShapeDescription Along(int axis, float radius, float height, Vector3 scale)
        {
            float thick = radius * Mathf.Max(scale[(axis + 1) % 3], scale[(axis + 2) % 3]);
            return new ShapeDescription { Kind = ShapeKind.Capsule, Axis = axis,
                Size = new Vector3(thick, Mathf.Max(0.5f * height * scale[axis] - thick, 0f), 0f) };
        }
    }
}
