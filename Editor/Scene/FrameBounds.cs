using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Bounds that F frames for a component in the scene view: its shape in the world, as <see cref="FluidGizmos"/> draws it.</summary>
    static class FrameBounds
    {
        public static bool TryGet(FluidSimulation fluid, out Bounds bounds) => TryBox(fluid.transform, fluid.DomainSize, out bounds);

        public static bool TryGet(FluidVolume volume, out Bounds bounds)
        {
            switch (volume.Shape)
            {
                case VolumeShape.SignedDistanceField: return TryField(volume.transform, volume.Field, out bounds);
                case VolumeShape.Sphere: return TrySphere(volume.transform, volume.Radius, out bounds);
                default: return TryBox(volume.transform, volume.Size, out bounds);
            }
        }

        public static bool TryGet(FluidEmitter emitter, out Bounds bounds)
        {
            bool isSolid = emitter.Mode == EmitterMode.Fill;
            Vector3 flat = new Vector3(1f, 1f, 0f);
            switch (emitter.Shape)
            {
                case EmitterShape.Box:
                    return TryBox(emitter.transform, isSolid ? emitter.Size : Vector3.Scale(emitter.Size, flat), out bounds);
                case EmitterShape.Sphere when isSolid:
                    return TrySphere(emitter.transform, emitter.Radius, out bounds);
                case EmitterShape.MeshSurface:
                    bounds = emitter.Mesh != null ? emitter.Mesh.bounds : default;
                    return emitter.Mesh != null && TryTurn(emitter.transform, emitter.transform.lossyScale, ref bounds);
                default:
                    return TryBox(emitter.transform, 2f * emitter.Radius * flat, out bounds);
            }
        }

        public static bool TryGet(FluidDrain drain, out Bounds bounds) => drain.Shape == DrainShape.Sphere
            ? TrySphere(drain.transform, drain.Radius, out bounds) : TryBox(drain.transform, drain.Size, out bounds);

        public static bool TryGet(FluidForceField field, out Bounds bounds)
        {
            switch (field.Bounds)
            {
                case ForceFieldBounds.Sphere: return TrySphere(field.transform, field.Radius, out bounds);
                case ForceFieldBounds.Box: return TryBox(field.transform, field.Size, out bounds);
                default:
                    bounds = default;
                    return false;
            }
        }

        public static bool TryGet(FluidSmokeSource source, out Bounds bounds) => TrySphere(source.transform, source.Radius, out bounds);

        public static bool TryGet(FluidProbe probe, out Bounds bounds) => TrySphere(probe.transform, probe.Radius, out bounds);

        public static bool TryGet(FluidDetector detector, out Bounds bounds)
        {
            switch (detector.Shape)
            {
                case DetectorShape.Box: return TryBox(detector.transform, detector.Size, out bounds);
                case DetectorShape.Mesh: return TryField(detector.transform, detector.Field, out bounds);
                case DetectorShape.Capsule:
                    return TryCapsule(detector.transform, Vector3.zero, detector.Radius, detector.Height, out bounds);
                default: return TrySphere(detector.transform, detector.Radius, out bounds);
            }
        }

        public static bool TryGet(FluidCollider collider, out Bounds bounds)
        {
            Transform at = collider.transform;
            Vector3 scale = at.lossyScale, center = Vector3.Scale(collider.Center, scale);
            float across = Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.z)), even = Mathf.Max(across, Mathf.Abs(scale.y));
            bounds = default;
            switch (collider.Shape)
            {
                case ColliderShape.Sphere:
                    return TryPoint(at, center, even * collider.Radius, out bounds);
                case ColliderShape.Capsule:
                    return TryCapsule(at, center, across * collider.Radius, Mathf.Abs(scale.y) * collider.Height, out bounds);
                case ColliderShape.Box:
                    bounds = new Bounds(center, Vector3.Scale(collider.Size, scale));
                    return TryTurn(at, Vector3.one, ref bounds);
                case ColliderShape.HeightField when collider.Heights != null:
                    bounds = new Bounds(collider.WorldCenter, 2f * (Vector3)collider.Heights.Extents);
                    return true;
                case ColliderShape.Mesh when collider.Deforming != null:
                    bounds = Turned(collider.Deforming.FieldToWorld, new Bounds(Vector3.zero, collider.Deforming.Grid.Bounds.size));
                    return true;
                case ColliderShape.Mesh when collider.Field != null:
                    return TryField(at, collider.Field, out bounds);
                default:
                    return false;       // a plane has no end
            }
        }

        public static bool TryGet(FluidBoneColliders bones, out Bounds bounds)
        {
            bool isThere = false;
            bounds = default;
            foreach (FluidCollider capsule in bones.Capsules)
                if (capsule != null && TryGet(capsule, out Bounds one))
                    Join(ref isThere, ref bounds, one);
            return isThere;
        }

        public static bool TryGet(FluidConnection connection, out Bounds bounds)
        {
            bool isThere = false;
            bounds = default;
            if (connection.First != null && TryGet(connection.First, out Bounds one))
                Join(ref isThere, ref bounds, one);
            if (connection.Second != null && TryGet(connection.Second, out Bounds other))
                Join(ref isThere, ref bounds, other);
            return isThere;
        }

        /// <summary>Holds one more, the first as it is.</summary>
        public static void Join(ref bool isThere, ref Bounds bounds, Bounds more)
        {
            if (isThere)
                bounds.Encapsulate(more);
            else
                bounds = more;
            isThere = true;
        }

        static bool TryBox(Transform at, Vector3 size, out Bounds bounds)
        {
            bounds = new Bounds(Vector3.zero, size);
            return TryTurn(at, Vector3.one, ref bounds);
        }

        static bool TryField(Transform at, SignedDistanceField field, out Bounds bounds)
        {
            bounds = field != null ? field.Bounds : default;
            return field != null && TryTurn(at, at.lossyScale, ref bounds);
        }

        static bool TrySphere(Transform at, float radius, out Bounds bounds) => TryPoint(at, Vector3.zero, radius, out bounds);

        // Around a point of the object's frame that follows no scale.
        static bool TryPoint(Transform at, Vector3 point, float radius, out Bounds bounds)
        {
            bounds = new Bounds(point, Vector3.zero);
            bool isPlaced = TryTurn(at, Vector3.one, ref bounds);
            bounds.Expand(2f * radius);
            return isPlaced;
        }

        // Along the object's y axis.
        static bool TryCapsule(Transform at, Vector3 center, float radius, float height, out Bounds bounds)
        {
            float straight = Mathf.Max(0.5f * height - radius, 0f);
            bounds = new Bounds(center, new Vector3(0f, 2f * straight, 0f));
            bool isPlaced = TryTurn(at, Vector3.one, ref bounds);
            bounds.Expand(2f * radius);
            return isPlaced;
        }

        // From the object's frame to the world's; false where the object is nowhere.
        static bool TryTurn(Transform at, Vector3 scale, ref Bounds bounds)
        {
            if (!Limit.IsPose(at.position, at.rotation))
                return false;
            bounds = Turned(Matrix4x4.TRS(at.position, at.rotation, scale), bounds);
            return true;
        }

        /// <summary>Bounds in another frame that hold a box.</summary>
        public static Bounds Turned(Matrix4x4 toWorld, Bounds local)
        {
            Vector3 half = Vector3.zero;
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++)
                    half[row] += Mathf.Abs(toWorld[row, column] * local.extents[column]);
            return new Bounds(toWorld.MultiplyPoint3x4(local.center), 2f * half);
        }
    }
}
