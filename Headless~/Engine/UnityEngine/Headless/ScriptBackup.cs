using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>State of one script object that a reload of scripts carries over. The object stays the same in C#, and is otherwise made
    /// again.</summary>
    internal sealed class ScriptBackup
    {
        const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        readonly Object script;
        readonly (FieldInfo field, object value)[] values;

        /// <summary>Serializes its fields, private ones too.</summary>
        public ScriptBackup(Object script)
        {
            this.script = script;
            values = SerializedFields.BackedUp(script.GetType()).Where(field => !ScriptAssemblies.IsEngines(field.DeclaringType.Assembly))
                .Select(field => (field, SerializedCopy.BackUp(field, field.GetValue(script)))).ToArray();
        }

        /// <summary>Runs its constructor, with all that is of the script at its default before. What the engine's base classes hold is
        /// native in Unity, and stays.</summary>
        public void Construct()
        {
            var native = new List<(FieldInfo field, object value)>();
            for (Type type = script.GetType(); type != typeof(object); type = type.BaseType)
                foreach (FieldInfo field in type.GetFields(Own))
                    if (ScriptAssemblies.IsEngines(type.Assembly))
                        native.Add((field, field.GetValue(script)));
                    else
                        field.SetValue(script, field.FieldType.IsValueType ? Activator.CreateInstance(field.FieldType) : null);
            try
            {
                ObjectFactory.Construct(script);
            }
            catch (Exception e)
            {
                Debug.LogException(e, script);
            }
            ObjectRegistry.Remove(script);      // under the id that the constructor took
            foreach ((FieldInfo field, object value) in native)
                field.SetValue(script, value);
        }

        /// <summary>Deserializes them.</summary>
        public void Restore()
        {
            foreach ((FieldInfo field, object value) in values)
                SerializedCopy.Restore(field, script, value);
        }
    }
}
