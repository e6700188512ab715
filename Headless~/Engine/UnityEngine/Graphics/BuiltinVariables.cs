using System;

namespace UnityEngine.Headless
{
    /// <summary>The shader variables that Unity sets by itself, written into the globals.</summary>
    internal static class BuiltinVariables
    {
        static int Id(string name) => PropertyNames.ToId(name);

        static readonly int
            objectToWorld = Id("unity_ObjectToWorld"), worldToObject = Id("unity_WorldToObject"),
            worldTransformParams = Id("unity_WorldTransformParams"),
            matrixV = Id("unity_MatrixV"), matrixInvV = Id("unity_MatrixInvV"), matrixP = Id("glstate_matrix_projection"),
                matrixVP = Id("unity_MatrixVP"),
            matrixInvP = Id("unity_MatrixInvP"), matrixInvVP = Id("unity_MatrixInvVP"),
            cameraProjection = Id("unity_CameraProjection"), cameraInvProjection = Id("unity_CameraInvProjection"),
            cameraToWorld = Id("unity_CameraToWorld"), worldToCamera = Id("unity_WorldToCamera"),
            cameraPosition = Id("_WorldSpaceCameraPos"), projectionParams = Id("_ProjectionParams"), screenParams = Id("_ScreenParams"),
            zBufferParams = Id("_ZBufferParams"), orthoParams = Id("unity_OrthoParams"), clipPlanes = Id("unity_CameraWorldClipPlanes"),
            time = Id("_Time"), sinTime = Id("_SinTime"), cosTime = Id("_CosTime"), deltaTime = Id("unity_DeltaTime"),
            lightPosition = Id("_WorldSpaceLightPos0"), lightColor = Id("_LightColor0"), lightAttenuation = Id("unity_LightAtten"),
            ambientSky = Id("unity_AmbientSky"), ambientEquator = Id("unity_AmbientEquator"), ambientGround = Id("unity_AmbientGround"),
                ambient = Id("glstate_lightmodel_ambient"),
            shAr = Id("unity_SHAr"), shAg = Id("unity_SHAg"), shAb = Id("unity_SHAb"), shBr = Id("unity_SHBr"), shBg = Id("unity_SHBg"),
                shBb = Id("unity_SHBb"), shC = Id("unity_SHC"),
            fogColor = Id("unity_FogColor"), fogParams = Id("unity_FogParams"), baseCommand = Id("unity_BaseCommandID"),
            stereoV = Id("unity_StereoMatrixV"), stereoInvV = Id("unity_StereoMatrixInvV"), stereoP = Id("unity_StereoMatrixP"),
                stereoInvP = Id("unity_StereoMatrixInvP"), stereoVP = Id("unity_StereoMatrixVP");

        static readonly (FogMode, string)[] fogKeywords = { (FogMode.Linear, "FOG_LINEAR"), (FogMode.Exponential, "FOG_EXP"),
            (FogMode.ExponentialSquared, "FOG_EXP2") };

        static PropertyTable Globals => Shader.Globals;

        public static void SetObject(in Matrix4x4 toWorld)
        {
            Globals.SetMatrix(objectToWorld, toWorld);
            Globals.SetMatrix(worldToObject, toWorld.inverse);
            Globals.SetVector(worldTransformParams, new Vector4(0, 0, 0, toWorld.determinant < 0 ? -1 : 1));
        }

        /// <summary>Sets the index in an indirect draw of several commands.</summary>
        public static void SetCommand(int index) => Globals.SetInt(baseCommand, index);

        public static void SetViewProjection(in Matrix4x4 view, in Matrix4x4 projection)
        {
            RenderState.View = view;
            RenderState.Projection = projection;
            Matrix4x4 gpu = GL.GetGPUProjectionMatrix(projection, renderIntoTexture: !isUpright);
            Matrix4x4 both = gpu * view;
            Globals.SetMatrix(matrixV, view);
            Globals.SetMatrix(matrixInvV, view.inverse);
            Globals.SetMatrix(matrixP, gpu);
            Globals.SetMatrix(matrixInvP, gpu.inverse);
            Globals.SetMatrix(matrixVP, both);
            Globals.SetMatrix(matrixInvVP, both.inverse);
        }

