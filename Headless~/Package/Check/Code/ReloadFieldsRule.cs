using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>
    /// At a reload of scripts Unity backs up every field that it can serialize, private ones too, and null comes back as "", as an empty
    /// array or as a new instance. So a field is a setting, which can never be null, or [NonSerialized].
    /// </summary>
    sealed class ReloadFieldsRule : Rule
    {
        public override string Name => "code: a reload of scripts carries over settings alone";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<Assembly> scripts = PackageScripts.Load(package, findings, withTests: true);
            var open = new Queue<Type>(scripts.SelectMany(assembly => assembly.GetTypes()).Where(IsBackedUp));
            var seen = new HashSet<Type>();
            int fields = 0;
            while (open.Count > 0)
            {
                Type type = open.Dequeue();
                if (!scripts.Contains(type.Assembly) || !seen.Add(type))
                    continue;
                if (type.BaseType != null)
                    open.Enqueue(type.BaseType);
                foreach (FieldInfo field in SerializedFields.BackedUp(type).Where(field => field.DeclaringType == type))
                {
                    fields++;
                    if (field.IsPublic || SerializedFields.IsMarked(field))
                        open.Enqueue(SerializedFields.ElementType(field.FieldType) ?? field.FieldType);
                    else
                        findings.Fault($"{type}.{Shown(field)} of {type.Assembly.GetName().Name} is backed up when scripts are reloaded: " +
                            $"mark it [{(IsProperty(field) ? "field: " : "")}NonSerialized], or [SerializeField] if it is a setting");
                }
            }
            findings.Looked = $"{fields} fields of {seen.Count} classes";
            return findings;
        }

        // Editors and windows are ScriptableObjects. What is [Serializable] may lie in a field of any of them, or behind [SerializeReference].
        static bool IsBackedUp(Type type)
            => typeof(MonoBehaviour).IsAssignableFrom(type) || typeof(ScriptableObject).IsAssignableFrom(type)
            || SerializedFields.CanStore(type) && !type.IsEnum;

        static bool IsProperty(FieldInfo field) => field.Name[0] == '<';

        static string Shown(FieldInfo field) => IsProperty(field) ? field.Name.Substring(1, field.Name.IndexOf('>') - 1) : field.Name;
    }
}
