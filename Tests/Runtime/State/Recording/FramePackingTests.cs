using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The kernels that pack and unpack, against the layout read word by word.</summary>
    public class FramePackingTests
    {
        [Test]
        public void Particles_lie_in_the_words_as_the_layout_says([Values(0, 1, 2, 127, 128, 129, 1009)] int count, [Values(false, true)] bool isWide)
        {
            var layout = new FrameLayout(RecordingFields.All, isWide);
            using (TestFluid fluid = Random(count, new float3(10f, 20f, 7f)))
            {
                ParticleState state = fluid.Read();
                uint[] words = Pack(fluid, layout);
                Assert.That((words[0], words[1]), Is.EqualTo(((uint)count, (uint)count)));
                Assert.That(words.Skip(FrameLayout.PackedHeader + (int)layout.Words(count)).All(w => w == Garbage), "nothing behind");
                for (int i = 0; i < count; i++)
                {
                    (uint3 steps, float3 velocity, uint id) = Unpack(words.Skip(FrameLayout.PackedHeader).ToArray(), layout, count, i);
                    float3 position = 0.5f + (float3)steps * layout.StepSize(state.box);
                    Assert.That(math.all(math.abs(position - state.positions[i].xyz) <= 0.5f * layout.StepSize(state.box) + 2e-6f),
                        $"{i}: {position} for {state.positions[i].xyz}");
                    Assert.That(math.all(math.abs(velocity - state.velocities[i].xyz) <= math.abs(state.velocities[i].xyz) / 2048f + 1e-7f),
                        $"{i}: {velocity} for {state.velocities[i].xyz}");
                    Assert.That(id, Is.EqualTo(state.ids[i]));
                }
            }
        }

        [Test]
        public void What_is_not_finite_or_outside_is_stored_as_numbers_in_the_box()
        {
            var layout = new FrameLayout(RecordingFields.Velocities, false);
            using (var fluid = new TestFluid(new float3(10f), 1f, 100))
            {
                float3[] positions =
                    { new float3(float.NaN, 1f, 1f), new float3(float.PositiveInfinity, 1f, 1f), new float3(-3f, 12f, 2.5f), 5f, 6f };
                fluid.Add(positions, p => p.x == 5f ? new float3(float.NaN, 0f, 0f) : p.x == 6f ? new float3(1e9f, -1e9f, 1f) : 0f);
                uint[] words = Pack(fluid, layout).Skip(FrameLayout.PackedHeader).ToArray();
                Assert.That(Unpack(words, layout, 5, 0).steps, Is.EqualTo(new uint3(0, 0, 0)));
                Assert.That(Unpack(words, layout, 5, 1).steps, Is.EqualTo(new uint3(0, 0, 0)));
                Assert.That(Unpack(words, layout, 5, 2).steps, Is.EqualTo(new uint3(0, 65535, 14563)));       // 2 of 9 d
                Assert.That(Unpack(words, layout, 5, 3).velocity, Is.EqualTo(float3.zero));
                Assert.That(Unpack(words, layout, 5, 4).velocity, Is.EqualTo(new float3(65504f, -65504f, 1f)));
            }
        }

        [Test]
        public void A_frame_in_a_wide_box_comes_back_within_its_steps()
        {
            var layout = FrameLayout.For(RecordingFields.All, new float3(1500f, 4f, 4f));
            Assert.That(layout.IsWide);
            using (TestFluid fluid = Random(300, new float3(1500f, 4f, 4f)), other = new TestFluid(new float3(1500f, 4f, 4f), 1f, 400))
            {
                fluid.Input.gravity = 0f;
                ParticleState state = fluid.Read();
                Show(other, layout, Pack(fluid, layout), 300);
                ParticleState shown = other.Read();
                float3 tolerance = 0.5f * layout.StepSize(state.box) + new float3(2e-4f, 1e-5f, 1e-5f);        // and what floats have there
                for (int i = 0; i < 300; i++)
                {
                    int at = Array.IndexOf(shown.ids, state.ids[i]);
                    Assert.That(math.all(math.abs(shown.positions[at].xyz - state.positions[i].xyz) <= tolerance),
                        $"{shown.positions[at].xyz} for {state.positions[i].xyz}");
                }
            }
        }

        [Test]
        public void Words_that_no_fluid_packed_are_shown_as_finite_particles_in_the_box()
        {
            var layout = new FrameLayout(RecordingFields.All, false);
            var random = new System.Random(4);
            using (var fluid = new TestFluid(new float3(10f), 1f, 400))
            {
                uint[] words = Enumerable.Range(0, FrameLayout.PackedHeader + (int)layout.Words(300)).Select(i => (uint)random.Next() * 2u).ToArray();
                Show(fluid, layout, words, 300);
                ParticleState state = fluid.Read();
                Assert.That(state.Count, Is.EqualTo(300));
                for (int i = 0; i < state.Count; i++)
                    Assert.That(math.all(state.positions[i].xyz >= 0f) && math.all(state.positions[i].xyz <= 10f)
                        && math.all(math.isfinite(state.velocities[i].xyz)), $"{state.positions[i]} {state.velocities[i]}");
            }
        }

        const uint Garbage = 0xDEADBEEFu;

        static TestFluid Random(int count, float3 box)
        {
            var random = new Unity.Mathematics.Random(7u);
            var fluid = new TestFluid(box, 1f, count + 100);
            if (count > 0)
                fluid.Add(Enumerable.Range(0, count).Select(i => random.NextFloat3(0.5f, box - 0.5f)).ToArray(), p => random.NextFloat3(-30f, 30f));
            return fluid;
        }

        static uint[] Pack(TestFluid fluid, FrameLayout layout)
        {
            long words = FrameLayout.PackedHeader + layout.Words(fluid.Solver.Layout.Capacity);
            GraphicsBuffer frame = GpuBuffer.Structured<uint>("Frame", words);
            frame.SetData(Enumerable.Repeat(Garbage, (int)words).ToArray());
            GpuTest.Run(cmd => fluid.Solver.RecordFrame(cmd, layout, frame));
            uint[] packed = GpuTest.Read<uint>(frame, (int)words);
            frame.Release();
            return packed;
        }

        static void Show(TestFluid fluid, FrameLayout layout, uint[] packed, int count)
        {
            StepInput still = SolverStages.Still(SolverSettings.Default, FluidMaterial.Water);
            still.settings.substeps = 1;
            still.settings.iterations = 0;
            still.settings.deepWater = DeepWater.Off;
            still.material.velocitySmoothing = 0f;
            var frame = new RecordedFrame { particles = count, words = packed.Skip(FrameLayout.PackedHeader).ToArray(), nextId = packed[1] };
            GpuTest.Run(cmd => fluid.Solver.ShowFrame(cmd, still, layout, frame, false));
        }

        static (uint3 steps, float3 velocity, uint id) Unpack(uint[] words, FrameLayout layout, int count, int i)
        {
            int pairs = (count + 1) / 2, velocities = layout.IsWide ? 2 * count : count + pairs, ids = velocities + count + pairs;
            uint3 steps;
            if (layout.IsWide)
            {
                ulong both = words[2 * i] | (ulong)words[2 * i + 1] << 32;
                steps = new uint3((uint)both & 0x1FFFFF, (uint)(both >> 21) & 0x1FFFFF, (uint)(both >> 42) & 0x1FFFFF);
            }
            else
            {
                steps = new uint3(words[i] & 0xFFFF, words[i] >> 16, words[count + i / 2] >> 16 * (i & 1) & 0xFFFF);
            }
            uint xy = words[velocities + i], z = words[velocities + count + i / 2] >> 16 * (i & 1) & 0xFFFF;
            return (steps, new float3(Half(xy & 0xFFFF), Half(xy >> 16), Half(z)), layout.Has(RecordingFields.Ids) ? words[ids + i] : 0u);
        }

        // IEEE 754 binary16.
        static float Half(uint bits)
        {
            int exponent = (int)(bits >> 10 & 31);
            float fraction = (bits & 1023) / 1024f, sign = (bits & 0x8000) != 0 ? -1f : 1f;
            return exponent == 31 ? (fraction == 0f ? sign * float.PositiveInfinity : float.NaN)
                : sign * (exponent == 0 ? fraction * math.pow(2f, -14) : (1f + fraction) * math.pow(2f, exponent - 15));
        }
    }
}