        static bool isUpright;
        static Vector4 planes;      // what _ProjectionParams says of the camera's near and far plane

        /// <summary>After another target has been set: whether y is flipped depends on it.</summary>
        public static void FollowTarget()
        {
            if (isUpright == RenderState.IsUpright)
                return;
            isUpright = !isUpright;
            SetViewProjection(RenderState.View, RenderState.Projection);
            SetProjectionParams();
        }

        // x: -1 where y is flipped
        static void SetProjectionParams() => Globals.SetVector(projectionParams, new Vector4(isUpright ? 1 : -1, planes.y, planes.z, planes.w));

        static readonly Matrix4x4[] eyeViews = new Matrix4x4[2], eyeInverseViews = new Matrix4x4[2], eyeProjections = new Matrix4x4[2],
            eyeInverseProjections = new Matrix4x4[2], eyeViewProjections = new Matrix4x4[2];

        /// <summary>Sets two eyes in one pass, left first.</summary>
        public static void SetStereo(Matrix4x4[] views, Matrix4x4[] projections)
        {
            for (int eye = 0; eye < 2; eye++)
            {
                eyeViews[eye] = views[eye];
                eyeInverseViews[eye] = views[eye].inverse;
                eyeProjections[eye] = GL.GetGPUProjectionMatrix(projections[eye], renderIntoTexture: true);
                eyeInverseProjections[eye] = eyeProjections[eye].inverse;
                eyeViewProjections[eye] = eyeProjections[eye] * views[eye];
            }
            Globals.SetArray(stereoV, PropertyKind.Matrix, eyeViews, 2);
            Globals.SetArray(stereoInvV, PropertyKind.Matrix, eyeInverseViews, 2);
            Globals.SetArray(stereoP, PropertyKind.Matrix, eyeProjections, 2);
            Globals.SetArray(stereoInvP, PropertyKind.Matrix, eyeInverseProjections, 2);
            Globals.SetArray(stereoVP, PropertyKind.Matrix, eyeViewProjections, 2);
        }

        public static void SetCamera(Camera camera, int width, int height)
        {
            Matrix4x4 view = camera.worldToCameraMatrix, projection = camera.projectionMatrix;
            SetViewProjection(view, projection);

            // Unity's camera space for these two is left-handed (z forward), unlike the view matrix.
            Matrix4x4 toWorld = camera.cameraToWorldMatrix * Matrix4x4.Scale(new Vector3(1, 1, -1));
            Globals.SetMatrix(cameraProjection, projection);
            Globals.SetMatrix(cameraInvProjection, projection.inverse);
            Globals.SetMatrix(cameraToWorld, toWorld);
            Globals.SetMatrix(worldToCamera, toWorld.inverse);

            float near = camera.nearClipPlane, far = camera.farClipPlane;
            Globals.SetVector(cameraPosition, camera.transform.position);
            planes = new Vector4(0, near, far, 1 / far);
            SetProjectionParams();
            Globals.SetVector(screenParams, new Vector4(width, height, 1 + 1f / width, 1 + 1f / height));
            float x = far / near - 1;
            Globals.SetVector(zBufferParams, new Vector4(x, 1, x / far, 1 / far));         // reversed Z
            Globals.SetVector(orthoParams, new Vector4(camera.orthographicSize * camera.aspect, camera.orthographicSize, 0,
            camera.orthographic ? 1 : 0));
        }

        public static void SetTime()
        {
            float t = Time.timeSinceLevelLoad, dt = Time.deltaTime, smooth = Time.smoothDeltaTime;
            Globals.SetVector(time, new Vector4(t / 20, t, t * 2, t * 3));
            Globals.SetVector(sinTime, new Vector4(Mathf.Sin(t / 8), Mathf.Sin(t / 4), Mathf.Sin(t / 2), Mathf.Sin(t)));
            Globals.SetVector(cosTime, new Vector4(Mathf.Cos(t / 8), Mathf.Cos(t / 4), Mathf.Cos(t / 2), Mathf.Cos(t)));
            Globals.SetVector(deltaTime, new Vector4(dt, dt > 0 ? 1 / dt : 0, smooth, smooth > 0 ? 1 / smooth : 0));
        }

