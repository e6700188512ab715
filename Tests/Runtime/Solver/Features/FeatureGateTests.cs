using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Features that a scene may have on a device that is too small for all of it.</summary>
    public class FeatureGateTests
    {
        static readonly FeatureSet Everything = Features.Colliders | Features.DeepWater | Features.VelocitySmoothing
            | Features.Contacts | Features.Emitters | Features.Tags | Features.Drains
            | Features.ForceFields | Features.Borders | Features.Viscosity | Features.GrainFriction | Features.Elasticity | Features.Vorticity
            | Features.Reactions | Features.Sleep | Features.Extrapolation | Features.Foam | Features.Statistics
            | Features.SurfaceParticles | Features.Queries | Features.ParticleAccess;

        static FeatureGate With(int buffers, int threads = 256, int groupshared = 16384)
        {
            var gate = new FeatureGate();
            gate.Begin(new DeviceLimits(buffers, buffers, threads, groupshared), null);
            return gate;
        }

        [TestCase(false, true, true, true, "has no compute shaders (SystemInfo.supportsComputeShaders)")]
        [TestCase(true, false, true, true, "has no indirect arguments (SystemInfo.supportsIndirectArgumentsBuffer)")]
        [TestCase(true, true, false, true, "has no constant buffers of one's own (SystemInfo.supportsSetConstantBuffer)")]
        [TestCase(true, true, true, false, "has no asynchronous readback (SystemInfo.supportsAsyncGPUReadback)")]
        public void What_every_fluid_needs_of_a_device_is_named(bool computeShaders, bool indirectArguments, bool constantBuffers,
            bool asyncReadback, string says)
        {
            string problem = DeviceGate.MissingAbility(computeShaders, indirectArguments, constantBuffers, asyncReadback);
            Assert.That(problem, Does.Contain(says).And.Contains("Run on Direct3D 11 or 12, Vulkan or Metal"));
            Assert.That(DeviceGate.MissingAbility(true, true, true, true), Is.Null);
        }

        [TestCase(14)]
        [TestCase(16)]
        [TestCase(31)]
        [TestCase(128)]
        public void Fourteen_storage_buffers_or_more_hold_every_feature_at_once(int buffers)
        {
            FeatureGate gate = With(buffers);
            Assert.That(gate.ProblemOf(Features.TwoLists), Is.Null);
            gate.Decide(Everything | Features.TwoLists);
            Assert.That(gate.Refused, Is.EqualTo(FeatureSet.None), string.Join("\n", gate.Refusals));
            Assert.That(gate.Refusals, Is.Empty);
        }

        [Test]
        public void Eight_storage_buffers_hold_deep_viscous_water_with_emitters_drains_and_fields()
        {
            FeatureGate gate = With(8);
            Assert.That(gate.ProblemOf(FeatureSet.None), Is.Null);
            gate.Decide(Features.DeepWater | Features.VelocitySmoothing | Features.Emitters | Features.Drains
                | Features.ForceFields | Features.Borders | Features.Vorticity | Features.Extrapolation | Features.Foam
                | Features.Statistics | Features.Queries | Features.ParticleAccess);
            Assert.That(gate.Refused, Is.EqualTo(FeatureSet.None), string.Join("\n", gate.Refusals));
        }

        [TestCase("colliders", "disable the colliders in its box")]
        [TestCase("elasticity", "set the shear modulus to 0")]
        [TestCase("sleep", "set the sleep speed to 0")]
        public void With_eight_a_feature_that_takes_more_is_refused_by_name(string name, string remedy)
        {
            Feature feature = Array.Find(Features.All, one => one.Name == name);
            FeatureGate gate = With(8);
            gate.Decide(feature);
            Assert.That(gate.Refused, Is.EqualTo((FeatureSet)feature));
            Assert.That(gate.Refusals.Single().problem,
                Does.Match(
                $@"^goes on without {name}: kernel '\w+' of \w+\.compute takes \d+ storage buffers, and this device has 8 \(SystemInfo\.maxComputeBufferInputsCompute\)\. Run on .*, or {Regex.Escape(remedy)}\.$"));
        }

        [Test]
        public void A_device_without_storage_buffers_refuses_each_feature_by_name()
        {
            FeatureGate gate = With(0);
            gate.Decide(Everything);
            Assert.That(gate.Refused, Is.EqualTo(Everything.Without(Features.Reactions)), "forces on colliders go with the colliders");
            Assert.That(gate.Refusals.Select(refusal => refusal.problem), Has.All.StartsWith("goes on without "));
        }

        [Test]
        public void With_eight_the_surface_of_a_fluid_with_two_lists_is_refused_by_name_and_that_with_one_is_not()
        {
            FeatureGate gate = With(8);
            gate.Decide(Features.SurfaceParticles);
            Assert.That(gate.Refusals, Is.Empty);
            gate.Decide(Features.SurfaceParticles | Features.TwoLists);
            Assert.That(gate.Refusals.Single().problem,
                Does.Match(
                @"^goes on without the water's surface: kernel '\w+' of SurfaceParticles\.compute takes \d+ storage buffers, and this device has 8 .* or draw it with a ParticleRenderer\.$"));
        }

        [Test]
        public void Fewer_than_eight_storage_buffers_are_refused_with_the_kernel_and_the_limit()
        {
            Assert.That(With(7).ProblemOf(FeatureSet.None),
                Does.Match(
                @"^kernel '\w+' of \w+\.compute takes 8 storage buffers, and this device has 7 \(SystemInfo\.maxComputeBufferInputsCompute\)\. Run on "));
        }

        [Test]
        public void Groups_of_fewer_than_256_threads_are_refused()
        {
            Assert.That(With(16, threads: 128).ProblemOf(FeatureSet.None),
                Does.Contain("has groups of 256 threads, and this device's have at most 128"));
        }

        [Test]
        public void A_fluid_whose_lists_are_two_buffers_takes_no_more_than_eight_either()
        {
            Assert.That(With(8).ProblemOf(Features.TwoLists), Is.Null);
        }

        [Test]
        public void The_more_important_of_two_features_is_kept_where_both_are_too_much()
        {
            FeatureGate gate = With(13);
            gate.Decide(Features.Colliders | Features.Sleep);
            Assert.That(gate.Refused, Is.EqualTo((FeatureSet)Features.Sleep), string.Join("\n", gate.Refusals));
            gate.Decide(Features.Sleep);
            Assert.That(gate.Refused, Is.EqualTo(FeatureSet.None));
        }

        [Test]
        public void What_is_wanted_still_is_not_decided_again()
        {
            FeatureGate gate = With(8);
            Assert.That(gate.Decide(Features.Sleep), Is.True);
            Assert.That(gate.Decide(Features.Sleep), Is.False);
            Assert.That(gate.Refusals.Count, Is.EqualTo(1));
        }

        [Test]
        public void A_feature_that_is_refused_again_is_logged_once()
        {
            var owner = new GameObject("Owner");
            var gate = new FeatureGate(owner);
            gate.Begin(new DeviceLimits(8, 8, 256, 16384), null);
            LogAssert.Expect(LogType.Error, new Regex("Rill: GameObject 'Owner' goes on without sleep: "));
            gate.Decide(Features.Sleep);
            gate.Decide(Features.Sleep | Features.Vorticity);
            gate.Decide(Features.Sleep);
            LogAssert.NoUnexpectedReceived();
            gate.Begin(new DeviceLimits(8, 8, 256, 16384), null);
            LogAssert.Expect(LogType.Error, new Regex("Rill: GameObject 'Owner' goes on without sleep: "));
            gate.Decide(Features.Sleep);
            UnityEngine.Object.DestroyImmediate(owner);
        }

        [Test]
        public void Shaders_of_features_that_no_one_wants_are_not_loaded()
        {
            var loaded = new HashSet<string>();
            var gate = new FeatureGate();
            gate.Begin(DeviceLimits.Current, stage =>
            {
                loaded.Add(stage);
                return TestShaders.Load(stage);
            });
            Assert.That(gate.ProblemOf(FeatureSet.None), Is.Null);
            Assert.That(loaded, Is.EquivalentTo(new[] { "Clear", "DensityConstraint", "ParticleUpload", "NeighborSearch", "PrefixSum",
                "VelocityUpdate" }));
            gate.Decide(Features.Drains);
            Assert.That(loaded, Has.Member("Drains").And.No.Member("Emitters"));
        }

        [Test]
        public void A_draw_shader_that_reads_more_than_the_vertex_stage_has_is_refused()
        {
            Assert.That(DeviceGate.ProblemOfDraw("Particles", new DeviceLimits(16, 0, 256, 16384)),
                Does.StartWith("the vertex stage of Particles.shader reads ").And.Contain("this device has 0 there"));
            Assert.That(DeviceGate.ProblemOfDraw("Particles", DeviceLimits.Current), Is.Null);
            Assert.That(DeviceGate.ProblemOfDraw("Domain", new DeviceLimits(16, 0, 256, 16384)), Is.Null);
        }
    }
}
