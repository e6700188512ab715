using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Buffers are cleared by a kernel, whatever their elements and however many there are.</summary>
    public class BufferClearTests
    {
        // Around a group, and more groups than a dispatch has along one axis.
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(100003)]
        [TestCase(65535 * BufferClear.Group + 1)]
        public void Every_word_of_a_buffer_is_cleared(int count) => AssertClears<uint>(count);

        [Test]
        public void Elements_of_every_size_that_the_solver_clears_are_cleared([Values(1, 257, 997)] int count)
        {
            AssertClears<float>(count);
            AssertClears<float4>(count);
            AssertClears<Viscoelasticity.Symmetric>(count);
        }

        [Test]
        public void Elements_of_a_size_that_no_kernel_clears_are_refused_by_their_size()
        {
            GraphicsBuffer buffer = GpuBuffer.Structured<uint2>("Pairs", 4);
            try
            {
                Assert.That(() => BufferClear.Now(buffer),
                    Throws.ArgumentException.With.Message.Contains("8 bytes").And.Message.Contains("Clear.compute"));
            }
            finally
            {
                buffer.Release();
            }
        }

        static void AssertClears<T>(int count) where T : struct
        {
            GraphicsBuffer buffer = GpuBuffer.Structured<T>("Cleared", count);
            try
            {
                GpuTest.FillWithGarbage(buffer);
                BufferClear.Now(buffer);
                var words = new uint[(long)count * buffer.stride / sizeof(uint)];
                buffer.GetData(words);
                Assert.That(Array.FindIndex(words, word => word != 0), Is.EqualTo(-1), $"first word that is not 0, of {words.Length:N0}");
            }
            finally
            {
                buffer.Release();
            }
        }
    }
}
