using System;
using UnityEngine;

namespace Rill
{
    // How fast time passes while no camera sees the fluid.
    public sealed partial class FluidSimulation
    {
        [Tooltip("What the fluid does while no enabled camera sees its box within the Culling Distance. Always Simulate: it goes on. " +
            "Slow: its time passes at the Culled Rate. Pause: its time stands still.")]
        [SerializeField] FluidCullingMode cullingMode = FluidCullingMode.AlwaysSimulate;

        [Tooltip("Distance from a camera to the box beyond which the camera does not count, m. 0: however far it is.")]
        [SerializeField] float cullingDistance;

        [Tooltip("Fraction of the time, and so of the steps, that passes for a slowed fluid while no camera sees it. 0.01 to 1.")]
        [Range(MinCulledRate, 1f)]
        [SerializeField] float culledRate = DefaultCulledRate;

        const float MinCulledRate = 0.01f, DefaultCulledRate = 0.25f;
        const float CullingMargin = 2f;     // d: how far what is drawn may reach beyond the box

        [NonSerialized] Camera[] cameras;
        Plane[] planes;

        /// <summary>What the fluid does while no camera sees its box; it goes on by default.</summary>
        /// <remarks>
        /// Cameras that are enabled and draw this object's layer count, in the frame and where they are before its steps. A camera that a script
        /// renders while it is disabled, the scene view, and a shadow of water that is out of sight do not count. While the fluid is slowed or
        /// paused, what moves in it does not push it, as under <see cref="Paused"/>.
        /// </remarks>
        public FluidCullingMode CullingMode { get => cullingMode; set => cullingMode = value; }

        /// <summary>Distance from a camera to the box beyond which the camera does not count, m; 0 for however far. Out-of-range values are
        /// clamped with a warning.</summary>
        public float CullingDistance { get => cullingDistance; set { cullingDistance = value; Changed(); } }

        /// <summary>Fraction of the time, and so of the steps, that passes while a fluid is slowed, 0.01 to 1. Out-of-range values are
        /// clamped with a warning.</summary>
        public float CulledRate { get => culledRate; set { culledRate = value; Changed(); } }

        /// <summary>Whether no camera saw the box in the last frame, so that the fluid was slowed or paused. False with
        /// <see cref="FluidCullingMode.AlwaysSimulate"/>.</summary>
        [field: NonSerialized] public bool IsCulled { get; private set; }

        void ValidateCulling(ref string problem)
        {
            Limit.Clamp("culling distance", ref cullingDistance, 0f, float.MaxValue, 0f, ref problem);
            Limit.Clamp("culled rate", ref culledRate, MinCulledRate, 1f, DefaultCulledRate, ref problem);
        }

        // How fast the fluid's time passes in this frame: 0 to 1.
        float TimeRate()
        {
            IsCulled = cullingMode != FluidCullingMode.AlwaysSimulate && !IsSeen();
            if (paused)
                return 0f;
            if (!IsCulled)
                return 1f;
            return cullingMode == FluidCullingMode.Pause ? 0f : culledRate;
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
            if ((camera.cullingMask >> gameObject.layer & 1) == 0)
                return false;
            if (cullingDistance > 0f && bounds.SqrDistance(camera.transform.position) > cullingDistance * cullingDistance)
                return false;
            GeometryUtility.CalculateFrustumPlanes(camera.cullingMatrix, planes);      // holds both eyes
            return GeometryUtility.TestPlanesAABB(planes, bounds);
        }

        // Of the box and what is drawn beyond it.
        Bounds WorldBounds
        {
            get
            {
                GetPose(out Vector3 place, out Quaternion rotation);
                Vector3 half = domainSize * 0.5f + Vector3.one * (CullingMargin * particleSpacing);
                Vector3 x = rotation * new Vector3(half.x, 0f, 0f), y = rotation * new Vector3(0f, half.y, 0f),
                    z = rotation * new Vector3(0f, 0f, half.z);
                return new Bounds(place, 2f * new Vector3(
                    Mathf.Abs(x.x) + Mathf.Abs(y.x) + Mathf.Abs(z.x),
                    Mathf.Abs(x.y) + Mathf.Abs(y.y) + Mathf.Abs(z.y),
                    Mathf.Abs(x.z) + Mathf.Abs(y.z) + Mathf.Abs(z.z)));
            }
        }
    }
}
