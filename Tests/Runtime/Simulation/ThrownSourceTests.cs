using System;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Exceptions in calls by the simulation within its frame do not stop the water.</summary>
    public class ThrownSourceTests
    {
        [Test]
        public void Time_goes_on_where_a_source_of_colliders_throws_which_is_logged_once()
        {
            using (SourceScene scene = Scene())
            {
                var source = new Source { throws = true };
                scene.Fluid.Inputs.Colliders.Source = source;
                LogsOnce("planted in Gather", "without Source in each frame");
                scene.Step(5);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(5));
                Assert.That(source.asked, Is.EqualTo(5), "asked in each frame");
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void A_source_that_has_thrown_gives_its_colliders_again_afterwards()
        {
            using (SourceScene scene = Scene())
            {
                var source = new Source { throws = true };
                source.colliders.Add(new Sphere("Ball"));
                scene.Fluid.Inputs.Colliders.Source = source;
                LogsOnce("planted in Gather", "without Source");
                scene.Step();
                Assert.That(scene.Fluid.Inputs.Colliders.Set.Count, Is.Zero);
                source.throws = false;
                scene.Step();
                Assert.That(scene.Fluid.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            }
        }

        [Test]
        public void A_collider_that_throws_is_left_out_alone([Values("Describe", "Teleports", "Name")] string where)
        {
            using (SourceScene scene = Scene())
            {
                var source = new Source();
                source.colliders.Add(new Sphere("Before"));
                source.colliders.Add(new Sphere("Faulty") { throwsIn = where });
                source.colliders.Add(new Sphere("After"));
                source.colliders.Add(null);
                scene.Fluid.Inputs.Colliders.Source = source;
                if (where == "Name")
                    ((Sphere)source.colliders[1]).throwsIn += " Describe";
                LogsOnce("planted in " + (where == "Name" ? "Describe" : where), where == "Name" ? "without Sphere in" : "without Sphere 'Faulty'");
                LogsOnce("NullReferenceException", "without a collider that is null");
                scene.Step(3);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(3));
                Assert.That(scene.Fluid.Inputs.Colliders.Set.Count, Is.EqualTo(2));
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void A_collider_that_throws_as_it_takes_its_force_leaves_that_of_the_others()
        {
            using (SourceScene scene = Scene())
            {
                var source = new Source();
                Sphere faulty = new Sphere("Faulty") { throwsIn = "SetForce", measures = true }, whole = new Sphere("Whole") { measures = true };
                source.colliders.Add(faulty);
                source.colliders.Add(whole);
                scene.Fluid.Inputs.Colliders.Source = source;
                LogsOnce("planted in SetForce", "without Sphere 'Faulty'");
                for (int i = 0; i < 4; i++)
                {
                    scene.Step();
                    AsyncGPUReadback.WaitAllRequests();
                }
                Assert.That(whole.forces, Is.GreaterThan(1));
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void A_pass_that_throws_in_every_step_is_logged_once_by_name()
        {
            using (SourceScene scene = Scene())
            {
                scene.Fluid.BeforeStep += Faulty;
                LogsOnce("planted in a pass", "the pass ThrownSourceTests.Faulty of BeforeStep");
                scene.Step(5);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(5));
                LogAssert.NoUnexpectedReceived();
            }
        }

        [Test]
        public void What_still_throws_is_logged_again_once_its_fluid_was_enabled_again()
        {
            using (SourceScene scene = Scene())
            {
                scene.Fluid.Inputs.Colliders.Source = new Source { throws = true };
                for (int i = 0; i < 2; i++)
                {
                    LogsOnce("planted in Gather", "without Source");
                    scene.Step(2);
                    scene.Fluid.enabled = false;
                    scene.Fluid.enabled = true;
                }
                LogAssert.NoUnexpectedReceived();
            }
        }

        static SourceScene Scene() => new SourceScene(Vector3.one, 0.1f, 1000).Fill(0.5f);

        static void Faulty(CommandBuffer commands, FluidParticles particles) => throw new InvalidOperationException("planted in a pass");

        static void LogsOnce(string exception, string name)
        {
            LogAssert.Expect(LogType.Exception, new Regex(exception));
            LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid' goes on.*" + name + ".*correct what throws it"));
        }

        sealed class Source : IColliderSource
        {
            public readonly List<IFluidCollider> colliders = new List<IFluidCollider>();
            public bool throws;
            public int asked;

            public List<IFluidCollider> Gather(Vector3 center, Quaternion rotation, Vector3 size, float spacing)
            {
                asked++;
                return throws ? throw new InvalidOperationException("planted in Gather") : colliders;
            }
        }

        sealed class Sphere : IFluidCollider
        {
            readonly string name;
            public string throwsIn = "";
            public bool measures;
            public int forces;

            public Sphere(string name) => this.name = name;

            public string Name => Checked("Name") ? name : null;
            public bool IsAlive => true;
            public int Teleports => Checked("Teleports") ? 0 : 1;
            public bool MeasuresForce => measures;

            public bool IsCarried => false;

            public void AwaitForce(FluidSimulation fluid) { }

            public string Describe(out ColliderMotion motion)
            {
                Checked("Describe");
                RigidPose pose = new RigidPose(Vector3.zero, Quaternion.identity);
                motion = new ColliderMotion { shape = ColliderShape.Sphere, size = 0.2f, start = pose, end = pose, reacts = measures };
                return null;
            }

            public bool TryDescribe(out ColliderMotion motion) => Describe(out motion) == null;

            public void SetForce(in FluidForce force)
            {
                Checked("SetForce");
                forces++;
            }

            public void RaiseContacts(FluidSimulation fluid) { }
            public bool Leave(FluidSimulation fluid) => false;
            public void SaveForce(FluidSimulation fluid, ref ForceRecord record) { }
            public void LoadForce(FluidSimulation fluid, in ForceRecord record, Vector3 moved) { }
            public void RaiseExit(FluidSimulation fluid) { }

            bool Checked(string member) => !Array.Exists(throwsIn.Split(' '), m => m == member) ? true
                : throw new InvalidOperationException("planted in " + member);
        }
    }
}
