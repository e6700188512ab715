using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Rill.Tests
{
    /// <summary>Events of components are all of one kind.</summary>
    public class EventsTests
    {
        [Test]
        public void Every_list_in_an_inspector_has_an_event_for_scripts_with_its_name_and_argument_and_no_other_access()
        {
            var wrong = new List<string>();
            int lists = 0;
            foreach (Type component in Components())
            {
                foreach (FieldInfo list in Lists(component))
                {
                    lists++;
                    string name = list.Name.Substring(0, 1).ToUpperInvariant() + list.Name.Substring(1);
                    Type[] arguments = list.FieldType.GetGenericArguments();
                    Type handler = arguments.Length == 0 ? typeof(Action) : typeof(Action<>).MakeGenericType(arguments);
                    if (!list.Name.StartsWith("on") || component.GetEvent(name)?.EventHandlerType != handler)
                        wrong.Add($"{component.Name}.{list.Name}: no event {name} of {handler}");
                }
                foreach (EventInfo happening in component.GetEvents().Where(e => e.Name.StartsWith("On")))
                    if (!Lists(component).Any(list => string.Equals(list.Name, happening.Name, StringComparison.OrdinalIgnoreCase)))
                        wrong.Add($"{component.Name}.{happening.Name}: no list in the inspector");
                wrong.AddRange(component.GetProperties().Where(p => typeof(UnityEventBase).IsAssignableFrom(p.PropertyType))
                    .Select(p => $"{component.Name}.{p.Name}: a list that scripts get"));
            }
            Assert.That(wrong, Is.Empty);
            Assert.That(lists, Is.GreaterThanOrEqualTo(10));
        }

        // Includes the components that need the physics module if it is there.
        static IEnumerable<Type> Components() => AppDomain.CurrentDomain.GetAssemblies()
            .Where(a => a.GetName().Name == "Rill" || a.GetName().Name.StartsWith("Rill.") && !a.GetName().Name.Contains("Tests"))
            .SelectMany(a => a.GetTypes()).Where(type => typeof(MonoBehaviour).IsAssignableFrom(type) && type.IsPublic
                && !type.Namespace.EndsWith("Samples"));

        // Those of its structs too, such as the contacts of a collider.
        static IEnumerable<FieldInfo> Lists(Type of)
        {
            foreach (FieldInfo field in of.GetFields(BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public))
                if (typeof(UnityEventBase).IsAssignableFrom(field.FieldType))
                    yield return field;
                else if (field.FieldType.IsValueType && field.FieldType.Namespace == "Rill")
                    foreach (FieldInfo inner in Lists(field.FieldType))
                        yield return inner;
        }
    }
}
