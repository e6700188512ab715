using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>The buffers of one owner: which of them live, under which name, and who releases them.</summary>
    public class BufferSetTests
    {
        readonly BufferSet set = new BufferSet();

        [TearDown]
        public void Release() => set.Dispose();

        static Dictionary<string, long> Described(BufferSet of)
        {
            var stage = new StageDescription("Stage", true, "it is described");
            of.Describe(stage);
            return stage.Buffers.ToDictionary(buffer => buffer.name, buffer => buffer.bytes);
        }

        [Test]
        public void All_are_released_but_those_of_another_owner()
        {
            GraphicsBuffer shared = GpuBuffer.Structured<uint>("Rill.Shared", 3);
            try
            {
                GraphicsBuffer own = set.Structured<uint>("Rill.Own", 5);
                Assert.That(set.AddShared("Rill.Shared", shared), Is.SameAs(shared));
                Assert.That(Described(set), Is.EquivalentTo(new Dictionary<string, long> { { "Rill.Own", 20 }, { "Rill.Shared", 12 } }));
                set.Dispose();
                set.Dispose();
                Assert.That((own.IsValid(), shared.IsValid()), Is.EqualTo((false, true)));
                Assert.That(Described(set), Is.Empty);
            }
            finally
            {
                shared.Release();
            }
        }

        [Test]
        public void One_that_is_released_is_not_described_and_can_be_made_again()
        {
            GraphicsBuffer buffer = set.Structured<uint>("Rill.Buffer", 5), before = buffer;
            set.Release(ref buffer);
            Assert.That((buffer, before.IsValid()), Is.EqualTo(((GraphicsBuffer)null, false)));
            Assert.That(Described(set), Is.Empty);
            set.Release(ref buffer);        // twice in a row is safe
            buffer = set.Structured<uint>("Rill.Buffer", 7);
            Assert.That(Described(set), Is.EquivalentTo(new Dictionary<string, long> { { "Rill.Buffer", 28 } }));
            set.Dispose();
            Assert.That(buffer.IsValid(), Is.False);
        }

        [Test]
        public void Two_that_change_roles_change_names()
        {
            GraphicsBuffer a = set.Structured<uint>("Rill.A", 2), b = set.Structured<uint>("Rill.B", 6), first = a;
            set.Swap(ref a, ref b);
            Assert.That((b, a != b), Is.EqualTo((first, true)));
            Assert.That(Described(set), Is.EquivalentTo(new Dictionary<string, long> { { "Rill.A", 24 }, { "Rill.B", 8 } }));
            set.Release(ref a);
            Assert.That((first.IsValid(), Described(set).Keys.Single()), Is.EqualTo((true, "Rill.B")), "the one that is in its role now");
        }

        // It may be gone by the time that recorded commands run.
        [Test]
        public void One_without_a_name_in_shaders_is_not_bound()
        {
            ComputeShader shader = StageShader.LoadCompute("Clear");
            GraphicsBuffer unbound = set.Structured<uint>("Rill.Unbound", 4, BufferSet.Unbound);
            using (var cmd = new CommandBuffer())
            {
                set.Bind(cmd, shader, 0);
                set.Release(ref unbound);
                Assert.That(() => Graphics.ExecuteCommandBuffer(cmd), Throws.Nothing);
            }
        }

        [Test]
        public void A_buffer_of_another_set_is_refused()
        {
            using (GraphicsBuffer other = GpuBuffer.Structured<uint>("Rill.Other", 1))
            {
                GraphicsBuffer buffer = other;
                Assert.Throws<ArgumentException>(() => set.Release(ref buffer));
            }
        }
    }
}
