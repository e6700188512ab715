using UnityEngine.Headless;

namespace UnityEngine
{
    public class SphereCollider : Collider
    {
        public Vector3 center { get; set; }
        public float radius { get; set; } = 0.5f;

        private protected override Vector3 Center => center;

        internal override ShapeDescription Describe()
        {
            Vector3 scale = AbsoluteScale;
            return new ShapeDescription { Kind = ShapeKind.Sphere,
                Size = new Vector3(radius * Mathf.Max(scale.x, Mathf.Max(scale.y, scale.z)), 0f, 0f) };
        }
    }
}
