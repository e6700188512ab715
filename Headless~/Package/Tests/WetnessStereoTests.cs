using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Each of two eyes sees what is wet as a camera there does: in one pass, and in a pass for each.</summary>
    public class WetnessStereoTests : StereoSurfaceFixture
    {
        [Test]
        public void Each_eye_sees_what_a_camera_there_sees([Values(null, "Universal 14", "Universal 17", "HighDefinition 17")] string name,
            [Values] bool oneAfterTheOther)
        {
            if (name == null)
                Build(null, null);
            else
                Build(name.StartsWith("Universal") ? PipelineKind.Universal : PipelineKind.HighDefinition, name.Substring(name.IndexOf(' ') + 1));
            if (oneAfterTheOther)
                DrawEyesOneAfterTheOther();
            var wetness = simulation.gameObject.AddComponent<FluidWetness>();
            (wetness.Darkening, wetness.Smoothness, wetness.DryingTime) = (0.8f, 0f, 10000f);
            Play(40);
            simulation.Clear();
            Arrange(Refracting);
            int dark = 0;
            AssertEachEyeSeesWhatACameraThereSees();
            Color32[] wet = Read();
            wetness.enabled = false;
            Play(2);
            Color32[] dry = Read();
            for (int i = 0; i < wet.Length; i++)
                dark += wet[i].g < 0.6f * dry[i].g ? 1 : 0;
            TestContext.Out.WriteLine($"{dark} of {wet.Length} pixels are dark");
            Assert.That(dark, Is.GreaterThan(wet.Length / 25), "there is something to see");
        }

        static Color32[] Read()
        {
            UnityEngine.Rendering.AsyncGPUReadbackRequest request
                = UnityEngine.Rendering.AsyncGPUReadback.Request(UnityEngine.Headless.StereoView.Eyes, 0, 0, Width, 0, Height, 0, 1);
            request.WaitForCompletion();
            return request.GetData<Color32>().ToArray();
        }
    }
}
