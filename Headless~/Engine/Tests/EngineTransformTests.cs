using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    public class EngineTransformTests : EngineFixture
    {
        static void Near(Vector3 actual, Vector3 expected, float within = 1e-4f)
            => Assert.That((actual - expected).magnitude, Is.LessThan(within), $"{actual:G9} instead of {expected:G9}");

        static Transform Make(string name, Transform parent, Vector3 position, Vector3 angles, Vector3 scale)
        {
            Transform t = new GameObject(name).transform;
            t.SetParent(parent, false);
            t.localPosition = position;
            t.localEulerAngles = angles;
            t.localScale = scale;
            return t;
        }

        [Test]
        public void A_world_matrix_is_the_product_down_the_hierarchy()
        {
            Transform a = Make("a", null, new Vector3(1, 2, 3), new Vector3(10, 20, 30), new Vector3(1, 2, 3));
            Transform b = Make("b", a, new Vector3(-1, 0, 2), new Vector3(0, 45, 0), new Vector3(2, 1, 1));
            Matrix4x4 expected = Matrix4x4.TRS(a.localPosition, a.localRotation, a.localScale) * Matrix4x4.TRS(b.localPosition,
                b.localRotation, b.localScale);
            Near(b.TransformPoint(new Vector3(1, 2, 3)), expected.MultiplyPoint3x4(new Vector3(1, 2, 3)));
            Near(b.position, expected.GetPosition());
            Near(b.InverseTransformPoint(b.TransformPoint(new Vector3(4, 5, 6))), new Vector3(4, 5, 6));
            a.localPosition += Vector3.up;
            Near(b.position, expected.GetPosition() + Vector3.up);
        }

        [Test]
        public void A_place_that_is_not_finite_is_refused_with_the_objects_name_and_the_old_one_stays()
        {
            Transform t = Make("thing", null, new Vector3(1, 2, 3), Vector3.zero, Vector3.one);
            t.position = new Vector3(float.NaN, 0f, 0f);
            t.localPosition = new Vector3(0f, float.NegativeInfinity, 0f);
            Assert.That(Errors(), Is.EqualTo(new[]
            {
                "transform.position assign attempt for 'thing' is not valid. Input position is { NaN, 0.000000, 0.000000 }.",
                "transform.localPosition assign attempt for 'thing' is not valid. Input localPosition is { 0.000000, -Infinity, 0.000000 }.",
            }));
            Near(t.position, new Vector3(1, 2, 3));
        }

        [Test]
        public void A_new_parent_leaves_the_object_where_it_was()
        {
            Transform parent = Make("parent", null, new Vector3(1, 2, 3), new Vector3(10, 20, 30), new Vector3(2, 2, 2));
            Transform child = Make("child", null, new Vector3(5, 6, 7), new Vector3(40, 50, 60), new Vector3(1, 3, 1));
            Quaternion rotation = child.rotation;
            child.SetParent(parent);
            Near(child.position, new Vector3(5, 6, 7));
            Assert.That(Quaternion.Angle(child.rotation, rotation), Is.LessThan(0.1f));
            Near(child.lossyScale, new Vector3(1, 3, 1));
            child.SetParent(null);
            Near(child.localScale, new Vector3(1, 3, 1));
        }

        [Test]
        public void A_new_parent_takes_the_object_along_when_told_so()
        {
            Transform parent = Make("parent", null, new Vector3(1, 2, 3), Vector3.zero, Vector3.one);
            Transform child = Make("child", null, new Vector3(5, 6, 7), Vector3.zero, Vector3.one);
            child.SetParent(parent, false);
            Near(child.position, new Vector3(6, 8, 10));
        }

        [Test]
        public void Rotations_hold_below_a_mirroring_parent()
        {
            Transform parent = Make("parent", null, Vector3.zero, new Vector3(0, 30, 0), new Vector3(-1, 1, 1));
            Transform child = Make("child", parent, Vector3.zero, Vector3.zero, Vector3.one);
            Quaternion wanted = Quaternion.Euler(10, 70, 20);
            child.rotation = wanted;
            Assert.That(Quaternion.Angle(child.rotation, wanted), Is.LessThan(0.1f));
            // The matrix mirrors x; its other columns must be the rotation's.
            Near(child.localToWorldMatrix.GetColumn(2), wanted * Vector3.forward);
            Near(child.localToWorldMatrix.GetColumn(1), wanted * Vector3.up);
        }

        [Test]
        public void Moves_and_turns_are_relative_to_the_object_unless_told_otherwise()
        {
            Transform t = Make("t", null, Vector3.zero, new Vector3(0, 90, 0), Vector3.one);
            t.Translate(0, 0, 2);
            Near(t.position, new Vector3(2, 0, 0));
            t.Translate(0, 0, 2, UnityEngine.Space.World);
            Near(t.position, new Vector3(2, 0, 2));
            t.Rotate(0, 90, 0);
            Near(t.forward, Vector3.back);
            t.LookAt(new Vector3(2, 5, 2), Vector3.right);
            Near(t.forward, Vector3.up);
            t.RotateAround(Vector3.zero, Vector3.up, 180);
            Near(t.position, new Vector3(-2, 0, -2));
        }

        [Test]
        public void Children_are_found_by_path_and_keep_their_order()
        {
            Transform root = Make("root", null, default, default, Vector3.one);
            Transform a = Make("a", root, default, default, Vector3.one), b = Make("b", root, default, default, Vector3.one),
                c = Make("c", b, default, default, Vector3.one);
            Assert.That(root.Find("b/c"), Is.SameAs(c));
            Assert.That(root.Find("c"), Is.Null);
            Assert.That(c.root, Is.SameAs(root));
            Assert.That(c.IsChildOf(root));
            b.SetAsFirstSibling();
            Assert.That(root.GetChild(0), Is.SameAs(b));
            Assert.That(a.GetSiblingIndex(), Is.EqualTo(1));
            root.DetachChildren();
            Assert.That(root.childCount, Is.EqualTo(0));
        }

        [Test]
        public void An_object_cannot_become_its_own_descendant()
        {
            Transform a = Make("a", null, default, default, Vector3.one), b = Make("b", a, default, default, Vector3.one);
            a.SetParent(b);
            Assert.That(a.parent, Is.Null);
            Assert.That(Errors(), Has.Count.EqualTo(1));
        }
    }
}
