using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Headless
{
    internal static class ExecutionOrder
    {
        /// <summary>From scripts' .meta files (executionOrder); goes before the attribute.</summary>
        public static readonly Dictionary<Type, int> FromMeta = new Dictionary<Type, int>();
        static readonly Dictionary<Type, int> fromAttributes = new Dictionary<Type, int>();

        public static int Of(Type type)
        {
            if (FromMeta.TryGetValue(type, out int order))
                return order;
            if (!fromAttributes.TryGetValue(type, out order))
            {
                order = type.GetCustomAttribute<DefaultExecutionOrder>(true)?.order ?? 0;
                fromAttributes.Add(type, order);
            }
            return order;
        }
    }
}
