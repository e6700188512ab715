using System.Runtime.InteropServices;
using UnityEngine;

namespace Rill
{
    /// <summary>Constants of one camera for every pass and draw of a fluid's surface. In a buffer, written as the camera's commands are recorded:
    /// a draw is submitted before that, and only then are the camera's matrices final.</summary>
    [GenerateHlsl("SurfaceView", ConstantBuffer = "RillSurfaceView")]
    [StructLayout(LayoutKind.Sequential)]
    struct SurfaceConstants
    {
        /// <summary>rows of each eye's matrix from world to clip space: y up, z 1 at the near plane, which is taken to be straight</summary>
        public EyeVectors surfaceClipX, surfaceClipY, surfaceClipZ, surfaceClipW;
        /// <summary>of each eye: where a ray through the center of the picture starts, world, and its change along x and y of the picture</summary>
        public EyeVectors rayOrigin, rayOriginX, rayOriginY;
        /// <summary>where it goes, 1 m along the view, and the change of that</summary>
        public EyeVectors rayDirection, rayDirectionX, rayDirectionY;
        /// <summary>of each eye: device depth = x + y / z with perspective, x + y z without; z, m, along the view. z: 1 without</summary>
        public EyeVectors surfaceDepths;
        /// <summary>of each eye, the scene's: device depth = x + dot(zw, picture) + y / z or y z; zw 0 where the near plane is straight</summary>
        public EyeVectors sceneDepths;
        /// <summary>of each eye: a point of the world is in front of it where the product with (point, 1) is above 0; (0, 0, 0, 1) where it is
        /// straight</summary>
        public EyeVectors nearPlanes;
        /// <summary>width and height of the picture in texels of the surface's textures, and one over them</summary>
        public Vector4 surfaceSize;
        /// <summary>what those textures hold of it, from their first texel on: its first texel, its width and height</summary>
        public Vector4 surfaceWindow;
        /// <summary>the same of the textures of rays, foam and spray, and of the copy of the scene</summary>
        public Vector4 foamSize, foamWindow;
        /// <summary>lowest x, y and highest x, y of the fluid's box on the picture, of both eyes; all 0: nothing is drawn</summary>
        public Vector4 pictureBounds;
        /// <summary>xy: width and height of what is in use of the scene's depth, texels; 0: all</summary>
        public Vector4 sceneSize;
        /// <summary>rgb 1/m</summary>
        public Vector4 absorption;
        /// <summary>rgb color, linear; w 1/m</summary>
        public Vector4 scattering;
        /// <summary>the same of each phase, where hasPhases is 1</summary>
        public PhaseVectors phaseAbsorption, phaseScattering;
        /// <summary>a row for each phase: 1 for itself and for those that it mixes with, else 0; phases 1 to 3, and phase 0 in w</summary>
        public PhaseVectors phaseGroups;
        /// <summary>x index of refraction, y reflectance at normal incidence, z roughness; w how far above itself it looks for a shadow, since
        /// it casts one, m</summary>
        public Vector4 surfaceOptics;
        /// <summary>linear</summary>
        public Vector4 foamColor;
        /// <summary>world, towards the light; w 1 where a light was chosen, 0 to take the pipeline's</summary>
        public Vector4 sunDirection;
        /// <summary>linear, intensity applied</summary>
        public Vector4 sunColor;
        /// <summary>x the stamp of this camera and frame, y cascades, z 1 where they are spheres; w unused</summary>
        public Vector4 shadowReceived;
        /// <summary>xyz towards the light whose shadow it is</summary>
        public Vector4 shadowLight;
        /// <summary>1 or 0</summary>
        public float receiveShadows;
        /// <summary>1 where each phase has a look of its own, 2 where they are of several materials too and have sharp borders, else 0: a keyword
        /// would double the variants</summary>
        public float hasPhases;
        /// <summary>factor of what is mirrored</summary>
        public float reflectionStrength;
        /// <summary>fills the last 16 bytes</summary>
        public float surfacePadding;

        /// <summary>One for each eye.</summary>
        public struct EyeVectors
        {
            public Vector4 left, right;

