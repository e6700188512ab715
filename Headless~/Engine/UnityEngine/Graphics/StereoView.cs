using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>
    /// Two eyes in one pass, as Unity draws them by single-pass instancing: a texture array with a slice for each eye, the matrices
    /// of both, twice the instances of every draw that is not indirect, and the keyword. Beside each other on the screen in the end.
    /// </summary>
    internal static class StereoView
    {
        public const string Keyword = "STEREO_INSTANCING_ON";
        const float EyeDistance = 0.064f;       // m

        /// <summary>Whether scriptable pipelines draw the eyes one after the other (XR's Multi Pass).</summary>
        public static bool IsMultiPass;

        public static readonly Matrix4x4[] Views = new Matrix4x4[2], Projections = new Matrix4x4[2];
        static readonly int eyesId = Shader.PropertyToID("_Eyes");
        static RenderTexture eyes;
        static Material sideBySide;

        public static RenderTexture Eyes => eyes;

        /// <summary>Left first; each eye has half of the screen's width.</summary>
        public static void Begin(Camera camera)
        {
            int width = Player.ScreenWidth / 2, height = Player.ScreenHeight;
            if (eyes is object && (eyes.width != width || eyes.height != height))
                Reset();
            if (eyes is null)
            {
                RenderTexture screen = ScreenTarget.Texture;
                eyes = new RenderTexture(new RenderTextureDescriptor(width, height, screen.graphicsFormat,
                    screen.depthStencilFormat) { dimension = TextureDimension.Tex2DArray, volumeDepth = 2 })
                {
                    name = "Eyes", IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave,
                };
                eyes.Create();
            }
            for (int eye = 0; eye < 2; eye++)
            {
                Views[eye] = ViewOf(camera, eye);
                Projections[eye] = ProjectionOf(camera);
            }
            BuiltinVariables.SetStereo(Views, Projections);
        }

        public static Matrix4x4 ViewOf(Camera camera, int eye)
            => Matrix4x4.Translate(new Vector3((0.5f - eye) * EyeDistance, 0, 0)) * camera.worldToCameraMatrix;

        public static Matrix4x4 ProjectionOf(Camera camera)
        {
            return camera.orthographic ? camera.projectionMatrix
                : Matrix4x4.Perspective(camera.fieldOfView, (float)camera.pixelWidth / camera.pixelHeight, camera.nearClipPlane,
                camera.farClipPlane);
        }

        /// <summary>Draws from here on are for both eyes, until it is off.</summary>
        /// <param name="target">With a slice for each eye; null for what the camera draws.</param>
        public static void SetSinglePass(bool isOn, RenderTexture target = null)
        {
            SetInstancing(isOn);
            if (isOn)
                RenderState.SetTarget(target is object ? target : eyes, 0, RenderTargetIdentifier.AllDepthSlices);
        }

        /// <summary>Sets instancing without a target: of a scriptable pipeline's own (XRPass.StartSinglePass, StopSinglePass).</summary>
        public static void SetInstancing(bool isOn)
        {
            RenderState.InstanceMultiplier = isOn ? 2 : 1;
            GlobalKeywords.Set.Set(Keyword, isOn);
        }

        /// <summary>For what has no variant for two eyes: one after the other.</summary>
        public static void SetEye(int eye)
        {
            RenderState.SetTarget(eyes, 0, eye);
            BuiltinVariables.SetViewProjection(Views[eye], Projections[eye]);
        }

        public static void Show()
        {
            sideBySide = sideBySide != null ? sideBySide
                : new Material(BuiltinResources.FindShader("Hidden/Headless/SideBySide")) { hideFlags = HideFlags.HideAndDontSave };
            Shader.Globals.SetTexture(eyesId, eyes);
            RenderState.SetTarget(ScreenTarget.Texture);
            Drawing.DrawPass(new DrawCall { Call = "two eyes", Material = sideBySide, Matrix = Matrix4x4.identity,
                Topology = MeshTopology.Triangles, Count = 3, Instances = 1 }, 0);
        }

        public static void Reset()
        {
            if (eyes is object)
                Object.DestroyImmediate(eyes, true);
            eyes = null;
        }
    }
}
