using Host.Pipelines;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>In HDRP each of two eyes in one pass sees the water that a camera there sees.</summary>
    public class HighDefinitionStereoTests : StereoSurfaceFixture
    {
        void Build(string version) => Build(PipelineKind.HighDefinition, version);

        [TestCase("14", Refracting)]
        [TestCase("14", Milky)]
        [TestCase("14", Foamy)]
        [TestCase("17", Refracting)]
        [TestCase("17", Sunlit)]
        [TestCase("17", Blended)]
        [TestCase("17", Foamy)]
        public void Each_eye_sees_what_a_camera_there_sees(string version, string look)
        {
            Build(version);
            Arrange(look);
            AssertEachEyeSeesWhatACameraThereSees();
        }

        [Test]
        public void Each_eye_in_a_pass_of_its_own_does_too([Values("14", "17")] string version)
        {
            Build(version);
            DrawEyesOneAfterTheOther();
            Arrange(Refracting);
            AssertEachEyeSeesWhatACameraThereSees();
        }

        [Test]
        public void A_camera_that_is_kept_from_the_headset_draws_one_eye([Values("14", "17")] string version)
        {
            Build(version);
            Component data = camera.gameObject.AddComponent(
                pipeline.Asset.GetType().Assembly.GetType("UnityEngine.Rendering.HighDefinition.HDAdditionalCameraData"));
            Set(data, "xrRendering", false);
            Arrange(Refracting);
            int shown = PixelsOfWaterOnTheScreen();
            Assert.That(Errors, Is.Empty);
            Assert.That(shown, Is.GreaterThan(Width * Height / 20));
        }

        [TestCase("views.rightView = views.view;", TestName = "In_HDRP_one_eyes_matrix_for_both_is_seen")]
        [TestCase("views.eyes = 1;", TestName = "In_HDRP_textures_of_one_slice_are_seen")]
        public void A_fault_in_the_adapter_is_seen(string added)
        {
            const string line = "views.width = Mathf.Max(seen.actualWidth, 1);";
            BuildWithFault(PipelineKind.HighDefinition, "17", "HighDefinitionSurfaces.cs", line, line + added);
            Arrange(Refracting);
            AssertTheFaultIsSeen();
        }

        [TestCase("float3(InColorPyramid(uv), eyeIndex)", "float3(InColorPyramid(uv), 0)", TestName = "In_HDRP_the_scene_of_the_other_eye_is_seen")]
        [TestCase("_FoamWindow.zw - 1.0), eyeIndex, 0);", "_FoamWindow.zw - 1.0), 0, 0);",
            TestName = "In_HDRP_the_rays_of_the_other_eye_are_seen")]
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
