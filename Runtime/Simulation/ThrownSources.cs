using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill
{
    /// <summary>Sources of colliders, colliders and passes of scripts that a fluid called in its frame and that threw an exception. One that
    /// throws is left out of that frame alone, and the fluid's time goes on. It is logged once, as Unity logs the exception of a script's
    /// message, with a line that names it.</summary>
    sealed class ThrownSources
    {
        List<object> known;     // null until one has thrown

        /// <param name="source">What has thrown: a component, a collider or a delegate.</param>
        public void Log(Exception problem, object source, FluidSimulation fluid)
        {
            known ??= new List<object>();
            if (known.Contains(source))
                return;
            known.Add(source);
            Object context = (source is Delegate pass ? pass.Target : source) as Object;
            context = context != null ? context : fluid;
            Debug.LogException(problem, context);
            Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' goes on without {NameOf(source)} in each frame in which it throws an " +
                "exception. The first is logged above, and no other: correct what throws it.", context);
        }

        /// <summary>Forgets them all: what throws from here on is logged again.</summary>
        public void Clear() => known = null;

        static string NameOf(object source)
        {
            if (source is Delegate pass)
                return $"the pass {pass.Method.DeclaringType?.Name}.{pass.Method.Name} of BeforeStep";
            string type = source?.GetType().Name ?? "a collider that is null", name = null;
            try
            {
                name = source is IFluidCollider collider ? collider.Name : (source as Object)?.name;
            }
            catch (Exception)       // destroyed: it has only its type
            {
            }
            return name != null ? $"{type} '{name}'" : type;
        }
    }
}
