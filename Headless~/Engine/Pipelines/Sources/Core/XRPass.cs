using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>The eyes that a pass over the frame draws: none without a headset, two in one pass, or one in each of two.</summary>
    /// <remarks>
    /// Read in SRP Core 17.2.0, Runtime/XR: a camera that draws on a texture, that is not a game's or whose component forbids it has no headset
    /// (XRLayout.AddCamera); between StartSinglePass and StopSinglePass every draw that is not indirect has the instances of both eyes, and every
    /// program the keyword (XRPass).
    /// </remarks>
    public class XRPass
    {
        internal static readonly XRPass Empty = new XRPass();

        /// <summary>Scale of the headset's textures over a camera's size: nothing tells that a device keeps to it.</summary>
        internal static float TextureScale = 1;

        Matrix4x4[] views, projections;

        public bool enabled => views != null;
        public int viewCount => views?.Length ?? 0;
        public bool singlePassEnabled => viewCount > 1;
        public int multipassId { get; private set; }

        /// <summary>Descriptor of the headset's textures, with a slice for each eye.</summary>
        public RenderTextureDescriptor renderTargetDesc
        {
            get
            {
                RenderTextureDescriptor desc = StereoView.Eyes.descriptor;
                if (!singlePassEnabled)
                    (desc.dimension, desc.volumeDepth) = (TextureDimension.Tex2D, 1);
                (desc.width, desc.height) = (System.Math.Max((int)(desc.width * TextureScale), 1),
                    System.Math.Max((int)(desc.height * TextureScale), 1));
                return desc;
            }
        }

        public Matrix4x4 GetViewMatrix(int viewIndex = 0) => views[viewIndex];
        public Matrix4x4 GetProjMatrix(int viewIndex = 0) => projections[viewIndex];

        /// <param name="isAllowed">By the camera's component.</param>
        internal static XRPass Of(Camera camera, bool isAllowed)
        {
            if (!isAllowed || !camera.stereoEnabled || camera.cameraType != CameraType.Game && camera.cameraType != CameraType.VR)
                return Empty;
            StereoView.Begin(camera);
            return new XRPass { views = (Matrix4x4[])StereoView.Views.Clone(), projections = (Matrix4x4[])StereoView.Projections.Clone() };
        }

        /// <summary>All of a camera's frame.</summary>
        internal static XRPass[] AllOf(Camera camera, bool isAllowed)
        {
            XRPass both = Of(camera, isAllowed);
            if (!both.enabled || !StereoView.IsMultiPass)
                return new[] { both };
            var passes = new XRPass[2];
            for (int eye = 0; eye < 2; eye++)
                passes[eye] = new XRPass { views = new[] { both.views[eye] }, projections = new[] { both.projections[eye] }, multipassId = eye };
            return passes;
        }

        internal void StartSinglePass()
        {
            if (singlePassEnabled)
                StereoView.SetInstancing(true);
        }

        internal void StopSinglePass()
        {
            if (singlePassEnabled)
                StereoView.SetInstancing(false);
        }
    }
}
