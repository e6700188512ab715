using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Host.Testing
{
    /// <summary>Settings of the engine that scripts can change for all that comes after them: the public statics with a value that can be
    /// set, and what the player pretends to be.</summary>
    sealed class EngineStatics
    {
        const BindingFlags Declared = BindingFlags.Static | BindingFlags.Public | BindingFlags.DeclaredOnly;

        // Their values go on by themselves: random numbers, and the view that was drawn last.
        static readonly Type[] Running = { typeof(UnityEngine.Random), typeof(GL) };

        static readonly string[] OfPlayer = { nameof(Player.Strict), nameof(Player.ScreenWidth), nameof(Player.ScreenHeight),
            nameof(Player.LinearColorSpace), nameof(Player.GpuTimes), nameof(Player.TimesKernels), nameof(Player.Limits), nameof(Player.PipelineTag),
            nameof(Player.PipelinePackage), nameof(Player.PipelineVersion), nameof(Player.Stereo), nameof(Player.PretendNoCompute) };

        readonly List<Value> values = Members().Select(member => new Value(member)).ToList();

        /// <summary>Sets all to the values of when this was made.</summary>
        /// <returns>Those that differed, each with both values.</returns>
        public List<string> PutBack() => values.Select(value => value.PutBack()).Where(change => change != null).ToList();

        static IEnumerable<MemberInfo> Members()
        {
            foreach (Type type in new[] { typeof(Application).Assembly, typeof(Physics).Assembly }.SelectMany(assembly => assembly.GetExportedTypes())
                .Where(type => !type.ContainsGenericParameters && !Running.Contains(type)))
            {
                foreach (PropertyInfo property in type.GetProperties(Declared))
                    if (property.GetGetMethod() != null && property.GetSetMethod() != null && property.GetIndexParameters().Length == 0
                        && IsSetting(property.PropertyType) && !property.IsDefined(typeof(ObsoleteAttribute)))
                        yield return property;
                foreach (FieldInfo field in type.GetFields(Declared))
                    if (!field.IsLiteral && !field.IsInitOnly && IsSetting(field.FieldType))
                        yield return field;
            }
            foreach (string name in OfPlayer)
                yield return typeof(Player).GetField(name);
        }

        static bool IsSetting(Type type) => type.IsValueType || type == typeof(string) || type == typeof(RenderPipelineAsset);

        sealed class Value
        {
            readonly MemberInfo member;
            readonly object first;

            public Value(MemberInfo member)
            {
                this.member = member;
                first = Current;
            }

            object Current
            {
                get => member is PropertyInfo property ? property.GetValue(null) : ((FieldInfo)member).GetValue(null);
                set
                {
                    if (member is PropertyInfo property)
                        property.SetValue(null, value);
                    else
                        ((FieldInfo)member).SetValue(null, value);
                }
            }

            public string PutBack()
            {
                object now = Current;
                if (Equals(now, first))
                    return null;
                Current = first;
                return Invariant($"{member.DeclaringType.Name}.{member.Name} at {now ?? "null"} instead of {first ?? "null"}");
            }
        }
    }
}
