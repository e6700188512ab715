using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Slows or pauses a fluid while no camera sees its box.</summary>
    sealed class BoxCulling
    {
        const float Margin = 2f;     // d: how far what is drawn may reach beyond the box

        readonly FluidSimulation fluid;
        Camera[] cameras;
        Plane[] planes;

        public BoxCulling(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Whether no camera saw the box in the last frame. False with <see cref="FluidCullingMode.AlwaysSimulate"/>.</summary>
        public bool IsCulled { get; private set; }

        /// <summary>Returns how fast the fluid's time passes in this frame: 0 to 1.</summary>
        public float TimeRate()
        {
            IsCulled = fluid.CullingMode != FluidCullingMode.AlwaysSimulate && !IsSeen();
            if (fluid.Paused)
                return 0f;
            if (!IsCulled)
                return 1f;
            return fluid.CullingMode == FluidCullingMode.Pause ? 0f : fluid.CulledRate;
        }

        // Allocates when there are more cameras than ever before.
        bool IsSeen()
        {
            int count = Camera.allCamerasCount;
            if (cameras == null || cameras.Length < count)
                cameras = new Camera[Math.Max(count, 4)];
            planes ??= new Plane[6];
            count = Camera.GetAllCameras(cameras);
            Bounds bounds = WorldBounds;
            bool isSeen = false;
            for (int i = 0; i < count; i++)
            {
                isSeen = isSeen || IsSeenBy(cameras[i], bounds);
                cameras[i] = null;      // it may be destroyed
            }
            return isSeen;
        }

        bool IsSeenBy(Camera camera, in Bounds bounds)
        {
            if ((camera.cullingMask >> fluid.gameObject.layer & 1) == 0)
                return false;
            float distance = fluid.CullingDistance;
            if (distance > 0f && bounds.SqrDistance(camera.transform.position) > distance * distance)
                return false;
            GeometryUtility.CalculateFrustumPlanes(camera.cullingMatrix, planes);      // holds both eyes
            return GeometryUtility.TestPlanesAABB(planes, bounds);
        }

        // Bounds of the box and of what is drawn beyond it.
        Bounds WorldBounds
        {
            get
            {
                fluid.GetPose(out Vector3 position, out Quaternion rotation);
                Vector3 half = fluid.DomainSize * 0.5f + Vector3.one * (Margin * fluid.ParticleSpacing);
                Vector3 x = rotation * new Vector3(half.x, 0f, 0f), y = rotation * new Vector3(0f, half.y, 0f),
                    z = rotation * new Vector3(0f, 0f, half.z);
                return new Bounds(position, 2f * new Vector3(
                    Mathf.Abs(x.x) + Mathf.Abs(y.x) + Mathf.Abs(z.x),
                    Mathf.Abs(x.y) + Mathf.Abs(y.y) + Mathf.Abs(z.y),
                    Mathf.Abs(x.z) + Mathf.Abs(y.z) + Mathf.Abs(z.z)));
            }
        }
    }
}
