using NUnit.Framework;
using UnityEngine;

namespace Rill.Editor.Tests
{
    public class ShapeHandleTests
    {
        [Test]
        public void A_face_that_is_dragged_stays_under_the_mouse_while_the_box_stays_centered()
        {
            // From 2 x 2 x 2: the upper face was dragged from y = 1 to y = 1.5, the left one from x = -1 to x = -3.
            Vector3 size = ShapeHandles.Centered(new Vector3(-1f, 0.25f, 0f), new Vector3(4f, 2.5f, 2f));
            Assert.That(size, Is.EqualTo(new Vector3(6f, 3f, 2f)));
            Assert.That(ShapeHandles.Centered(Vector3.zero, Vector3.one), Is.EqualTo(Vector3.one));
        }
    }
}
