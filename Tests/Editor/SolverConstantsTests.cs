using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Rill.Tests;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Editor.Tests
{
    public class SolverConstantsTests
    {
        const int Words = 40;
        static readonly FieldInfo[] Fields = typeof(SolverConstants).GetFields(BindingFlags.Public | BindingFlags.Instance);

        [Test]
        public void Every_member_is_where_the_kernels_read_it()
        {
            SolverConstants constants = Numbered(out Dictionary<string, uint[]> expected);
            ComputeShader shader = LayoutProbes.Load("LayoutProbe");
            int probe = shader.FindKernel("Probe");
            uint[] words;
            using (GraphicsBuffer buffer = GpuTest.UploadConstants(constants))
            using (GraphicsBuffer output = GpuBuffer.Structured<uint>("Words", Words))
            {
                GpuTest.FillWithGarbage(output);
                GpuTest.Run(cmd =>
                {
                    cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, buffer, 0, buffer.stride);
                    cmd.SetComputeBufferParam(shader, probe, Shader.PropertyToID("_Words"), output);
                    cmd.DispatchCompute(shader, probe, 1, 1, 1);
                });
                words = GpuTest.Read<uint>(output, Words);
            }

            int word = 0;
            foreach (FieldInfo field in Fields)
                foreach (uint bits in expected[field.Name])
                    Assert.That(words[word++], Is.EqualTo(bits), $"word {word - 1}, {field.Name}");
            Assert.That(word, Is.EqualTo(Words));
        }

        [Test]
        public void Substeps_share_the_time_of_the_step()
        {
            StepInput input = SolverStages.Still();
            input.gravity = new float3(0f, -9.81f, 0f);
            input.settings.substeps = 4;
            SolverConstants constants = For(input);
            Assert.That(constants.timeStep, Is.EqualTo(1f / 240f));
            Assert.That(constants.inverseTimeStep, Is.EqualTo(240f).Within(1e-3));
            Assert.That(constants.gravityStep.y, Is.EqualTo(-9.81 / 0.0625 / 240.0 / 240.0).Within(1e-8));
        }

        [Test]
        public void Smoothing_over_the_substeps_is_that_over_the_step()
        {
            StepInput input = SolverStages.Still();
            input.material.velocitySmoothing = 0.08f;
            Assert.That(For(input).smoothing, Is.EqualTo(0.08).Within(1e-6));
            input.settings.substeps = 4;
            Assert.That(For(input).smoothing, Is.EqualTo(0.02).Within(1e-6));
            input.timeStep = 10f;
            Assert.That(For(input).smoothing, Is.EqualTo(1f), "more than all of a difference cannot be evened out");
        }

        [TestCase(1f, 1f)]
        [TestCase(0.5f, 2f / 3f)]
        [TestCase(0f, 0.5f)]
        public void What_lasts_acts_at_once_as_far_as_the_numerical_damping_says(float damping, float fraction)
        {
            StepInput input = SolverStages.Still();
            input.gravity = new float3(0f, -9.81f, 0f);
            input.material.velocitySmoothing = 0.1f;
            input.material.vorticity = 1f;
            input.settings.numericalDamping = 1f;
            SolverConstants first = For(input);
            input.settings.numericalDamping = damping;
            SolverConstants constants = For(input);
            Assert.That(constants.extrapolation, Is.EqualTo(1f - fraction).Within(1e-6f));
            Assert.That(constants.accelerationFraction, Is.EqualTo(fraction).Within(1e-6f));
            Assert.That(constants.gravityStep.y, Is.EqualTo(fraction * first.gravityStep.y).Within(1e-6f));
            Assert.That(constants.smoothing, Is.EqualTo(first.smoothing).Within(1e-6f), "noise does not last");
            Assert.That(constants.confinement, Is.EqualTo(fraction * first.confinement).Within(1e-6f));
        }

        [Test]
        public void Constants_of_the_kernels_come_from_the_lattice()
        {
            SolverConstants constants = For(SolverStages.Still());
            Assert.That(constants.densityScale * 64.0, Is.EqualTo(Kernels.Poly6(0.0) / Kernels.RestDensity).Within(1e-7));
            Assert.That(constants.selfDensity, Is.EqualTo(Kernels.Poly6(0.0) / Kernels.RestDensity).Within(1e-7));
            Assert.That(constants.gradientScale, Is.EqualTo(Kernels.SpikyDerivative(1.0) / Kernels.RestDensity).Within(1e-7));
            Assert.That(constants.epsilon, Is.EqualTo(1e-3 * Kernels.RestSquares).Within(1e-9));
        }

        static SolverConstants For(StepInput input) => SolverConstants.For(new SolverLayout(1f, SolverStages.Spacing, 1000, 96, 1f), input, 1);

        // Another number in every word, and the bits of each field.
        static SolverConstants Numbered(out Dictionary<string, uint[]> bits)
        {
            object constants = new SolverConstants();
            var collected = new Dictionary<string, uint[]>();
            int number = 1;
            foreach (FieldInfo field in Fields)
            {
                if (field.FieldType == typeof(float))
                    Set(field, (float)number, math.asuint((float)number));
                else if (field.FieldType == typeof(int))
                    Set(field, number, (uint)number);
                else if (field.FieldType == typeof(uint))
                    Set(field, (uint)number, (uint)number);
                else if (field.FieldType == typeof(float3))
                {
                    var value = new float3(number, number + 1, number + 2);
                    Set(field, value, math.asuint(value.x), math.asuint(value.y), math.asuint(value.z));
                }
                else if (field.FieldType == typeof(int3))
                    Set(field, new int3(number, number + 1, number + 2), (uint)number, (uint)number + 1, (uint)number + 2);
                else
                    throw new NotSupportedException($"{field.Name} is a {field.FieldType.Name}: say here which words it has.");
                number += 3;
            }
            bits = collected;
            Assert.That(collected.Values.SelectMany(words => words).Distinct().Count(), Is.EqualTo(Words));
            return (SolverConstants)constants;

            void Set(FieldInfo field, object value, params uint[] words)
            {
                field.SetValue(constants, value);
                collected[field.Name] = words;
            }
        }
    }
}
