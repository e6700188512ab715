using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>
    /// The shadow of the main directional light as the Built-in pipeline gives it to forward passes on Direct3D 11: casters draw
    /// their ShadowCaster pass into a map from the light and into the camera's depth, and both become a mask on the screen
    /// (_ShadowMapTexture), which opaque receivers read under SHADOWS_SCREEN. One map without cascades, fitted to what is visible.
    /// </summary>
    internal static class ScreenShadows
    {
        public const string Keyword = "SHADOWS_SCREEN";
        const string EyesKeyword = "EYES";

        static readonly int
            mask = Shader.PropertyToID("_ShadowMapTexture"), map = Shader.PropertyToID("_ShadowMap"),
            mapSize = Shader.PropertyToID("_ShadowMapSize"), bias = Shader.PropertyToID("unity_LightShadowBias"),
            data = Shader.PropertyToID("_LightShadowData"), worldToShadow = Shader.PropertyToID("unity_WorldToShadow"),
            splitSpheres = Shader.PropertyToID("unity_ShadowSplitSpheres"), splitRadii = Shader.PropertyToID("unity_ShadowSplitSqRadii"),
                splitsFar = Shader.PropertyToID("_LightSplitsFar"),
            fadeCenter = Shader.PropertyToID("unity_ShadowFadeCenterAndType"), eye = Shader.PropertyToID("_Eye");

        static readonly Vector3[] corners = new Vector3[8];
        static readonly Matrix4x4[] worldToShadows = new Matrix4x4[4];
        static readonly Vector4[] spheres = new Vector4[4];
        static RenderTexture mapTexture, maskTexture;
        static Material resolve;

        /// <summary>Whether the main light casts a shadow of anything.</summary>
        /// <param name="all">What the camera's layers hold, seen or not.</param>
        public static bool AreWanted(IReadOnlyList<QueuedDraw> all)
        {
            Light light = Light.MainDirectional();
            if (light is null || light.shadows == LightShadows.None || light.shadowStrength <= 0
                || QualitySettings.shadows == ShadowQuality.Disable || !Casts(all))
                return false;
            resolve = resolve != null ? resolve : BuiltinResources.FindShader?.Invoke("Hidden/Internal-ScreenSpaceShadows") is Shader shader
                ? new Material(shader) { hideFlags = HideFlags.HideAndDontSave } : null;
            return resolve != null;
        }

        /// <summary>Draws the map and the mask, after the camera's depth; with two eyes in one pass, the mask has a slice for each.</summary>
        /// <param name="seen">What the camera sees.</param>
        /// <returns>False where no shadow can be seen.</returns>
        public static bool Draw(Camera camera, IReadOnlyList<QueuedDraw> all, IReadOnlyList<QueuedDraw> seen)
        {
            Light light = Light.MainDirectional();
            Matrix4x4 view = Matrix4x4.Scale(new Vector3(1, 1, -1)) * Matrix4x4.Rotate(light.transform.rotation).inverse;
            if (!Fit(camera, view, QualitySettings.shadowDistance, all, seen, out Matrix4x4 projection, out float width, out float range))
                return false;
            int texels = 512 << (int)QualitySettings.shadowResolution;
            int eyes = camera.stereoEnabled ? 2 : 1, pixels = camera.pixelWidth;
            Need(ref mapTexture, "Shadow map", texels, texels, GraphicsFormat.None);
            Need(ref maskTexture, "Shadow mask", pixels, camera.pixelHeight, GraphicsFormat.R8_UNorm, eyes);

            // Unity's defaults, 0.05 and 0.4, give a depth of three texels and a normal of less than one.
            float texel = width / texels;
            Shader.Globals.SetVector(bias, new Vector4(-light.shadowBias * 60 * texel / range, 1, light.shadowNormalBias * texel, 0));
            RenderState.SetTarget(mapTexture);
            BuiltinVariables.SetViewProjection(view, projection);
            RenderState.Clear(true, false, default, 1);
            foreach (QueuedDraw draw in all)
                if (draw.Shadows != ShadowCastingMode.Off)
                    ShadowCasters.Draw(draw);
            light.Execute(LightEvent.AfterShadowMap);       // the map is the active target

            Shader.Globals.SetVector(bias, Vector4.zero);
            Matrix4x4 toTexture = Matrix4x4.Translate(new Vector3(0.5f, 0.5f, 0)) * Matrix4x4.Scale(new Vector3(0.5f, 0.5f, 1));
            // The first cascade holds all.
            worldToShadows[0] = toTexture * GL.GetGPUProjectionMatrix(projection, renderIntoTexture: false) * view;
            spheres[0] = camera.transform.position;
            Shader.Globals.SetArray(splitSpheres, PropertyKind.Vector, spheres, spheres.Length);
            Shader.Globals.SetVector(splitRadii, new Vector4(float.MaxValue, -1, -1, -1));
            Shader.Globals.SetVector(splitsFar, new Vector4(float.MaxValue, 0, 0, 0));
            Shader.Globals.SetVector(fadeCenter, spheres[0]);
            Shader.Globals.SetArray(worldToShadow, PropertyKind.Matrix, worldToShadows, worldToShadows.Length);
            Shader.Globals.SetVector(data, new Vector4(1 - light.shadowStrength, 0, 0, 0));
            Shader.Globals.SetVector(mapSize,
                new Vector4(texels, light.shadows == LightShadows.Soft && QualitySettings.shadows == ShadowQuality.All ? 1 : 0,
                QualitySettings.shadowDistance, 0));
            Shader.Globals.SetTexture(map, mapTexture, RenderTextureSubElement.Depth);
            // LightEvent.BeforeScreenspaceMask of the scripting reference (2019.2): the mask is the target and the parameters of the
            // cascades are set.
            BuiltinVariables.SetCamera(camera, pixels, camera.pixelHeight);
            RenderState.SetTarget(maskTexture);
            light.Execute(LightEvent.BeforeScreenspaceMask);
            if (eyes > 1)
                resolve.EnableKeyword(EyesKeyword);
            else
                resolve.DisableKeyword(EyesKeyword);
            for (int slice = 0; slice < eyes; slice++)
            {
                BuiltinVariables.SetCamera(camera, pixels, camera.pixelHeight);
                if (eyes > 1)
                    BuiltinVariables.SetViewProjection(StereoView.Views[slice], StereoView.Projections[slice]);
                resolve.SetFloat(eye, slice);
                RenderState.SetTarget(maskTexture, 0, slice);
                Drawing.DrawPass(new DrawCall { Call = "screen-space shadows", Material = resolve, Matrix = Matrix4x4.identity,
                    Topology = MeshTopology.Triangles, Count = 3, Instances = 1 }, 0);
            }
            Shader.Globals.SetTexture(mask, maskTexture);
            return true;
        }

        static bool Casts(IReadOnlyList<QueuedDraw> all)
        {
            foreach (QueuedDraw draw in all)
                if (draw.Shadows != ShadowCastingMode.Off && ShadowCasters.PassOf(draw.Call.Material) >= 0)
                    return true;
            return false;
        }

        /// <summary>The light's view of what a camera sees, for a map of one cascade; false where nothing casts or receives.</summary>
        public static bool TryFit(Camera camera, Light light, float distance, IReadOnlyList<QueuedDraw> all, IReadOnlyList<QueuedDraw> seen,
            out Matrix4x4 view, out Matrix4x4 projection, out float width)
        {
            view = Matrix4x4.Scale(new Vector3(1, 1, -1)) * Matrix4x4.Rotate(light.transform.rotation).inverse;
            (projection, width) = (default, 0);
            return Casts(all) && Fit(camera, view, distance, all, seen, out projection, out width, out _);
        }

        // Across: where the camera sees something within the shadow distance. Along the light: from the first caster to the last receiver.
        static bool Fit(Camera camera, in Matrix4x4 view, float distance, IReadOnlyList<QueuedDraw> all, IReadOnlyList<QueuedDraw> seen,
            out Matrix4x4 projection, out float width, out float range)
        {
            projection = default;
            width = range = 0;
            float far = Math.Min(camera.farClipPlane, distance);
            for (int i = 0; i < 8; i++)
                corners[i] = camera.ViewportToWorldPoint(new Vector3(i & 1, i >> 1 & 1, i < 4 ? camera.nearClipPlane : far));
            Bounds frustum = new Bounds(view.MultiplyPoint3x4(corners[0]), Vector3.zero);
            for (int i = 1; i < 8; i++)
                frustum.Encapsulate(view.MultiplyPoint3x4(corners[i]));
            if (!Union(view, seen, false, out Bounds receivers) || !Union(view, all, true, out Bounds casters))
                return false;

            Vector3 min = Vector3.Max(frustum.min, receivers.min), max = Vector3.Min(frustum.max, receivers.max);
            if (min.x >= max.x || min.y >= max.y)
                return false;
            float margin = 0.01f * Math.Max(max.x - min.x, max.y - min.y), nearest = Math.Max(max.z, casters.max.z);
            width = Math.Max(max.x - min.x, max.y - min.y) + 2 * margin;
            range = nearest - min.z + 2 * margin;
            float x = (min.x + max.x) / 2, y = (min.y + max.y) / 2;
            projection = Matrix4x4.Ortho(x - width / 2, x + width / 2, y - width / 2, y + width / 2, -nearest - margin, -min.z + margin);
            return true;
        }

        static bool Union(in Matrix4x4 view, IReadOnlyList<QueuedDraw> draws, bool casting, out Bounds union)
        {
            union = default;
            bool any = false;
            foreach (QueuedDraw draw in draws)
            {
                if (!draw.HasBounds || casting && draw.Shadows == ShadowCastingMode.Off)
                    continue;
                Bounds own = Culling.Transform(draw.Bounds, view);
                if (any)
                    union.Encapsulate(own);
                else
                    union = own;
                any = true;
            }
            return any;
        }

        static void Need(ref RenderTexture texture, string name, int width, int height, GraphicsFormat color, int slices = 1)
        {
            if (texture is object && texture.width == width && texture.height == height && texture.volumeDepth == slices)
                return;
            if (texture is object)
                Object.DestroyImmediate(texture, true);
            texture = new RenderTexture(new RenderTextureDescriptor(width, height, color, color == GraphicsFormat.None
                ? GraphicsFormat.D32_SFloat : GraphicsFormat.None)
            {
                dimension = slices > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D, volumeDepth = slices,
            })
            {
                name = name, IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave,
            };
            texture.Create();
        }

        public static void Reset()
        {
            foreach (Object one in new Object[] { mapTexture, maskTexture, resolve })
                if (one is object)
                    Object.DestroyImmediate(one, true);
            mapTexture = maskTexture = null;
            resolve = null;
        }
    }
}
