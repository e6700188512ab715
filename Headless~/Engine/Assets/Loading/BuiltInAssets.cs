using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>Objects that come with the editor and are known by file id in one of two fixed GUIDs.</summary>
    internal static class BuiltInAssets
    {
        const string Extra = "0000000000000000f000000000000000", Default = "0000000000000000e000000000000000";

        static readonly Dictionary<long, string> Names = new Dictionary<long, string>
        {
            [10202] = "Cube.fbx", [10206] = "Cylinder.fbx", [10207] = "Sphere.fbx", [10208] = "Capsule.fbx", [10209] = "Plane.fbx",
                [10210] = "Quad.fbx",
            [10301] = "Default-Particle.mat", [10302] = "Default-Diffuse.mat", [10303] = "Default-Material.mat",
                [10304] = "Default-Skybox.mat", [10306] = "Default-Line.mat", [10308] = "Default-ParticleSystem.mat",
                [10754] = "Sprites-Default.mat",
            [46] = "Standard", [45] = "Standard (Specular setup)", [7] = "Legacy Shaders/Diffuse", [30] = "Legacy Shaders/Transparent/Diffuse",
            [10750] = "Unlit/Transparent", [10751] = "Unlit/Transparent Cutout", [10752] = "Unlit/Texture", [10753] = "Sprites/Default",
                [10755] = "Unlit/Color",
            [104] = "Skybox/6 Sided", [106] = "Skybox/Procedural",
            // Particles/Additive, Standard Surface and Standard Unlit: particles are not drawn here.
            [200] = "Sprites/Default", [210] = "Sprites/Default", [211] = "Sprites/Default",
        };

        public static bool IsBuiltIn(string guid) => guid == Extra || guid == Default;

        public static bool IsKnown(long fileId) => Names.ContainsKey(fileId);

        public static bool IsMesh(long fileId) => Names.TryGetValue(fileId, out var name) && name.EndsWith(".fbx", StringComparison.Ordinal);

        public static string NameOf(long fileId) => Names.TryGetValue(fileId, out var name) ? $"'{name}'" : $"object {fileId}";

        /// <summary>Null when the engine has none.</summary>
        public static Object Load(long fileId, Type type)
        {
            if (!Names.TryGetValue(fileId, out var name)) return null;
            var found = name.EndsWith(".fbx", StringComparison.Ordinal) || name.EndsWith(".mat", StringComparison.Ordinal)
                ? Resource(type, name)
                : Shader.Find(name);
            return type.IsInstanceOfType(found) ? found : null;
        }

        public static bool TryIdentify(Object asset, out string path, out string guid, out long fileId)
        {
            (path, guid, fileId) = ("", "", 0);
            if (!(asset is Mesh mesh) || !mesh.IsBuiltIn) return false;
            foreach (var known in Names)
                if (known.Value == mesh.name + ".fbx") (path, guid, fileId) = ("Library/unity default resources", Default, known.Key);
            return fileId != 0;
        }

        /// <summary>Works like Resources.GetBuiltinResource, but silently.</summary>
        public static Object Resource(Type type, string name) => Resources.BuiltinResource?.Invoke(type, name);
    }
}
