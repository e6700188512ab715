using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>A camera of the Built-in pipeline that a player draws straight to the screen, whose pictures are not flipped as those in
    /// textures are.</summary>
    public class BackBufferTests : PipelineSurfaceFixture
    {
        int widthBefore, heightBefore;

        [SetUp]
        public void MakeSmallScreen()
        {
            (widthBefore, heightBefore) = (Player.ScreenWidth, Player.ScreenHeight);
            (Player.ScreenWidth, Player.ScreenHeight) = (Width, Height);
        }

        [TearDown]
        public void RestoreScreen() => (Player.ScreenWidth, Player.ScreenHeight) = (widthBefore, heightBefore);

        [Test]
        public void The_water_looks_the_same_on_the_back_buffer_as_by_way_of_a_texture([Values(1f, 0.5f)] float width)
        {
            Build(null, null);
            camera.targetTexture = null;
            camera.rect = new Rect(0f, 0f, width, 1f);
            UnityEngine.Object.FindObjectOfType<Light>().shadows = LightShadows.Hard;
            Time.timeScale = 0f;        // the same water in all pictures
            Play(5);
            Color32[] byTexture = Screen();
            camera.allowHDR = false;
            Play(3);
            Color32[] straight = Screen();
            camera.allowHDR = true;
            simulation.gameObject.SetActive(false);
            Play(1);
            Assert.That(camera.forceIntoRenderTexture, Is.False, "the camera is as it was");
            Assert.That(Unlike(byTexture, Screen()), Is.GreaterThan(300), "pixels of water");
            Assert.That(Unlike(byTexture, straight), Is.Zero);
        }

        static Color32[] Screen()
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(ScreenTarget.Texture);
            request.WaitForCompletion();
            return request.GetData<Color32>().ToArray();
        }

        static int Unlike(IEnumerable<Color32> a, IEnumerable<Color32> b) =>
            a.Zip(b, (x, y) => Math.Abs(x.r - y.r) + Math.Abs(x.g - y.g) + Math.Abs(x.b - y.b) > 3).Count(unlike => unlike);
    }
}
