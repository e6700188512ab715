using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Views of a camera in a frame, as the adapter of a render pipeline hands it to <see cref="FluidSurface"/>: one eye,
    /// or two in one pass.</summary>
    struct FluidViews
    {
        /// <summary>Whose textures are filled.</summary>
        public Camera camera;

        /// <summary>1, or 2 with two eyes in one pass: left first.</summary>
        public int eyes;

        /// <summary>From world to view, looking along -z; of one eye or of the left one.</summary>
        public Matrix4x4 view, rightView;

        /// <summary>Projection like Camera.projectionMatrix: z -1 to 1, y up, with the jitter of this frame.</summary>
        public Matrix4x4 projection, rightProjection;

        /// <summary>Size of the picture of one eye, pixels.</summary>
        public int width, height;

        /// <summary>Used part of the scene's depth texture, texels; zero for all, whose size the pipeline knows: with a headset, a
        /// camera does not.</summary>
        public Vector2 sceneSize;

        /// <summary>Whether the scene's textures are arrays with a slice for each eye.</summary>
        public bool sceneIsArray;

        /// <summary>Whether motion vectors of the surface are drawn: only where something asks for the camera's.</summary>
        public bool needsMotion;

        /// <summary>The light that is seen on the surface, where the pipeline's shaders cannot read it; null where they can.</summary>
        public Light? light;

        /// <summary>A directional light.</summary>
        public readonly struct Light
        {
            /// <summary>World, unit, towards it.</summary>
            public readonly Vector3 Direction;

            /// <summary>Linear, intensity applied; in HDRP, lux.</summary>
            public readonly Color Color;

            public Light(Vector3 direction, Color color)
            {
                Direction = direction;
                Color = color;
            }
        }

        /// <summary>View of an eye.</summary>
        /// <param name="eye">0 or 1.</param>
        public Matrix4x4 ViewOf(int eye) => eye == 0 ? view : rightView;

        /// <summary>Projection of an eye.</summary>
        /// <param name="eye">0 or 1.</param>
        public Matrix4x4 ProjectionOf(int eye) => eye == 0 ? projection : rightProjection;

        /// <summary>Sets the matrices that the camera draws with, which are final as it draws.</summary>
        /// <param name="eye">0 or 1.</param>
        public void SetEye(int eye, Matrix4x4 view, Matrix4x4 projection)
        {
            if (eye == 0)
                (this.view, this.projection) = (view, projection);
            else
                (rightView, rightProjection) = (view, projection);
        }

        /// <summary>Sets where the pipeline draws one eye in this pass.</summary>
        /// <param name="eye">0 or 1.</param>
        public void KeepEye(int eye)
        {
            SetEye(0, ViewOf(eye), ProjectionOf(eye));
            eyes = 1;
            sceneIsArray = false;
        }

        /// <summary>From world to clip space, z -1 to 1, of an eye.</summary>
        /// <param name="eye">0 or 1.</param>
        public Matrix4x4 WorldToClipOf(int eye) => ProjectionOf(eye) * ViewOf(eye);

        /// <summary>Returns the views of a camera as Unity has it: two eyes if it is stereo.</summary>
        /// <param name="isForHeadset">False where the pipeline draws one eye, whether the camera is stereo or not.</param>
        public static FluidViews Of(Camera camera, bool isForHeadset = true)
        {
            if (isForHeadset && camera.stereoEnabled)
                return new FluidViews
                {
                    camera = camera, eyes = 2, width = camera.pixelWidth, height = camera.pixelHeight, sceneIsArray = true,
                    view = camera.GetStereoViewMatrix(Camera.StereoscopicEye.Left),
                    projection = camera.GetStereoProjectionMatrix(Camera.StereoscopicEye.Left),
                    rightView = camera.GetStereoViewMatrix(Camera.StereoscopicEye.Right),
                    rightProjection = camera.GetStereoProjectionMatrix(Camera.StereoscopicEye.Right),
                };
            return new FluidViews
            {
                camera = camera, eyes = 1, view = camera.worldToCameraMatrix, projection = camera.projectionMatrix,
                width = camera.pixelWidth, height = camera.pixelHeight,
            };
        }
    }
}
