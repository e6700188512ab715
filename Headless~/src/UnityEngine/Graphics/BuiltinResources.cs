using System;

namespace UnityEngine.Headless
{
    /// <summary>What Resources.GetBuiltinResource and scene files find by name, and GameObject.CreatePrimitive is made of.</summary>
    internal static class BuiltinResources
    {
        const string DefaultMaterialName = "Default-Material.mat";

        static Material defaultMaterial;

        /// <summary>Set by the part that compiles shaders: a shader that comes with the editor, by its name; null when there is none.</summary>
        public static Func<string, Shader> FindShader;

        public static Object Find(Type type, string name)
        {
            Object found = null;
            if (type.IsAssignableFrom(typeof(Mesh)) && name.EndsWith(".fbx", StringComparison.Ordinal))
                found = BuiltinMeshes.Find(name);
            else if (type.IsAssignableFrom(typeof(Material)) && name == DefaultMaterialName)
                found = DefaultMaterial;
            else if (type.IsAssignableFrom(typeof(Shader)))
                found = FindShader?.Invoke(name);
            return type.IsInstanceOfType(found) ? found : null;
        }

        /// <summary>Null, and nothing is drawn with it, when there is no Standard shader.</summary>
        public static Material DefaultMaterial
        {
            get
            {
                if (defaultMaterial == null && Shader.Find("Standard") is Shader standard)
                    defaultMaterial = new Material(standard) { name = "Default-Material", hideFlags = HideFlags.HideAndDontSave, IsAsset = true };
                return defaultMaterial;
            }
        }

        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var primitive = new GameObject(type.ToString());
            primitive.AddComponent<MeshFilter>().sharedMesh = BuiltinMeshes.Of(type);
            primitive.AddComponent<MeshRenderer>().sharedMaterial = DefaultMaterial;
            return primitive;
        }

        public static void Forget()
        {
            if (defaultMaterial is object)
                Object.DestroyImmediate(defaultMaterial, true);
            defaultMaterial = null;
            BuiltinMeshes.Forget();
        }
    }
}
