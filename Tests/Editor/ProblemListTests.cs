using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Editor.Tests
{
    /// <summary>Help boxes: the very texts that are logged.</summary>
    public class ProblemListTests
    {
        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        [Test]
        public void What_is_whole_has_no_problem()
        {
            var fluid = scene.Add<FluidSimulation>();
            foreach (Component whole in new Component[] { fluid, Below<FluidEmitter>(fluid), Below<FluidDrain>(fluid),
                Below<FluidForceField>(fluid), Below<FluidProbe>(fluid), Below<FluidDetector>(fluid), Below<FluidVolume>(fluid),
                Below<FluidCollider>(fluid) })
                Assert.That(ProblemList.Of(new Object[] { whole }), Is.Empty, whole.GetType().Name);
        }

        [Test]
        public void A_part_without_a_fluid_says_so_before_it_plays()
        {
            Assert.That(Problem(scene.Add<FluidDrain>()), Does.StartWith("There is no FluidSimulation on this object or above it"));
            Assert.That(Problem(scene.Add<FluidVolume>()), Does.StartWith("There is no FluidSimulation on this object or above it"));
        }

        [Test]
        public void A_shape_without_a_size_says_so_before_it_plays()
        {
            var fluid = scene.Add<FluidSimulation>();
            FluidDrain drain = Below<FluidDrain>(fluid);
            drain.Size = Vector3.zero;
            Assert.That(Problem(drain), Is.EqualTo("Its box of 0 x 0 x 0 m has no size, so it takes out nothing. Set its size above 0."));
            FluidForceField field = Below<FluidForceField>(fluid);
            field.Bounds = ForceFieldBounds.Sphere;
            field.Radius = 0f;
            Assert.That(Problem(field), Does.StartWith("Its sphere of radius 0 m has no size"));
            FluidEmitter emitter = Below<FluidEmitter>(fluid);
            emitter.Radius = 0f;
            Assert.That(Problem(emitter), Does.Contain("Set it above 0. It lets nothing in."));
            emitter.Radius = 0.1f;
            emitter.Rate = 10f;
            Assert.That(Problem(emitter), Does.StartWith("Its rate of 10 m³/s is more than leaves its shape at rest density"));
            emitter.Rate = 0.01f;
            emitter.Speed = 10f;
            fluid.Material = FluidMaterial.Viscous(1000f, 1e5f);
            Assert.That(Problem(emitter), Does.StartWith("Its jet of thick fluid moves by"));
            FluidCollider collider = Below<FluidCollider>(fluid);
            collider.Shape = ColliderShape.Mesh;
            Assert.That(Problem(collider), Does.StartWith("It is a mesh without a signed distance field"));
            FluidVolume volume = Below<FluidVolume>(fluid);
            volume.Shape = VolumeShape.SignedDistanceField;
            Assert.That(Problem(volume), Does.StartWith("It has no signed distance field"));
        }

        [Test]
        public void A_box_that_holds_no_fluid_says_why_before_it_plays()
        {
            var fluid = scene.Add<FluidSimulation>();
            fluid.Configure(new Vector3(1f, 0.01f, 1f), 0.05f, 1000);
            Assert.That(Problem(fluid), Does.StartWith("Domain size").And.Contain("support radius"));
            fluid.Configure(Vector3.one, 0f, 1000);
            Assert.That(Problem(fluid), Does.StartWith("Particle spacing 0 m"));
        }

        [Test]
        public void What_validation_changed_stays_readable_until_the_next()
        {
            var drain = Below<FluidDrain>(scene.Add<FluidSimulation>());
            LogAssert.Expect(LogType.Warning, new Regex("rate limit -1 is outside"));
            drain.RateLimit = -1f;
            Assert.That(Problem(drain), Does.StartWith("Rate limit -1 is outside 0 to"));
            drain.RateLimit = 1f;
            Assert.That(ProblemList.Of(new Object[] { drain }), Is.Empty);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Several_objects_are_told_apart_by_name()
        {
            FluidDrain a = scene.Add<FluidDrain>("A"), b = scene.Add<FluidDrain>("B");
            List<string> problems = ProblemList.Of(new Object[] { a, b });
            Assert.That(problems.Select(problem => problem.Substring(0, 5)), Is.EqualTo(new[] { "'A': ", "'B': " }));
        }

        [Test]
        public void An_empty_text_is_no_problem()
        {
            var empty = ScriptableObject.CreateInstance<Empty>();
            Assert.That(ProblemList.Of(new Object[] { empty }), Is.Empty);
            Object.DestroyImmediate(empty);
            var problems = new List<string>();
            problems.AddIfAny("");
            problems.AddIfAny(null);
            Assert.That(problems, Is.Empty);
        }

        sealed class Empty : ScriptableObject, IHasProblems
        {
            void IHasProblems.ListProblems(List<string> problems) => problems.Add("");
        }

        T Below<T>(FluidSimulation fluid) where T : Component
        {
            var made = scene.Add<T>();
            made.transform.SetParent(fluid.transform, false);
            return made;
        }

        static string Problem(Object of) => ProblemList.Of(new[] { of }).Single();
    }
}
