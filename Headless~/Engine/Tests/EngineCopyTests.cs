using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Instantiate for the engine's own components.</summary>
    public class EngineCopyTests : EngineFixture
    {
        [Test]
        public void A_copied_camera_has_the_settings_and_its_own_commands()
        {
            Camera original = Add<Camera>("camera");
            original.fieldOfView = 33;
            original.backgroundColor = Color.red;
            original.enabled = false;
            using (var commands = new CommandBuffer())
            {
                original.AddCommandBuffer(CameraEvent.AfterEverything, commands);
                Camera copy = Object.Instantiate(original);
                Assert.That(copy.fieldOfView, Is.EqualTo(33));
                Assert.That(copy.backgroundColor, Is.EqualTo(Color.red));
                Assert.That(copy.enabled, Is.False);
                Assert.That(copy.GetCommandBuffers(CameraEvent.AfterEverything), Is.Empty);
            }
        }

        [Test]
        public void A_copied_light_shines_alike()
        {
            Light original = Add<Light>("light");
            original.type = LightType.Point;
            original.color = Color.green;
            original.intensity = 3;
            Light copy = Object.Instantiate(original);
            Assert.That(copy.type, Is.EqualTo(LightType.Point));
            Assert.That(copy.color, Is.EqualTo(Color.green));
            Assert.That(copy.intensity, Is.EqualTo(3));
        }

        [Test]
        public void Only_active_and_enabled_cameras_draw()
        {
            Camera camera = Add<Camera>("camera");
            Assert.That(Camera.allCameras, Is.EqualTo(new[] { camera }));
            camera.enabled = false;
            Assert.That(Camera.allCameras, Is.Empty);
            camera.enabled = true;
            camera.gameObject.SetActive(false);
            Assert.That(Camera.allCameras, Is.Empty);
            camera.gameObject.SetActive(true);
            Object.DestroyImmediate(camera.gameObject);
            Assert.That(Camera.allCameras, Is.Empty);
        }
    }
}
