using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace Host
{
    /// <summary>Methods that Unity would call and the host never does.</summary>
    static class UnheardMessages
    {
        static readonly string[] Names =
        {
            "OnGUI", "OnAnimatorMove", "OnAnimatorIK", "OnAudioFilterRead", "OnCollisionEnter2D", "OnCollisionStay2D", "OnCollisionExit2D",
            "OnTriggerEnter2D", "OnTriggerStay2D", "OnTriggerExit2D", "OnControllerColliderHit",
            "OnMouseDown", "OnMouseUp", "OnMouseUpAsButton", "OnMouseDrag", "OnMouseEnter", "OnMouseExit", "OnMouseOver",
                "OnParticleCollision", "OnParticleTrigger", "OnParticleSystemStopped",
            "OnApplicationPause", "OnApplicationFocus",
        };

        /// <summary>"OnGUI of FlockHud".</summary>
        public static IEnumerable<string> Of(IEnumerable<Assembly> scripts) =>
            from assembly in scripts
            from type in assembly.GetTypes()
            where typeof(MonoBehaviour).IsAssignableFrom(type) && !type.Assembly.GetName().Name.StartsWith("UnityEngine.", StringComparison.Ordinal)
            from method in type.GetMethods(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)
            where Array.IndexOf(Names, method.Name) >= 0
            select $"{method.Name} of {type.Name}";
    }
}
