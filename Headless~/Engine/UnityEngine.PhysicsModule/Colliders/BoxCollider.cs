using UnityEngine.Headless;

namespace UnityEngine
{
    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; }
        public Vector3 size { get; set; } = Vector3.one;

        private protected override Vector3 Center => center;

        internal override ShapeDescription Describe()
        {
            Vector3 half = 0.5f * Vector3.Scale(size, AbsoluteScale);
            return new ShapeDescription { Kind = ShapeKind.Box, Size = new Vector3(Mathf.Abs(half.x), Mathf.Abs(half.y), Mathf.Abs(half.z)) };
        }
    }
}
