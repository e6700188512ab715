using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using NUnit.Framework;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Editor.Tests
{
    public class CoarseConstantsTests
    {
        const int Words = 52;

        static readonly FieldInfo[] Fields = typeof(CoarseConstants).GetFields(BindingFlags.Public | BindingFlags.Instance);

        [Test]
        public void Every_member_is_where_the_kernels_read_it()
        {
            CoarseConstants constants = Numbered(out List<(string field, uint bits)> expected);
            ComputeShader shader = LayoutProbes.Load("CoarseLayoutProbe");
            int probe = shader.FindKernel("Probe");
            uint[] words;
            using (GraphicsBuffer buffer = GpuTest.UploadConstants(constants))
            using (GraphicsBuffer output = GpuBuffer.Structured<uint>("Words", Words))
            {
                GpuTest.FillWithGarbage(output);
                GpuTest.Run(cmd =>
                {
                    cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, buffer, 0, buffer.stride);
                    cmd.SetComputeBufferParam(shader, probe, Shader.PropertyToID("_Words"), output);
                    cmd.DispatchCompute(shader, probe, 1, 1, 1);
                });
                words = GpuTest.Read<uint>(output, Words);
            }
            Assert.That(expected.Count, Is.EqualTo(Words));
            for (int word = 0; word < Words; word++)
                Assert.That(words[word], Is.EqualTo(expected[word].bits), $"word {word}, {expected[word].field}");
        }

        [Test]
        public void No_member_crosses_16_bytes_and_the_struct_fills_whole_registers()
        {
            foreach (FieldInfo field in Fields)
            {
                int offset = (int)Marshal.OffsetOf<CoarseConstants>(field.Name);
                Assert.That(offset / 16, Is.EqualTo((offset + Marshal.SizeOf(field.FieldType) - 1) / 16), $"{field.Name} at {offset}");
            }
            Assert.That(Marshal.SizeOf<CoarseConstants>(), Is.EqualTo(4 * Words));
        }

        [Test]
        public void Values_are_those_of_the_grid()
        {
            var grid = new CoarseGrid(new float3(10f, 41f, 2f), 4f);
            Assert.That(grid.Counts, Is.EqualTo(new int3(2, 10, 1)));
            CoarseConstants constants = CoarseConstants.For(grid);
            Assert.That(constants.counts, Is.EqualTo(new uint3(2, 10, 1)));
            Assert.That(constants.total, Is.EqualTo(20));
            double volume = 5.0 * 4.1 * 2.0;
            Near(constants.inverseVolume, 1.0 / volume);
            Assert.That(constants.activeCount, Is.EqualTo(24f), "two layers across a cell are 23.8 particles");
            Near(constants.inverseSize.y, 1.0 / 4.1);
            Near(constants.coupling.x, 1.0 / 25.0);
            Near(constants.coupling.y, 1.0 / (4.1 * 4.1));
            Near(constants.coupling.z, 1.0 / 4.0);
            Near(constants.screening, 1e-4);
            Near(constants.negativeFraction, 0.3);
            Near(constants.minSurfaceDistance, 0.1);
            Near(constants.maxSurfaceDistance, 1.5);
            Assert.That(constants.levelCount, Is.EqualTo(1));
            Assert.That(constants.level1, Is.EqualTo(new uint4(1, 5, 1, 0)));
            Assert.That(constants.level7, Is.EqualTo(constants.level1));

            void Near(float actual, double expected) => Assert.That(actual, Is.EqualTo(expected).Within(1e-6 * expected));
        }

        [TestCase(4f, 32)]
        [TestCase(8f, 128)]
        public void Two_layers_across_a_cell_make_it_active_whatever_its_size(float cellSize, int particles)
        {
            Assert.That(CoarseConstants.For(new CoarseGrid(new float3(80f, 40f, 64f), cellSize)).activeCount, Is.EqualTo((float)particles));
        }

        // Another number in every word.
        static CoarseConstants Numbered(out List<(string field, uint bits)> words)
        {
            object constants = new CoarseConstants();
            words = new List<(string, uint)>();
            uint next = 1;
            foreach (FieldInfo field in Fields)
            {
                bool isFloat = field.FieldType == typeof(float) || field.FieldType == typeof(float3);
                uint[] numbers = Enumerable.Range(0, Marshal.SizeOf(field.FieldType) / 4).Select(_ => next++).ToArray();
                field.SetValue(constants, Value(field.FieldType, numbers));
                foreach (uint number in numbers)
                    words.Add((field.Name, isFloat ? math.asuint((float)number) : number));
            }
            Assert.That(words.Select(word => word.bits).Distinct().Count(), Is.EqualTo(words.Count));
            return (CoarseConstants)constants;
        }

        static object Value(Type type, uint[] n)
        {
            if (type == typeof(float))
                return (float)n[0];
            if (type == typeof(float3))
                return new float3(n[0], n[1], n[2]);
            if (type == typeof(uint))
                return n[0];
            if (type == typeof(uint3))
                return new uint3(n[0], n[1], n[2]);
            if (type == typeof(uint4))
                return new uint4(n[0], n[1], n[2], n[3]);
            throw new NotSupportedException($"{type.Name}: say here how to make one.");
        }
    }
}
