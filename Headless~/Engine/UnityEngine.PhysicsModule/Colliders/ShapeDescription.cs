using System;

namespace UnityEngine.Headless
{
    internal enum ShapeKind { None, Box, Sphere, Capsule, Hull, Triangles }

    /// <summary>A collider's shape in its own frame, scaled: equal descriptions are the same shape.</summary>
    internal struct ShapeDescription : IEquatable<ShapeDescription>
    {
        /// <summary>Bullet numbers the triangles of a mesh in 21 bits (btQuantizedBvh.h) and crashes beyond.</summary>
        public const int MaxTriangles = 1 << 21;

        public ShapeKind Kind;

        /// <summary>m. Box: half sides. Sphere: x is the radius. Capsule: x is the radius, y from its center to that of a cap.</summary>
        public Vector3 Size;

        /// <summary>Axis of a capsule: 0 along x, 1 along y, 2 along z.</summary>
        public int Axis;

        /// <summary>Source of a hull and of triangles, its state, and their scale.</summary>
        public ITriangles Triangles;
        public int Version;
        public Vector3 Scale;

        public IntPtr Make()
        {
            switch (Kind)
            {
                case ShapeKind.Box: return Bullet.ShapeBox(Size);
                case ShapeKind.Sphere: return Bullet.ShapeSphere(Size.x);
                case ShapeKind.Capsule: return Bullet.ShapeCapsule(Size.x, Size.y, Axis);
                case ShapeKind.Hull: return MakeHull();
                case ShapeKind.Triangles: return MakeTriangles();
                default: return IntPtr.Zero;
            }
        }

        /// <summary>The box around it in its own frame.</summary>
        public Bounds LocalBounds()
        {
            switch (Kind)
            {
                case ShapeKind.Box: return new Bounds(Vector3.zero, 2f * Size);
                case ShapeKind.Sphere: return new Bounds(Vector3.zero, Vector3.one * (2f * Size.x));
                case ShapeKind.Capsule:
                    Vector3 half = Vector3.one * Size.x;
                    half[Axis] += Size.y;
                    return new Bounds(Vector3.zero, 2f * half);
                case ShapeKind.Hull:
                case ShapeKind.Triangles:
                    Bounds bounds = Triangles.Bounds;
                    Vector3 extents = Vector3.Scale(bounds.extents, Scale);
                    return new Bounds(Vector3.Scale(bounds.center, Scale),
                        2f * new Vector3(Mathf.Abs(extents.x), Mathf.Abs(extents.y), Mathf.Abs(extents.z)));
                default: return default;
            }
        }

        IntPtr MakeHull()
        {
            Triangles.Read(out Vector3[] points, out _);
            Stretch(points);
            return points.Length > 0 ? Bullet.ShapeHull(points, points.Length) : IntPtr.Zero;
        }

        // The front stays the front where an axis is mirrored.
        IntPtr MakeTriangles()
        {
            Triangles.Read(out Vector3[] points, out int[] indices);
            Stretch(points);
            if (Scale.x * Scale.y * Scale.z < 0f)
                for (int i = 0; i + 2 < indices.Length; i += 3)
                    (indices[i], indices[i + 1]) = (indices[i + 1], indices[i]);
            if (indices.Length / 3 > MaxTriangles)
            {
                Debug.LogWarning($"The host's physics takes {MaxTriangles:N0} triangles of a collider, and one has {indices.Length / 3:N0}: it is " +
                    "left out. Give it a mesh of fewer.");
                return IntPtr.Zero;
            }
            return indices.Length > 2 ? Bullet.ShapeMesh(points, points.Length, indices, indices.Length) : IntPtr.Zero;
        }

        void Stretch(Vector3[] points)
        {
            for (int i = 0; i < points.Length; i++)
                points[i] = Vector3.Scale(points[i], Scale);
        }

        // Scales come out of matrices: those of a body that turns differ in their last digits.
        public bool Equals(ShapeDescription other) => Kind == other.Kind && Axis == other.Axis && ReferenceEquals(Triangles, other.Triangles)
            && Version == other.Version && Near(Size, other.Size) && Near(Scale, other.Scale);

        public static bool Near(Vector3 a, Vector3 b) => (a - b).sqrMagnitude <= 1e-10f * (a.sqrMagnitude + b.sqrMagnitude);

        public override bool Equals(object other) => other is ShapeDescription description && Equals(description);
        public override int GetHashCode() => (int)Kind;
    }

    /// <summary>Points and triangles of a shape, unscaled.</summary>
    internal interface ITriangles
    {
        Bounds Bounds { get; }

        /// <summary>Arrays that the caller may change.</summary>
        void Read(out Vector3[] points, out int[] indices);
    }
}
