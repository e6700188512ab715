using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Shader property names as small integers, the same for a whole run.</summary>
    internal static class PropertyNames
    {
        static readonly Dictionary<string, int> ids = new Dictionary<string, int>();
        static readonly List<string> names = new List<string>();

        public static int ToId(string name)
        {
            if (name == null)
                throw new System.ArgumentNullException(nameof(name));
            if (!ids.TryGetValue(name, out int id))
            {
                id = names.Count;
                names.Add(name);
                ids.Add(name, id);
            }
            return id;
        }

        public static string ToName(int id) => id >= 0 && id < names.Count ? names[id] : $"<property {id}>";
    }
}
