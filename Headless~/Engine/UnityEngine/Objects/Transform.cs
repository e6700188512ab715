using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    public partial class Transform : Component, IEnumerable
    {
        Quaternion m_LocalRotation = Quaternion.identity;
        Vector3 m_LocalPosition;
        Vector3 m_LocalScale = Vector3.one;
        [NonSerialized] internal Transform ParentOf;
        [NonSerialized] internal readonly List<Transform> Children = new List<Transform>();
        [NonSerialized] Matrix4x4 world;
        [NonSerialized] bool worldIsCurrent;

        protected Transform() { }

        public bool hasChanged { get; set; } = true;

        // ---- local
        public Vector3 localPosition { get { ThrowIfDestroyed(); return m_LocalPosition; } set { ThrowIfDestroyed();
            if (IsValidPosition(nameof(localPosition), value)) { m_LocalPosition = value; Moved(); } } }
        public Quaternion localRotation { get { ThrowIfDestroyed(); return m_LocalRotation; } set { ThrowIfDestroyed();
            m_LocalRotation = Quaternion.Normalize(value); Moved(); } }
        public Vector3 localScale { get { ThrowIfDestroyed(); return m_LocalScale; } set { ThrowIfDestroyed(); m_LocalScale = value; Moved(); } }
        public Vector3 localEulerAngles { get => localRotation.eulerAngles; set => localRotation = Quaternion.Euler(value); }

        void Moved()
        {
            hasChanged = true;
            // Children of a stale matrix are stale already, but they still have to hear that they moved.
            worldIsCurrent = false;
            foreach (Transform child in Children)
                child.Moved();
        }

        // ---- world
        public Matrix4x4 localToWorldMatrix
        {
            get
            {
                ThrowIfDestroyed();
                if (!worldIsCurrent)
                {
                    Matrix4x4 local = Matrix4x4.TRS(m_LocalPosition, m_LocalRotation, m_LocalScale);
                    world = ParentOf is null ? local : ParentOf.localToWorldMatrix * local;
                    worldIsCurrent = true;
                }
                return world;
            }
        }

        public Matrix4x4 worldToLocalMatrix => localToWorldMatrix.inverse;

        public Vector3 position
        {
            get => localToWorldMatrix.GetPosition();
            set
            {
                if (IsValidPosition(nameof(position), value))
                    localPosition = ParentOf is null ? value : ParentOf.InverseTransformPoint(value);
            }
        }

        // An invalid position is refused with Unity's message, and the old one stays.
        bool IsValidPosition(string property, Vector3 value)
        {
            if (float.IsFinite(value.x) && float.IsFinite(value.y) && float.IsFinite(value.z))
                return true;
            Debug.LogError(FormattableString.Invariant(
                $"transform.{property} assign attempt for '{name}' is not valid. Input {property} is {{ {value.x:F6}, {value.y:F6}, {value.z:F6} }}."), this);
            return false;
        }

        public Quaternion rotation
        {
            get
            {
                ThrowIfDestroyed();
                Quaternion q = m_LocalRotation;
                for (Transform t = ParentOf; t is object; t = t.ParentOf)
                    q = t.m_LocalRotation * Mirror(q, t.m_LocalScale);
                return q;
            }
            set => localRotation = ParentOf is null ? value : ParentOf.ToLocal(Quaternion.Normalize(value));
        }

        Quaternion ToLocal(Quaternion q)
        {
            if (ParentOf is object)
                q = ParentOf.ToLocal(q);
            return Mirror(Quaternion.Inverse(m_LocalRotation) * q, m_LocalScale);
        }

        // The rotation as seen through a scale with negative axes: S R S^-1.
        static Quaternion Mirror(Quaternion q, Vector3 scale)
        {
            float x = Mathf.Sign(scale.x), y = Mathf.Sign(scale.y), z = Mathf.Sign(scale.z);
            return new Quaternion(q.x * y * z, q.y * x * z, q.z * x * y, q.w);
        }

        public Vector3 lossyScale
        {
            get
            {
                // Rest of the matrix once the rotation is removed; its diagonal, as a scale holds no shear.
                Matrix4x4 m = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * localToWorldMatrix;
                return new Vector3(m.m00, m.m11, m.m22);
            }
        }

        public Vector3 eulerAngles { get => rotation.eulerAngles; set => rotation = Quaternion.Euler(value); }
        public Vector3 right { get => rotation * Vector3.right; set => rotation = Quaternion.FromToRotation(Vector3.right, value); }
        public Vector3 up { get => rotation * Vector3.up; set => rotation = Quaternion.FromToRotation(Vector3.up, value); }
        public Vector3 forward { get => rotation * Vector3.forward; set => rotation = Quaternion.LookRotation(value); }

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public void SetLocalPositionAndRotation(Vector3 localPosition, Quaternion localRotation)
        {
            this.localPosition = localPosition;
            this.localRotation = localRotation;
        }

        public void GetPositionAndRotation(out Vector3 position, out Quaternion rotation)
        {
            position = this.position;
            rotation = this.rotation;
        }

        public void GetLocalPositionAndRotation(out Vector3 localPosition, out Quaternion localRotation)
        {
            localPosition = m_LocalPosition;
            localRotation = m_LocalRotation;
        }

        // ---- motion
        public void Translate(Vector3 translation) => Translate(translation, Space.Self);
        public void Translate(Vector3 translation, Space relativeTo) => position += relativeTo == Space.World ? translation
            : TransformDirection(translation);
        public void Translate(Vector3 translation, Transform relativeTo)
            => position += relativeTo ? relativeTo.TransformDirection(translation) : translation;
        public void Translate(float x, float y, float z) => Translate(new Vector3(x, y, z));
        public void Translate(float x, float y, float z, Space relativeTo) => Translate(new Vector3(x, y, z), relativeTo);
        public void Translate(float x, float y, float z, Transform relativeTo) => Translate(new Vector3(x, y, z), relativeTo);

        public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);

        public void Rotate(Vector3 eulers, Space relativeTo)
        {
            Quaternion turn = Quaternion.Euler(eulers);
            if (relativeTo == Space.Self)
                localRotation *= turn;
            else
                rotation = turn * rotation;
        }

        public void Rotate(float xAngle, float yAngle, float zAngle) => Rotate(new Vector3(xAngle, yAngle, zAngle), Space.Self);
        public void Rotate(float xAngle, float yAngle, float zAngle, Space relativeTo) => Rotate(new Vector3(xAngle, yAngle, zAngle), relativeTo);
        public void Rotate(Vector3 axis, float angle) => Rotate(axis, angle, Space.Self);

        public void Rotate(Vector3 axis, float angle, Space relativeTo)
        {
            Vector3 worldAxis = relativeTo == Space.Self ? TransformDirection(axis) : axis;
            rotation = Quaternion.AngleAxis(angle, worldAxis) * rotation;
        }

        public void RotateAround(Vector3 point, Vector3 axis, float angle)
        {
            Quaternion turn = Quaternion.AngleAxis(angle, axis);
            position = point + turn * (position - point);
            rotation = turn * rotation;
        }

        public void LookAt(Transform target) => LookAt(target, Vector3.up);
        public void LookAt(Transform target, Vector3 worldUp) { if (target) LookAt(target.position, worldUp); }
        public void LookAt(Vector3 worldPosition) => LookAt(worldPosition, Vector3.up);

        public void LookAt(Vector3 worldPosition, Vector3 worldUp)
        {
            Vector3 direction = worldPosition - position;
            if (direction != Vector3.zero)
                rotation = Quaternion.LookRotation(direction, worldUp);
        }

        // ---- between spaces: points take position, rotation and scale, vectors rotation and scale, directions rotation only
        public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);
        public Vector3 TransformPoint(float x, float y, float z) => TransformPoint(new Vector3(x, y, z));
        public Vector3 InverseTransformPoint(Vector3 position) => worldToLocalMatrix.MultiplyPoint3x4(position);
        public Vector3 InverseTransformPoint(float x, float y, float z) => InverseTransformPoint(new Vector3(x, y, z));
        public Vector3 TransformVector(Vector3 vector) => localToWorldMatrix.MultiplyVector(vector);
        public Vector3 TransformVector(float x, float y, float z) => TransformVector(new Vector3(x, y, z));
        public Vector3 InverseTransformVector(Vector3 vector) => worldToLocalMatrix.MultiplyVector(vector);
        public Vector3 InverseTransformVector(float x, float y, float z) => InverseTransformVector(new Vector3(x, y, z));
        public Vector3 TransformDirection(Vector3 direction) => rotation * direction;
        public Vector3 TransformDirection(float x, float y, float z) => TransformDirection(new Vector3(x, y, z));
        public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;
        public Vector3 InverseTransformDirection(float x, float y, float z) => InverseTransformDirection(new Vector3(x, y, z));

        public void TransformPoints(ReadOnlySpan<Vector3> positions, Span<Vector3> transformedPositions)
        {
            Matrix4x4 m = localToWorldMatrix;
            for (int i = 0; i < positions.Length; i++)
                transformedPositions[i] = m.MultiplyPoint3x4(positions[i]);
        }

        public void InverseTransformPoints(ReadOnlySpan<Vector3> positions, Span<Vector3> transformedPositions)
        {
            Matrix4x4 m = worldToLocalMatrix;
            for (int i = 0; i < positions.Length; i++)
                transformedPositions[i] = m.MultiplyPoint3x4(positions[i]);
        }

        public void TransformVectors(ReadOnlySpan<Vector3> vectors, Span<Vector3> transformedVectors)
        {
            Matrix4x4 m = localToWorldMatrix;
            for (int i = 0; i < vectors.Length; i++)
                transformedVectors[i] = m.MultiplyVector(vectors[i]);
        }

        public void InverseTransformVectors(ReadOnlySpan<Vector3> vectors, Span<Vector3> transformedVectors)
        {
            Matrix4x4 m = worldToLocalMatrix;
            for (int i = 0; i < vectors.Length; i++)
                transformedVectors[i] = m.MultiplyVector(vectors[i]);
        }

        public void TransformDirections(ReadOnlySpan<Vector3> directions, Span<Vector3> transformedDirections)
        {
            Quaternion q = rotation;
            for (int i = 0; i < directions.Length; i++)
                transformedDirections[i] = q * directions[i];
        }

        public void InverseTransformDirections(ReadOnlySpan<Vector3> directions, Span<Vector3> transformedDirections)
        {
            Quaternion q = Quaternion.Inverse(rotation);
            for (int i = 0; i < directions.Length; i++)
                transformedDirections[i] = q * directions[i];
        }

        public void TransformPoints(Span<Vector3> positions) => TransformPoints(positions, positions);
        public void InverseTransformPoints(Span<Vector3> positions) => InverseTransformPoints(positions, positions);
        public void TransformVectors(Span<Vector3> vectors) => TransformVectors(vectors, vectors);
        public void InverseTransformVectors(Span<Vector3> vectors) => InverseTransformVectors(vectors, vectors);
        public void TransformDirections(Span<Vector3> directions) => TransformDirections(directions, directions);
        public void InverseTransformDirections(Span<Vector3> directions) => InverseTransformDirections(directions, directions);
    }

    public enum Space { World = 0, Self = 1 }
}
