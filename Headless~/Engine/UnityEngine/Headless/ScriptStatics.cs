using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Emit;

namespace UnityEngine.Headless
{
    /// <summary>The statics of scripts as a new domain has them: each type's initializer runs again, after those of the types that it uses.
    /// Statics of generic types stay, since the arguments in use are unknown.</summary>
    internal sealed class ScriptStatics
    {
        const BindingFlags Static = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        readonly HashSet<Type> open;

        ScriptStatics(IEnumerable<Type> types) => open = types.ToHashSet();

        /// <summary>Sets all to their first values.</summary>
        /// <param name="waits">Whether a type's initializer is left for <see cref="Initialize"/>, unless another uses it.</param>
        public static ScriptStatics Reset(Predicate<Type> waits)
        {
            List<Type> types = ScriptAssemblies.Loaded.SelectMany(assembly => assembly.GetTypes())
                .Where(type => !type.ContainsGenericParameters && !type.Name.StartsWith("<PrivateImplementationDetails>", StringComparison.Ordinal))
                .ToList();
            foreach (FieldInfo field in types.SelectMany(type => type.GetFields(Static)))
                if (!field.IsLiteral && !field.IsInitOnly && !field.FieldType.IsPointer)
                    field.SetValue(null, field.FieldType.IsValueType ? Activator.CreateInstance(field.FieldType) : null);
            var statics = new ScriptStatics(types.Where(type => type.TypeInitializer != null));
            foreach (Type type in types.Where(type => !waits(type)))
                statics.Initialize(type);
            return statics;
        }

        /// <summary>Runs a type's initializer, unless it has run already.</summary>
        public void Initialize(Type type)
        {
            if (!open.Remove(type))
                return;
            foreach (Type used in UsedBy(type.TypeInitializer))
                Initialize(used);
            try
            {
                Call(type.TypeInitializer);
            }
            catch (Exception e)
            {
                Debug.LogException(new TypeInitializationException(type.FullName, e));
            }
        }

        // Reflection runs an initializer once alone; its code runs as often as it is called.
        static unsafe void Call(ConstructorInfo initializer) => ((delegate*<void>)initializer.MethodHandle.GetFunctionPointer())();

        // Whose statics and methods it names, which would have their types initialized first.
        static IEnumerable<Type> UsedBy(ConstructorInfo initializer)
        {
            foreach ((OpCode op, int operand) in Il.Instructions(initializer.GetMethodBody().GetILAsByteArray()))
                if (op.OperandType == OperandType.InlineField || op.OperandType == OperandType.InlineMethod)
                    if (initializer.Module.ResolveMember(operand).DeclaringType is Type type)
                        yield return type;
        }
    }
}
