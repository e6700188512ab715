using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed class Camera : Behaviour
    {
        public delegate void CameraCallback(Camera cam);
        public enum StereoscopicEye { Left, Right }
        public enum MonoOrStereoscopicEye { Left, Right, Mono }

        public static CameraCallback onPreCull, onPreRender, onPostRender;

        static readonly List<Camera> active = new List<Camera>();

        readonly EventCommands<CameraEvent> commandBuffers = new EventCommands<CameraEvent>();
        Matrix4x4? explicitView, explicitProjection, explicitCulling;
        float explicitAspect;

        internal override void OnActivated() => active.Add(this);
        internal override void OnDeactivated() => active.Remove(this);
        internal override void OnCopied(Component source) => CopyFrom((Camera)source);

        /// <summary>Enabled cameras in the order in which they draw.</summary>
        internal static List<Camera> InDrawOrder()
        {
            var order = new List<Camera>(active);
            Order(order, order.Count);
            return order;
        }

        static void Order(IList<Camera> cameras, int count)
        {
            for (int i = 1; i < count; i++)       // insertion keeps equal depths in order of activation
                for (int k = i; k > 0 && cameras[k].depth < cameras[k - 1].depth; k--)
                    (cameras[k], cameras[k - 1]) = (cameras[k - 1], cameras[k]);
        }

        public static Camera current { get; internal set; }
        public static Camera[] allCameras => InDrawOrder().ToArray();
        public static int allCamerasCount => active.Count;

        public static Camera main
        {
            get
            {
                foreach (Camera camera in active)
                    if (camera.CompareTag("MainCamera"))
                        return camera;
                return null;
            }
        }

        public static int GetAllCameras(Camera[] cameras)
        {
            if (cameras.Length < active.Count)
                throw new ArgumentException($"GetAllCameras: the array has room for {cameras.Length} of {active.Count} cameras.");
            active.CopyTo(cameras);
            Order(cameras, active.Count);
            return active.Count;
        }

        // ---- what and how it draws

        public float fieldOfView { get; set; } = 60;
        public float nearClipPlane { get; set; } = 0.3f;
        public float farClipPlane { get; set; } = 1000;
        public bool orthographic { get; set; }
        public float orthographicSize { get; set; } = 5;
        public float depth { get; set; }
        public int cullingMask { get; set; } = ~0;
        public int eventMask { get; set; } = ~0;
        public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;
        public Color backgroundColor { get; set; } = new Color(49 / 255f, 77 / 255f, 121 / 255f, 0);
        public RenderTexture targetTexture { get; set; }
        public Rect rect { get; set; } = new Rect(0, 0, 1, 1);
        public DepthTextureMode depthTextureMode { get; set; }
        public RenderingPath renderingPath { get; set; } = RenderingPath.UsePlayerSettings;
        public RenderingPath actualRenderingPath => RenderingPath.Forward;
        public CameraType cameraType { get; set; } = CameraType.Game;
        public bool allowHDR { get; set; } = true;
        public bool allowMSAA { get; set; } = true;
        public bool allowDynamicResolution { get; set; }
        public bool useOcclusionCulling { get; set; } = true;
        public bool forceIntoRenderTexture { get; set; }
        public Matrix4x4 GetStereoViewMatrix(StereoscopicEye eye) => stereoEnabled ? StereoView.ViewOf(this, (int)eye) : worldToCameraMatrix;
        public Matrix4x4 GetStereoProjectionMatrix(StereoscopicEye eye) => stereoEnabled ? StereoView.ProjectionOf(this) : projectionMatrix;
        public bool stereoEnabled => Player.Stereo && targetTexture is null;
        /// <summary>Here both are drawn in one pass.</summary>
        public MonoOrStereoscopicEye stereoActiveEye => stereoEnabled ? MonoOrStereoscopicEye.Left : MonoOrStereoscopicEye.Mono;
        public int targetDisplay { get; set; }
        public OpaqueSortMode opaqueSortMode { get; set; }
        public TransparencySortMode transparencySortMode { get; set; }
        public Vector3 transparencySortAxis { get; set; } = Vector3.forward;
        public RenderTexture activeTexture => targetTexture;
        public Vector3 velocity => Vector3.zero;

        // Physical cameras: stored, they change nothing here.
        public bool usePhysicalProperties { get; set; }
        public Vector2 sensorSize { get; set; } = new Vector2(36, 24);
        public Vector2 lensShift { get; set; }
        public float focalLength { get; set; } = 50;

        int TargetWidth => targetTexture != null ? targetTexture.width : Player.ScreenWidth;
        int TargetHeight => targetTexture != null ? targetTexture.height : Player.ScreenHeight;

        public Rect pixelRect
        {
            get => new Rect(rect.x * TargetWidth, rect.y * TargetHeight, rect.width * TargetWidth, rect.height * TargetHeight);
            set => rect = new Rect(value.x / TargetWidth, value.y / TargetHeight, value.width / TargetWidth, value.height / TargetHeight);
        }

        /// <summary>Width of one eye, if there are two.</summary>
        public int pixelWidth => Mathf.RoundToInt(pixelRect.width) / (stereoEnabled ? 2 : 1);
        public int pixelHeight => Mathf.RoundToInt(pixelRect.height);
        public int scaledPixelWidth => pixelWidth;
        public int scaledPixelHeight => pixelHeight;

        public float aspect { get => explicitAspect > 0 ? explicitAspect : (float)pixelWidth / Math.Max(1, pixelHeight);
            set => explicitAspect = value; }
        public void ResetAspect() => explicitAspect = 0;

        // ---- matrices; camera space looks along -z, as OpenGL's

        public Matrix4x4 worldToCameraMatrix
        {
            get => explicitView ?? Matrix4x4.Scale(new Vector3(1, 1, -1)) * Matrix4x4.TRS(transform.position, transform.rotation,
                Vector3.one).inverse;
            set => explicitView = value;
        }

        public Matrix4x4 cameraToWorldMatrix => worldToCameraMatrix.inverse;
        public void ResetWorldToCameraMatrix() => explicitView = null;

        public Matrix4x4 projectionMatrix
        {
            get
            {
                if (explicitProjection.HasValue)
                    return explicitProjection.Value;
                if (!orthographic)
                    return Matrix4x4.Perspective(fieldOfView, aspect, nearClipPlane, farClipPlane);
                float h = orthographicSize, w = h * aspect;
                return Matrix4x4.Ortho(-w, w, -h, h, nearClipPlane, farClipPlane);
            }
            set => explicitProjection = value;
        }

        public Matrix4x4 nonJitteredProjectionMatrix { get => projectionMatrix; set { } }
        public void ResetProjectionMatrix() => explicitProjection = null;

        /// <summary>The camera's projection with another near plane (Lengyel 2005).</summary>
        /// <param name="clipPlane">In camera space, its normal away from the camera.</param>
        public Matrix4x4 CalculateObliqueMatrix(Vector4 clipPlane)
        {
            Matrix4x4 oblique = projectionMatrix;
            Vector4 corner = oblique.inverse * new Vector4(Math.Sign(clipPlane.x), Math.Sign(clipPlane.y), 1, 1);
            oblique.SetRow(2, clipPlane * (2 / Vector4.Dot(clipPlane, corner)) - oblique.GetRow(3));
            return oblique;
        }
        public Matrix4x4 cullingMatrix { get => explicitCulling ?? projectionMatrix * worldToCameraMatrix; set => explicitCulling = value; }
        public void ResetCullingMatrix() => explicitCulling = null;

        public Vector3 WorldToViewportPoint(Vector3 position)
        {
            Vector3 view = worldToCameraMatrix.MultiplyPoint3x4(position);
            Vector4 clip = projectionMatrix * new Vector4(view.x, view.y, view.z, 1);
            if (clip.w == 0)
                return new Vector3(0.5f, 0.5f, -view.z);
            return new Vector3(clip.x / clip.w * 0.5f + 0.5f, clip.y / clip.w * 0.5f + 0.5f, -view.z);
        }

        public Vector3 WorldToScreenPoint(Vector3 position) => ViewportToScreenPoint(WorldToViewportPoint(position));
        public Vector3 ViewportToScreenPoint(Vector3 position)
            => new Vector3(pixelRect.x + position.x * pixelRect.width, pixelRect.y + position.y * pixelRect.height, position.z);
        public Vector3 ScreenToViewportPoint(Vector3 position)
            => new Vector3((position.x - pixelRect.x) / pixelRect.width, (position.y - pixelRect.y) / pixelRect.height, position.z);
        public Vector3 ScreenToWorldPoint(Vector3 position) => ViewportToWorldPoint(ScreenToViewportPoint(position));

        /// <param name="position">z: distance from the camera along its forward axis.</param>
        public Vector3 ViewportToWorldPoint(Vector3 position)
        {
            Matrix4x4 projection = projectionMatrix;
            Vector4 depth = projection * new Vector4(0, 0, -position.z, 1);
            var clip = new Vector4((position.x * 2 - 1) * depth.w, (position.y * 2 - 1) * depth.w, depth.z, depth.w);
            Vector4 view = projection.inverse * clip;
            return cameraToWorldMatrix.MultiplyPoint3x4(new Vector3(view.x / view.w, view.y / view.w, view.z / view.w));
        }

        public Ray ScreenPointToRay(Vector3 pos) => ViewportPointToRay(ScreenToViewportPoint(pos));

        /// <summary>From the near plane, away from the camera.</summary>
        public Ray ViewportPointToRay(Vector3 pos)
        {
            Vector3 near = ViewportToWorldPoint(new Vector3(pos.x, pos.y, nearClipPlane));
            Vector3 far = ViewportToWorldPoint(new Vector3(pos.x, pos.y, nearClipPlane + 1));
            return new Ray(near, (far - near).normalized);
        }

        /// <summary>Lower left, upper left, upper right, lower right of a cross-section of the view, in the camera's own space with z
        /// forward.</summary>
        public void CalculateFrustumCorners(Rect viewport, float z, MonoOrStereoscopicEye eye, Vector3[] outCorners)
        {
            if (outCorners == null)
                throw new ArgumentNullException(nameof(outCorners));
            if (outCorners.Length < 4)
                throw new ArgumentException("outCorners minimum size is 4", nameof(outCorners));
            Matrix4x4 toCamera = worldToCameraMatrix;
            Vector2[] corners = { new Vector2(viewport.xMin, viewport.yMin), new Vector2(viewport.xMin, viewport.yMax),
                new Vector2(viewport.xMax, viewport.yMax), new Vector2(viewport.xMax, viewport.yMin) };
            for (int i = 0; i < 4; i++)
            {
                Vector3 corner = toCamera.MultiplyPoint3x4(ViewportToWorldPoint(new Vector3(corners[i].x, corners[i].y, z)));
                outCorners[i] = new Vector3(corner.x, corner.y, -corner.z);
            }
        }

        // ---- drawing

        /// <summary>Draws this camera now, enabled or not.</summary>
        public void Render() => FrameRenderer.Render(this);

        public void AddCommandBuffer(CameraEvent evt, CommandBuffer buffer) => commandBuffers.Add(evt, buffer);
        public void RemoveCommandBuffer(CameraEvent evt, CommandBuffer buffer) => commandBuffers.Remove(evt, buffer);
        public void RemoveCommandBuffers(CameraEvent evt) => commandBuffers.RemoveAll(evt);
        public void RemoveAllCommandBuffers() => commandBuffers.Clear();
        public CommandBuffer[] GetCommandBuffers(CameraEvent evt) => commandBuffers.Of(evt);
        public int commandBufferCount => commandBuffers.Count;
        internal void Execute(CameraEvent evt) => commandBuffers.Execute(evt);

        public static void SetupCurrent(Camera cur) => current = cur;

        public void CopyFrom(Camera other)
        {
            fieldOfView = other.fieldOfView;
            nearClipPlane = other.nearClipPlane;
            farClipPlane = other.farClipPlane;
            orthographic = other.orthographic;
            orthographicSize = other.orthographicSize;
            depth = other.depth;
            cullingMask = other.cullingMask;
            clearFlags = other.clearFlags;
            backgroundColor = other.backgroundColor;
            targetTexture = other.targetTexture;
            rect = other.rect;
            depthTextureMode = other.depthTextureMode;
            explicitView = other.explicitView;
            explicitProjection = other.explicitProjection;
            explicitCulling = other.explicitCulling;
            explicitAspect = other.explicitAspect;
        }

        public void Reset()
        {
            ResetAspect();
            ResetWorldToCameraMatrix();
            ResetProjectionMatrix();
            ResetCullingMatrix();
        }

        public static float VerticalToHorizontalFieldOfView(float verticalFieldOfView, float aspectRatio) =>
            2 * Mathf.Rad2Deg * Mathf.Atan(Mathf.Tan(verticalFieldOfView * Mathf.Deg2Rad / 2) * aspectRatio);
        public static float HorizontalToVerticalFieldOfView(float horizontalFieldOfView, float aspectRatio) =>
            2 * Mathf.Rad2Deg * Mathf.Atan(Mathf.Tan(horizontalFieldOfView * Mathf.Deg2Rad / 2) / aspectRatio);
        public static float FocalLengthToFieldOfView(float focalLength, float sensorSize)
            => 2 * Mathf.Rad2Deg * Mathf.Atan(sensorSize / (2 * focalLength));
        public static float FieldOfViewToFocalLength(float fieldOfView, float sensorSize)
            => sensorSize / (2 * Mathf.Tan(fieldOfView * Mathf.Deg2Rad / 2));
    }
}
