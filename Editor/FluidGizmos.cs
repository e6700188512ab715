using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Simulations, volumes and colliders in the scene view.</summary>
    static class FluidGizmos
    {
        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected)]
        static void DrawDomain(FluidSimulation simulation, GizmoType type)
        {
            DrawBox(simulation.transform, simulation.DomainSize, new Color(0.3f, 0.6f, 1f));
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected)]
        static void DrawVolume(FluidVolume volume, GizmoType type)
        {
            DrawBox(volume.transform, volume.Size, new Color(0.2f, 0.4f, 1f, 0.7f));
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected)]
        static void DrawCollider(FluidCollider collider, GizmoType type)
        {
            Transform at = collider.transform;
            Vector3 scale = at.lossyScale;
            float even = Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
            Gizmos.color = collider.isActiveAndEnabled ? new Color(0.3f, 0.9f, 0.4f) : new Color(0.3f, 0.9f, 0.4f, 0.3f);
            Gizmos.matrix = Matrix4x4.TRS(collider.Middle, at.rotation, Vector3.one);
            switch (collider.Shape)
            {
                case ColliderShape.Sphere:
                    Gizmos.DrawWireSphere(Vector3.zero, even * collider.Radius);
                    break;
                case ColliderShape.Capsule:
                    float radius = Mathf.Max(Mathf.Abs(scale.x), Mathf.Abs(scale.z)) * collider.Radius;
                    float straight = Mathf.Max(0.5f * Mathf.Abs(scale.y) * collider.Height - radius, 0f);
                    Gizmos.DrawWireSphere(straight * Vector3.up, radius);
                    Gizmos.DrawWireSphere(straight * Vector3.down, radius);
                    break;
                case ColliderShape.Box:
                    Gizmos.DrawWireCube(Vector3.zero, Vector3.Scale(collider.Size, scale));
                    break;
                case ColliderShape.Plane:
                    Gizmos.DrawWireCube(Vector3.zero, new Vector3(2f, 0f, 2f));
                    Gizmos.DrawLine(Vector3.zero, 0.5f * Vector3.up);
                    break;
                case ColliderShape.Mesh when collider.Field != null:
                    Gizmos.DrawWireCube(Vector3.zero, even * collider.Field.Bounds.size);
                    break;
            }
        }

        static void DrawBox(Transform at, Vector3 size, Color color)
        {
            Gizmos.color = color;
            Gizmos.matrix = Matrix4x4.TRS(at.position, at.rotation, Vector3.one);
            Gizmos.DrawWireCube(Vector3.zero, size);
        }
    }
}
