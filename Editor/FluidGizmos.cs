using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Boxes of simulations and volumes in the scene view.</summary>
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

        static void DrawBox(Transform at, Vector3 size, Color color)
        {
            Gizmos.color = color;
            Gizmos.matrix = Matrix4x4.TRS(at.position, at.rotation, Vector3.one);
            Gizmos.DrawWireCube(Vector3.zero, size);
        }
    }
}
