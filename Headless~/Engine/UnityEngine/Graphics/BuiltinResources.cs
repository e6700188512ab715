using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Resources that Resources.GetBuiltinResource and scene files find by name, and GameObject.CreatePrimitive uses.</summary>
    internal static class BuiltinResources
    {
        const string DefaultMaterialName = "Default-Material.mat", ErrorMaterialName = "Error.mat";

        // Material file to shader.
        static readonly Dictionary<string, string> materialShaders = new Dictionary<string, string>
        {
            [DefaultMaterialName] = "Standard", ["Default-Diffuse.mat"] = "Legacy Shaders/Diffuse", ["Default-Skybox.mat"] = "Skybox/Procedural",
            [ErrorMaterialName] = "Hidden/InternalErrorShader",
            // Neither particles nor lines are drawn here: their materials are there for who refers to them.
            ["Default-Particle.mat"] = "Sprites/Default", ["Default-ParticleSystem.mat"] = "Sprites/Default",
                ["Default-Line.mat"] = "Sprites/Default", ["Sprites-Default.mat"] = "Sprites/Default",
        };
        static readonly Dictionary<string, Material> materials = new Dictionary<string, Material>();

        /// <summary>Set by the part that compiles shaders: a shader that comes with the editor, by its name; null when there is none.</summary>
        public static Func<string, Shader> FindShader;

        public static Object Find(Type type, string name)
        {
            Object found = null;
            if (type.IsAssignableFrom(typeof(Mesh)) && name.EndsWith(".fbx", StringComparison.Ordinal))
                found = BuiltinMeshes.Find(name);
            else if (type.IsAssignableFrom(typeof(Material)) && materialShaders.ContainsKey(name))
                found = MaterialOf(name);
            else if (type.IsAssignableFrom(typeof(Shader)))
                found = FindShader?.Invoke(name);
            return type.IsInstanceOfType(found) ? found : null;
        }

        /// <summary>Null, and nothing is drawn with it, when there is no Standard shader.</summary>
        public static Material DefaultMaterial => MaterialOf(DefaultMaterialName);

        /// <summary>Magenta, for what a broken shader should have drawn; null without built-in shaders.</summary>
        public static Material ErrorMaterial => MaterialOf(ErrorMaterialName);

        static Material MaterialOf(string file)
        {
            if (materials.TryGetValue(file, out Material material) && material != null)
                return material;
            // Its shader is the editor's, even where a project has one of that name.
            if (!(FindShader?.Invoke(materialShaders[file]) is Shader shader))
                return null;
            material = new Material(shader) { name = file.Substring(0, file.Length - ".mat".Length), hideFlags = HideFlags.HideAndDontSave,
                IsAsset = true };
            return materials[file] = material;
        }

        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var primitive = new GameObject(type.ToString());
            primitive.AddComponent<MeshFilter>().sharedMesh = BuiltinMeshes.Of(type);
            primitive.AddComponent<MeshRenderer>().sharedMaterial = DefaultMaterial;
            PhysicsLoop.Current?.AddCollider(primitive, type);
            return primitive;
        }

        public static void Reset()
        {
            foreach (Material material in materials.Values)
                Object.DestroyImmediate(material, true);
            materials.Clear();
            Sky.Reset();
            BuiltinMeshes.Reset();
        }
    }
}
