using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Host.Assets;
using UnityEditor;
using UnityEditor.Build;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Check.Build
{
    /// <summary>A list of references that the project's build steps change in a component of a scene.</summary>
    sealed class ChangedReferences
    {
        public MonoBehaviour Component;
        /// <summary>Names of the fields from the component's own to the list.</summary>
        public string[] Path;
        public Object[] Before, After;
    }

    /// <summary>A scene as it goes into a build: after the Editor scripts that implement IProcessSceneWithReport.</summary>
    static class BuiltScene
    {
        /// <summary>Opens a scene that is not woken, runs the build steps of these assemblies on it and tells what they changed.</summary>
        /// <param name="project">Also what <see cref="Player.Assets"/> is.</param>
        public static List<ChangedReferences> Process(ProjectAssets project, AssetEntry entry, IEnumerable<Assembly> scripts)
        {
            EditorInitializers.Run();
            Scene scene = project.ReadScene(entry);
            List<MonoBehaviour> components = scene.GetRootGameObjects()
                .SelectMany(root => root.GetComponentsInChildren<MonoBehaviour>(true)).Where(component => component != null).ToList();
            List<List<(string[] path, Object[] references)>> before = components.ConvertAll(Lists);
            foreach (IProcessSceneWithReport step in Steps(scripts))
                step.OnProcessScene(scene, null);

            var changed = new List<ChangedReferences>();
            for (int i = 0; i < components.Count; i++)
                foreach ((string[] path, Object[] references) in Lists(components[i]))
                {
                    Object[] stored = before[i].Find(list => list.path.SequenceEqual(path)).references ?? Array.Empty<Object>();
                    if (!stored.SequenceEqual(references, ReferenceEqualityComparer.Instance))
                        changed.Add(new ChangedReferences { Component = components[i], Path = path, Before = stored, After = references });
                }
            return changed;
        }

        static IEnumerable<IProcessSceneWithReport> Steps(IEnumerable<Assembly> scripts) => scripts.SelectMany(assembly => assembly.GetTypes())
            .Where(type => typeof(IProcessSceneWithReport).IsAssignableFrom(type) && !type.IsAbstract)
            .Select(type => (IProcessSceneWithReport)Activator.CreateInstance(type, nonPublic: true)).OrderBy(step => step.callbackOrder);

        // Lists of the component and of the serializable classes in it.
        static List<(string[], Object[])> Lists(MonoBehaviour component)
        {
            var lists = new List<(string[], Object[])>();
            Collect(component, Array.Empty<string>(), lists);
            return lists;
        }

        static void Collect(object owner, string[] path, List<(string[], Object[])> lists)
        {
            foreach (MappedField field in FieldMap.Of(owner.GetType()))
            {
                string[] here = path.Append(field.Info.Name).ToArray();
                object value = field.Info.GetValue(owner);
                if (FieldMap.ElementOf(field.Type) is Type element)
                {
                    if (typeof(Object).IsAssignableFrom(element))
                        lists.Add((here, ((IList)value)?.Cast<Object>().ToArray() ?? Array.Empty<Object>()));
                }
                else if (value != null && field.Type.IsDefined(typeof(SerializableAttribute), false) && field.Type.IsClass
                    && field.Type != typeof(string) && !FieldMap.IsEngine(field.Type))
                {
                    Collect(value, here, lists);
                }
            }
        }
    }
}
