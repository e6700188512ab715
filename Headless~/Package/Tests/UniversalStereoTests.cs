using System;
using System.Reflection;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>In URP each of two eyes in one pass sees the water that a camera there sees.</summary>
    public class UniversalStereoTests : StereoSurfaceFixture
    {
        // Line of ViewsOf in UniversalSurfaces.
        const string Line = "views.width = Mathf.Max((int)(views.width * scale), 1);";

        void Build(string version) => Build(PipelineKind.Universal, version);

        [TestCase("14", Refracting)]
        [TestCase("14", Blended)]
        [TestCase("14", Milky)]
        [TestCase("14", Foamy)]
        [TestCase("17", Refracting)]
        [TestCase("17", Foamy)]
        [TestCase("17", Sunlit)]
        [TestCase("17 by Execute", Refracting)]
        [TestCase("17.3", Refracting)]
        public void Each_eye_sees_what_a_camera_there_sees(string version, string look)
        {
            Build(version);
            Arrange(look);
            AssertEachEyeSeesWhatACameraThereSees();
        }

        [Test]
        public void They_do_at_a_scale_of_the_headsets_textures([Values("14", "17")] string version)
        {
            Build(version);
            Set(pipeline.Asset, "renderScale", 0.5f);
            Arrange(Refracting);
            AssertEachEyeSeesWhatACameraThereSees();
        }

        // The water's own textures follow what the camera says: Low makes them as large as those of the camera with one eye.
        int UnlikeWhereTheHeadsetsTexturesAreSmallerThanTheCameraSays(Action build)
        {
            build();
            // Both asks get one mesh.
            simulation.Results.Surface.Requesting += () => simulation.Results.Surface.RequestMesh(FluidSurface.CellOf(SurfaceQuality.Medium), BoxWalls.All);
            FieldInfo scale = pipeline["Unity.RenderPipelines.Core.Runtime"].GetType("UnityEngine.Experimental.Rendering.XRPass")
                .GetField("TextureScale", BindingFlags.Static | BindingFlags.NonPublic);
            scale.SetValue(null, 0.5f);
            try
            {
                Arrange(Refracting);
                Surface.Quality = SurfaceQuality.Low;
                Play(1);
                (int left, int right, _) = Compare(() =>
                {
                    Set(pipeline.Asset, "renderScale", 0.5f);
                    Surface.Quality = SurfaceQuality.Medium;
                });
                return Math.Max(left, right);
            }
            finally
            {
                scale.SetValue(null, 1f);
            }
        }

        [Test]
        public void They_do_where_the_headsets_textures_are_smaller_than_the_camera_says([Values("14", "17")] string version) =>
            Assert.That(UnlikeWhereTheHeadsetsTexturesAreSmallerThanTheCameraSays(() => Build(version)), Is.LessThanOrEqualTo(Few));

        [Test]
        public void What_the_camera_says_for_what_is_there_is_seen() =>
            Assert.That(UnlikeWhereTheHeadsetsTexturesAreSmallerThanTheCameraSays(() => BuildWithFault(PipelineKind.Universal, "17",
            "UniversalSurfaces.cs", Line, "if (views.eyes == 2) views.sceneSize = new Vector2(views.width, views.height); " + Line)),
            Is.GreaterThan(6 * Few));

        [Test]
        public void A_camera_that_is_kept_from_the_headset_draws_one_eye([Values("14", "17")] string version)
        {
            Build(version);
            Component data = camera.gameObject.AddComponent(
                pipeline.Asset.GetType().Assembly.GetType("UnityEngine.Rendering.Universal.UniversalAdditionalCameraData"));
            Set(data, "allowXRRendering", false);
            Arrange(Refracting);
            int shown = PixelsOfWaterOnTheScreen();
            Assert.That(Errors, Is.Empty);
            Assert.That(shown, Is.GreaterThan(Width * Height / 20));
        }

        [Test]
        public void Each_eye_in_a_pass_of_its_own_does_too([Values("14", "17", "17 by Execute", "17.3")] string version)
        {
            Build(version);
            DrawEyesOneAfterTheOther();
            Arrange(Refracting);
            AssertEachEyeSeesWhatACameraThereSees();
        }

        [TestCase("SurfacePass.cs", "views.SetEye(eye, camera.GetViewMatrix(eye), camera.GetProjectionMatrix(eye));",
            "views.SetEye(eye, camera.GetViewMatrix(0), camera.GetProjectionMatrix(0));", TestName = "One_eyes_matrix_for_both_is_seen")]
        [TestCase("UniversalSurfaces.cs", Line, Line + "views.eyes = 1;", TestName = "Textures_of_one_slice_are_seen")]
        public void A_fault_in_the_adapter_is_seen(string file, string line, string instead)
        {
            BuildWithFault(PipelineKind.Universal, "17", file, line, instead);
            Arrange(Refracting);
            AssertTheFaultIsSeen();
        }

        [TestCase("_SceneColor.SampleLevel(rill_linear_clamp_sampler, float3(uv, eyeIndex), 0)",
            "_SceneColor.SampleLevel(rill_linear_clamp_sampler, float3(uv, 0), 0)", TestName = "The_scene_of_the_other_eye_is_seen")]
        [TestCase("_FoamWindow.zw - 1.0), eyeIndex, 0);", "_FoamWindow.zw - 1.0), 0, 0);", TestName = "The_rays_of_the_other_eye_are_seen")]
        [TestCase("int4 texel = int4(SurfaceTexel(picture), eyeIndex, 0);", "int4 texel = int4(SurfaceTexel(picture), 0, 0);",
            TestName = "The_faces_of_the_other_eye_are_seen")]
        public void A_wrong_slice_is_seen(string line, string instead)
        {
            Build("17");
            Arrange(Refracting);
            ShadeWithFault(line, instead);
            Play(2);
            AssertTheFaultIsSeen();
        }
    }
}