            public Vector4 this[int eye]
            {
                readonly get => eye == 0 ? left : right;
                set
                {
                    if (eye == 0)
                        left = value;
                    else
                        right = value;
                }
            }
        }

        /// <summary>One for each of <see cref="PhaseGrid.MaxPhases"/>.</summary>
        public struct PhaseVectors
        {
            public Vector4 first, second, third, fourth;

            public Vector4 this[int phase]
            {
                set
                {
                    if (phase == 0)
                        first = value;
                    else if (phase == 1)
                        second = value;
                    else if (phase == 2)
                        third = value;
                    else
                        fourth = value;
                }
            }
        }

        /// <summary>Sets the matrices and rays of the eyes.</summary>
        public void Set(in FluidViews views)
        {
            for (int eye = 0; eye < 2; eye++)
                Set(eye, views.ViewOf(eye < views.eyes ? eye : 0), views.ProjectionOf(eye < views.eyes ? eye : 0), views.camera);
            sceneSize = views.sceneSize;
        }

        // camera: whose planes are known, where the projection tilts the near one.
        void Set(int eye, Matrix4x4 view, Matrix4x4 projection, Camera camera)
        {
            bool isOrthographic = projection.m32 == 0f;
            bool isOblique = projection.m20 != 0f || projection.m21 != 0f;
            // The surface's own depth goes straight along the view in any case: what compares texels needs it.
            Vector4 straight = isOblique ? StraightDepth(isOrthographic, camera.nearClipPlane, camera.farClipPlane) : projection.GetRow(2);
            Matrix4x4 clip = projection;
            clip.SetRow(2, 0.5f * (projection.GetRow(3) - straight));       // z of -1 to 1 becomes 1 to 0
            clip *= view;
            surfaceClipX[eye] = clip.GetRow(0);
            surfaceClipY[eye] = clip.GetRow(1);
            surfaceClipZ[eye] = clip.GetRow(2);
            surfaceClipW[eye] = clip.GetRow(3);
            surfaceDepths[eye] = isOrthographic ? new Vector4(0.5f - 0.5f * straight.w, 0.5f * straight.z, 1f, 0f)
                : new Vector4(0.5f + 0.5f * straight.z, -0.5f * straight.w, 0f, 0f);
            nearPlanes[eye] = isOblique ? view.transpose * (projection.GetRow(2) + projection.GetRow(3)) : new Vector4(0f, 0f, 0f, 1f);

            // From (x, y, depth along the view, 1), x and y times that depth with perspective, to the view.
            Matrix4x4 toView = projection;
            toView.SetRow(2, new Vector4(0f, 0f, -1f, 0f));
            toView.SetRow(3, new Vector4(0f, 0f, 0f, 1f));
            toView = toView.inverse;
            Vector4 x = toView.GetColumn(0), y = toView.GetColumn(1), along = toView.GetColumn(2), from = toView.GetColumn(3);
            Vector4 depth = -0.5f * projection.GetRow(2);
            sceneDepths[eye] = isOrthographic
                ? new Vector4(0.5f + Vector4.Dot(depth, from), Vector4.Dot(depth, along), Vector4.Dot(depth, x), Vector4.Dot(depth, y))
                : new Vector4(0.5f + Vector4.Dot(depth, along), depth.w, Vector4.Dot(depth, x), Vector4.Dot(depth, y));

            Matrix4x4 toWorld = view.inverse;
            x = toWorld * x;
            y = toWorld * y;
            rayOrigin[eye] = toWorld * from;
            rayOriginX[eye] = isOrthographic ? x : Vector4.zero;
            rayOriginY[eye] = isOrthographic ? y : Vector4.zero;
            rayDirection[eye] = toWorld * along;
            rayDirectionX[eye] = isOrthographic ? Vector4.zero : x;
            rayDirectionY[eye] = isOrthographic ? Vector4.zero : y;
        }

        static Vector4 StraightDepth(bool isOrthographic, float near, float far)
        {
            float inverse = 1f / (far - near);
            return isOrthographic ? new Vector4(0f, 0f, -2f * inverse, -(far + near) * inverse)
                : new Vector4(0f, 0f, -(far + near) * inverse, -2f * far * near * inverse);
        }
    }
}
