using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;

namespace Rill.Tests
{
    /// <summary>The rows of features.</summary>
    public class FeaturesTests
    {
        [Test]
        public void Every_kernel_belongs_to_a_feature()
        {
            foreach (KernelNeed need in KernelNeeds.OfKernels)
                Assert.That(() => Features.Of(need), Throws.Nothing, $"{need.File} {need.Kernel} {need.Defines}");
        }

        [Test]
        public void A_shader_that_no_feature_has_is_named()
        {
            var need = new KernelNeed("Unknown", "Kernel", "", 64, 0, 1, 1, 0);
            Assert.That(() => Features.Of(need), Throws.ArgumentException.With.Message.Contains("Unknown.compute belongs to no feature"));
        }

        [TestCase("Colliders", "", "colliders")]
        [TestCase("CoarseColliders", "WITH_COLLIDERS", "colliders, deep water")]
        [TestCase("Drains", "RILL_RECYCLING", "emitters, drains and lifetimes")]
        [TestCase("ParticleUpload", "NAME_OF_NO_FEATURE", "the fluid itself")]
        [TestCase("VelocityUpdate", "VISCOUS EXTRAPOLATE", "the fluid itself, velocity smoothing, less numerical damping")]
        public void A_kernel_has_the_features_of_its_shader_and_of_its_defines(string file, string defines, string features)
            => Assert.That(Features.Of(new KernelNeed(file, "Kernel", defines, 64, 0, 1, 1, 0)).ToString(), Is.EqualTo(features));

        [Test]
        public void No_row_names_a_kernel_or_a_define_that_is_not_there()
        {
            var files = new HashSet<string>(KernelNeeds.OfKernels.Select(need => need.File));
            var defines = new HashSet<string>(KernelNeeds.OfKernels.SelectMany(need => need.Defines.Split(' ')));
            foreach (Feature feature in Features.All)
            {
                Assert.That(feature.Kernels.Except(feature.Stages).Where(file => !files.Contains(file)), Is.Empty, feature.Name);
                Assert.That(feature.Defines.Where(define => !defines.Contains(define)), Is.Empty, feature.Name);
            }
        }

        [Test]
        public void Every_stage_is_in_one_row_alone()
            => Assert.That(Features.All.SelectMany(feature => feature.Stages), Is.Unique);

        [Test]
        public void What_a_step_asks_for_can_be_turned_off_and_says_how()
        {
            foreach (Feature feature in Features.OfSettings)
            {
                var step = new StepInput { settings = SolverSettings.Default, material = FluidMaterial.Water };
                step.material.dynamicViscosity = step.material.shearModulus = step.material.vorticity = step.material.frictionAngle = 1f;
                step.settings.sleepSpeed = 1f;
                step.borders.minX.kind = BorderKind.Absorbing;
                step.phases.Set(1, 500f, 2f, cohesion: 100f);
                step.phases.SetPair(0, 1, 0.001f);
                step.material.contacts = feature == Features.Contacts;
                if (feature == Features.Sleep)
                    step.material.vorticity = 0f;
                Assert.That(feature.IsAsked(null, step), feature.Name);
                feature.TurnOff(ref step);
                Assert.That(feature.IsAsked(null, step), Is.False, feature.Name);
                Assert.That(feature.Remedy, Is.Not.Null.And.Not.Empty, feature.Name);
            }
        }

        // What asks by one field is not all of it.
        [Test]
        public void A_feature_that_is_asked_for_by_several_fields_is_turned_off_by_each()
        {
            var step = new StepInput { settings = SolverSettings.Default, material = FluidMaterial.Water, tracksPhases = true };
            step.phases.Set(1, 500f, 0f);
            Assert.That(Features.Tags.IsAsked(null, step));
            Features.Tags.TurnOff(ref step);
            Assert.That((Features.Tags.IsAsked(null, step), Features.Materials.IsAsked(null, step)), Is.EqualTo((false, false)));
            step.material.velocitySmoothing = 0f;
            step.needsDensity = true;
            Assert.That(Features.VelocitySmoothing.IsAsked(null, step));
            Features.VelocitySmoothing.TurnOff(ref step);
            Assert.That(Features.VelocitySmoothing.IsAsked(null, step), Is.False);
        }

        // Else a build would miss its shaders: the Editor has all, and a player would go on without it.
        [Test]
        public void A_stage_that_settings_alone_ask_for_belongs_to_those_of_settings([Values(0f, 1f)] float vorticity)
        {
            object material = FluidMaterial.Water;
            foreach (FieldInfo field in typeof(FluidMaterial).GetFields(BindingFlags.Instance | BindingFlags.Public))
                field.SetValue(material, field.FieldType == typeof(bool) ? vorticity == 0f : (object)1f);
            var step = new StepInput { settings = SolverSettings.Default, material = (FluidMaterial)material };
            step.material.vorticity = vorticity;
            step.settings.sleepSpeed = 1f;
            step.phases.Set(1, 500f, 0f);
            int asked = 0;
            foreach (Feature feature in Features.All)
            {
                if (feature == Features.DeepWater || feature.Stages.Length == 0 || !feature.IsAsked(null, step))
                    continue;
                asked++;
                Assert.That(feature.OfSettings, $"{feature.Name}: write ofSettings: true in its row");
            }
            Assert.That(asked, Is.GreaterThanOrEqualTo(3));
        }

        [Test]
        public void Sets_have_what_is_put_in()
        {
            FeatureSet set = Features.Colliders | Features.Foam;
            Assert.That(Features.All.Where(set.Has), Is.EqualTo(new[] { Features.Colliders, Features.Foam }));
            Assert.That(set.Without(Features.Foam), Is.EqualTo((FeatureSet)Features.Colliders));
            Assert.That(set.HasAll(Features.Foam), Is.True);
            Assert.That(((FeatureSet)Features.Foam).HasAll(set), Is.False);
            Assert.That(set.HasAny(Features.Foam | Features.Sleep), Is.True);
            Assert.That(set.HasAny(Features.Sleep), Is.False);
            Assert.That(set.With(Features.Sleep, false), Is.EqualTo(set));
            Assert.That(FeatureSet.None.IsEmpty && !set.IsEmpty);
            Assert.That(Array.IndexOf(Features.All, Features.Colliders), Is.EqualTo(Features.Colliders.Index));
        }
    }
}
