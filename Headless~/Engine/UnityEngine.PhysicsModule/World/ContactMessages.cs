using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Messages of contacts go to the scripts beside a collider and to those beside its body, disabled ones too.</summary>
    internal static class ContactMessages
    {
        static readonly Dictionary<(Type, string), bool> heard = new Dictionary<(Type, string), bool>();

        public static bool IsHeard(Collider collider, string message)
        {
            if (collider == null)
                return false;
            Rigidbody body = collider.attachedRigidbody;
            return IsHeard(collider.gameObject, message) || body != null && body.gameObject != collider.gameObject
                && IsHeard(body.gameObject, message);
        }

        public static void Send(Collider to, string message, object about)
        {
            if (!IsHeard(to, message) || about is Collider other && other == null)
                return;
            Rigidbody body = to.attachedRigidbody;
            Messages.Broadcast(to.gameObject, message, about);
            if (body != null && to != null && body.gameObject != to.gameObject)
                Messages.Broadcast(body.gameObject, message, about);
        }

        static bool IsHeard(GameObject thing, string message)
        {
            foreach (Component component in thing.Components)
                if (component is MonoBehaviour script && Has(script.GetType(), message))
                    return true;
            return false;
        }

        static bool Has(Type type, string message)
        {
            if (heard.TryGetValue((type, message), out bool has))
                return has;
            for (Type at = type; at != null && at != typeof(MonoBehaviour) && !has; at = at.BaseType)
                foreach (MethodInfo method in at.GetMethods(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic
                    | BindingFlags.DeclaredOnly))
                    has |= method.Name == message;
            heard.Add((type, message), has);
            return has;
        }
    }
}