        public static void SetSun()
        {
            Light sun = Light.MainDirectional();
            Vector4 position = new Vector4(0, 0, 1, 0), color = Vector4.zero;
            if (sun is object)
            {
                Vector3 toLight = -sun.transform.forward;
                position = new Vector4(toLight.x, toLight.y, toLight.z, 0);
                color = Linear(sun.color) * sun.intensity;
            }
            Globals.SetVector(lightPosition, position);
            Globals.SetVector(lightColor, color);
            Globals.SetVector(lightAttenuation, new Vector4(0, 0, 1, 0));

        }

        public static void SetAmbient()
        {
            Vector4 sky = Linear(RenderSettings.ambientSkyColor), equator = Linear(RenderSettings.ambientEquatorColor),
                ground = Linear(RenderSettings.ambientGroundColor);
            if (RenderSettings.ambientMode != Rendering.AmbientMode.Trilight)
                equator = ground = sky;
            Globals.SetVector(ambientSky, sky);
            Globals.SetVector(ambientEquator, equator);
            Globals.SetVector(ambientGround, ground);
            Globals.SetVector(ambient, sky);

            if (RenderSettings.ambientMode == Rendering.AmbientMode.Skybox && EnvironmentLighting.Harmonics != null)
                SetSkyHarmonics();
            else
                SetGradient();

            foreach ((FogMode mode, string keyword) in fogKeywords)
                GlobalKeywords.Set.Set(keyword, RenderSettings.fog && RenderSettings.fogMode == mode);
            Globals.SetVector(fogColor, Linear(RenderSettings.fogColor));
            float d = RenderSettings.fogDensity, span = Math.Max(1e-6f, RenderSettings.fogEndDistance - RenderSettings.fogStartDistance);
            Globals.SetVector(fogParams, new Vector4(d / Mathf.Sqrt(Mathf.Log(2)), d / Mathf.Log(2), -1 / span,
                RenderSettings.fogEndDistance / span));
        }

        static void SetSkyHarmonics()
        {
            float intensity = RenderSettings.ambientIntensity;
            EnvironmentLighting.ShaderHarmonics(0, intensity, out Vector4 a, out Vector4 b, out float red);
            Globals.SetVector(shAr, a);
            Globals.SetVector(shBr, b);
            EnvironmentLighting.ShaderHarmonics(1, intensity, out a, out b, out float green);
            Globals.SetVector(shAg, a);
            Globals.SetVector(shBg, b);
            EnvironmentLighting.ShaderHarmonics(2, intensity, out a, out b, out float blue);
            Globals.SetVector(shAb, a);
            Globals.SetVector(shBb, b);
            Globals.SetVector(shC, new Vector4(red, green, blue, 1));
        }

        static void SetGradient()
        {
            // Linear in a gamma project too.
            bool isFlat = RenderSettings.ambientMode != Rendering.AmbientMode.Trilight;
            Vector4 sky = RenderSettings.ambientSkyColor.linear, equator = isFlat ? sky : (Vector4)RenderSettings.ambientEquatorColor.linear,
                ground = isFlat ? sky : (Vector4)RenderSettings.ambientGroundColor.linear;
            // Ambient light as constant and linear harmonics in y: what ShadeSH9 of a lit shader evaluates.
            Vector4 mean = (sky + equator * 2 + ground) / 4, slope = (sky - ground) / 2;
            Globals.SetVector(shAr, new Vector4(0, slope.x, 0, mean.x));
            Globals.SetVector(shAg, new Vector4(0, slope.y, 0, mean.y));
            Globals.SetVector(shAb, new Vector4(0, slope.z, 0, mean.z));
            Globals.SetVector(shBr, Vector4.zero);
            Globals.SetVector(shBg, Vector4.zero);
            Globals.SetVector(shBb, Vector4.zero);
            Globals.SetVector(shC, Vector4.zero);
        }

        static Vector4 Linear(Color color) => Player.LinearColorSpace ? (Vector4)color.linear : (Vector4)color;
    }
}
