// Assertions are compiled into development players only, and here.
#define UNITY_ASSERTIONS
using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.Assertions;
using UnityEngine.Pool;
using Assert = NUnit.Framework.Assert;
using AssertionException = UnityEngine.Assertions.AssertionException;

namespace Host.Tests
{
    /// <summary>Small helpers of Unity's that ordinary scripts use.</summary>
    public class EngineToolsTests
    {
        [Test]
        public void A_pool_hands_out_what_came_back_and_keeps_no_more_than_its_size()
        {
            int made = 0;
            var gone = new List<string>();
            var pool = new ObjectPool<string>(() => "object " + made++, actionOnDestroy: gone.Add, maxSize: 1);
            string first = pool.Get(), second = pool.Get();
            pool.Release(first);
            pool.Release(second);
            Assert.That(gone, Is.EqualTo(new[] { "object 1" }));
            Assert.That(pool.Get(), Is.EqualTo("object 0"));
            Assert.That((pool.CountAll, pool.CountActive, pool.CountInactive), Is.EqualTo((1, 1, 0)));
            pool.Release(first);
            Assert.Throws<InvalidOperationException>(() => pool.Release(first));
        }

        [Test]
        public void A_borrowed_list_goes_back_empty_at_the_end_of_its_block()
        {
            List<int> list;
            using (ListPool<int>.Get(out list)) list.Add(5);
            Assert.That(list, Is.Empty);
            Assert.That(ListPool<int>.Get(), Is.SameAs(list));
            ListPool<int>.Release(list);
        }

        struct Squares : IJobParallelFor
        {
            public NativeArray<int> Result;
            public void Execute(int index) => Result[index] = index * index;
        }

        [Test]
        public void A_job_has_done_its_work_when_it_is_complete()
        {
            using var result = new NativeArray<int>(4, Allocator.TempJob);
            JobHandle handle = new Squares { Result = result }.Schedule(4, 2);
            handle.Complete();
            Assert.That(result.ToArray(), Is.EqualTo(new[] { 0, 1, 4, 9 }));
        }

        [Test]
        public void An_assertion_that_fails_throws_and_says_what_was_expected()
        {
            UnityEngine.Assertions.Assert.IsTrue(true);
            UnityEngine.Assertions.Assert.AreApproximatelyEqual(1, 1.000001f);
            UnityEngine.Assertions.Assert.AreEqual(3, 3);
            var error = Assert.Throws<AssertionException>(() => UnityEngine.Assertions.Assert.AreEqual(3, 4, "counts"));
            Assert.That(error.Message, Is.EqualTo("counts\nAssertion failure. Values are not equal\nExpected: 3 == 4"));
            var gone = new GameObject("gone");
            UnityEngine.Object.DestroyImmediate(gone);
            UnityEngine.Assertions.Assert.IsNull(gone);
            Assert.Throws<AssertionException>(() => UnityEngine.Assertions.Assert.IsNotNull(gone));
        }

        [TestCase("#f80", true, 255, 136, 0, 255)]
        [TestCase("#11223344", true, 17, 34, 51, 68)]
        [TestCase("orange", true, 255, 165, 0, 255)]
        [TestCase("#12345", false, 255, 255, 255, 255)]
        [TestCase("no color", false, 255, 255, 255, 255)]
        public void A_color_is_read_from_html(string text, bool good, int r, int g, int b, int a)
        {
            Assert.That(ColorUtility.TryParseHtmlString(text, out Color color), Is.EqualTo(good));
            Assert.That((Color32)color, Is.EqualTo(new Color32((byte)r, (byte)g, (byte)b, (byte)a)));
        }

        [Test]
        public void A_color_is_written_for_html()
            => Assert.That(ColorUtility.ToHtmlStringRGBA(new Color(1, 0.5f, 0, 0.25f)), Is.EqualTo("FF800040"));
    }
}
