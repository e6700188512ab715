using System;

namespace UnityEngine.Headless
{
    /// <summary>For members that Unity has and the host has in name only.</summary>
    internal static class Missing
    {
        public static Exception Member(string name) => new NotSupportedException($"UnityEngine.{name} is not part of the headless host");
    }
}
