using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A script can set all that the inspector can.</summary>
    public class SettersTests
    {
        // Fields whose property has another name.
        static readonly Dictionary<string, string> Names = new Dictionary<string, string> { ["FluidSimulation.solver"] = "Settings" };

        static IEnumerable<Type> Components => AppDomain.CurrentDomain.GetAssemblies()
            .Where(assembly => assembly == typeof(FluidSimulation).Assembly
                || assembly.GetReferencedAssemblies().Any(name => name.Name == "Rill") && IsOfPackage(assembly.GetName().Name))
            .SelectMany(assembly => assembly.GetTypes())
            .Where(type => type.IsPublic && !type.IsAbstract && typeof(MonoBehaviour).IsAssignableFrom(type))
            .OrderBy(type => type.Name);

        static bool IsOfPackage(string assembly) => assembly == "Rill.Physics" || assembly == "Rill.Terrain" || assembly == "Rill.Universal"
            || assembly == "Rill.HighDefinition";

        [Test]
        public void No_fewer_components_and_fields_are_looked_at_than_there_are()
        {
            Dictionary<string, (int components, int fields)> counts = Components.GroupBy(component => component.Assembly.GetName().Name)
                .ToDictionary(group => group.Key, group => (group.Count(), group.Sum(component => SerializedFields(component)
                .SelectMany(Parts).Count())));
            foreach (var count in counts)
                TestContext.Out.WriteLine(count);
            foreach ((string assembly, int components, int fields) in new[] { ("Rill", 18, 149), ("Rill.Physics", 2, 13), ("Rill.Terrain", 1, 1) })
            {
                Assert.That(counts.TryGetValue(assembly, out (int components, int fields) seen), assembly);
                Assert.That(seen.components, Is.GreaterThanOrEqualTo(components), assembly);
                Assert.That(seen.fields, Is.GreaterThanOrEqualTo(fields), assembly);
            }
        }

        [TestCaseSource(nameof(Components))]
        public void A_script_sets_every_field_that_the_inspector_sets(Type component)
        {
            var without = new List<string>();
            foreach (FieldInfo field in SerializedFields(component).SelectMany(Parts))
                if (!IsSetByListeners(field) && PropertyOf(component, field)?.GetSetMethod() == null)
                    without.Add(field.Name);
            Assert.That(without, Is.Empty, $"fields of {component.Name} without a public property that sets them");
        }

        [TestCaseSource(nameof(Components))]
        public void What_a_script_sets_is_what_the_field_then_holds(Type component)
        {
            var gameObject = new GameObject("Set");
            gameObject.SetActive(false);
            try
            {
                Component made = gameObject.AddComponent(component);
                foreach (FieldInfo field in SerializedFields(component))
                {
                    PropertyInfo property = PropertyOf(component, field);
                    if (IsSetByListeners(field) || !TryGetOther(field, made, out object other))
                        continue;
                    object before = field.GetValue(made);
                    property.SetValue(made, other);
                    Assert.That(field.GetValue(made), Is.Not.EqualTo(before), $"{component.Name}.{property.Name} set to {other}");
                    Assert.That(property.GetValue(made), Is.EqualTo(field.GetValue(made)), $"{component.Name}.{property.Name} read back");
                }
            }
            finally
            {
                Object.DestroyImmediate(gameObject);
            }
        }

        [Test]
        public void Step_rate_and_seed_act_at_run_time_and_another_capacity_keeps_the_water()
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 0.5f), 0.1f, 1000).Fill(0.4f).Step(3))
            {
                scene.Fluid.StepRate = 120f;
                scene.Step(2);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(7), "two steps in each of the last frames");
                scene.Fluid.MaxStepsPerFrame = 1;
                scene.Step(2);
                Assert.That(scene.Fluid.StepCount, Is.EqualTo(9));
                ParticleState first = scene.Read();
                scene.Fluid.Capacity = 300;
                Assert.That(scene.Fluid.Solver.Layout.Capacity, Is.EqualTo(1000), "until the water has come");
                UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
                scene.Step();
                Assert.That(scene.Fluid.Solver.Layout.Capacity, Is.EqualTo(300));
                Assert.That(scene.Fluid.StepCount, Is.GreaterThan(9));
                Assert.That(scene.Read().Count, Is.EqualTo(first.Count));
                scene.Fluid.Seed = 2;
                scene.Fluid.Restart();
                Unity.Mathematics.float4[] other = scene.Read().positions;
                scene.Fluid.Seed = 1;
                scene.Fluid.Restart();
                Assert.That(scene.Read().positions, Is.Not.EqualTo(other));
                Assert.That(first.Count, Is.EqualTo(other.Length));
            }
        }

        static IEnumerable<FieldInfo> SerializedFields(Type component)
        {
            for (Type type = component; type != null && type != typeof(MonoBehaviour); type = type.BaseType)
                foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public
                    | BindingFlags.DeclaredOnly))
                    if ((field.IsPublic || field.IsDefined(typeof(SerializeField))) && !field.IsDefined(typeof(HideInInspector))
                        && !field.IsDefined(typeof(NonSerializedAttribute)))
                        yield return field;
        }

        static PropertyInfo PropertyOf(Type component, FieldInfo field)
        {
            if (!Names.TryGetValue($"{field.DeclaringType.Name}.{field.Name}", out string name))
                name = field.Name.Substring(0, 1).ToUpperInvariant() + field.Name.Substring(1);
            return component.GetProperty(name, BindingFlags.Instance | BindingFlags.Public);
        }

        // A struct that scripts cannot name is set by properties of the component, one for each field.
        static IEnumerable<FieldInfo> Parts(FieldInfo field) =>
            field.FieldType.IsNotPublic && field.FieldType.IsValueType ? SerializedFields(field.FieldType) : new[] { field };

        // A script adds listeners to an event and does not replace it.
        static bool IsSetByListeners(FieldInfo field) => typeof(UnityEventBase).IsAssignableFrom(field.FieldType);

        // Another value within the range of most settings; none for references and structs.
        static bool TryGetOther(FieldInfo field, Component of, out object other)
        {
            object now = field.GetValue(of);
            other = null;
            if (now is bool flag)
                other = !flag;
            else if (now is LayerMask)
                other = (LayerMask)(1 << 5);
            else if (now is Color)
                other = new Color(0.5f, 0.25f, 0.125f);
            else if (now is Vector3)
                other = new Vector3(0.75f, 0.5f, 0.25f);
            else if (now is int number)
                other = number == 3 ? 4 : 3;
            else if (now is float value)
                other = value == 0.5f ? 0.25f : 0.5f;
            else if (now != null && field.FieldType.IsEnum)
                other = Enum.GetValues(field.FieldType).Cast<object>().FirstOrDefault(each => !each.Equals(now));
            if (field.Name == "stepRate")
                other = 100f;
            return other != null;
        }
    }
}
