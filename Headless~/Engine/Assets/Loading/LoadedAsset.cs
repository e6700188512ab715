using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>The live objects of one file, kept so that every reference to it finds the same ones.</summary>
    internal sealed class LoadedAsset
    {
        public readonly AssetEntry Entry;
        /// <summary>Object that the project window shows and Resources.Load returns.</summary>
        public Object Main;
        public readonly Dictionary<long, Object> Objects = new Dictionary<long, Object>();
        /// <summary>By file id, of the objects that prefab instances brought.</summary>
        public readonly Dictionary<long, PrefabOrigin> Origins = new Dictionary<long, PrefabOrigin>();
        /// <summary>In the file, but of a class that the host does not have; a note was given.</summary>
        public readonly HashSet<long> LeftOut = new HashSet<long>();

        public LoadedAsset(AssetEntry entry) => Entry = entry;

        public LoadedAsset With(long fileId, Object main)
        {
            Objects[fileId] = Main = main;
            return this;
        }

        /// <summary>The first object of that type, a prefab root's components included.</summary>
        public Object Find(Type type)
        {
            if (type.IsInstanceOfType(Main)) return Main;
            if (Main is GameObject root) return typeof(Component).IsAssignableFrom(type) ? root.GetComponent(type) : null;
            foreach (var candidate in Objects.Values)
                if (type.IsInstanceOfType(candidate)) return candidate;
            return null;
        }
    }

    /// <summary>Ids of the one object in files that hold one (class id times 100000).</summary>
    internal static class MainFileId
    {
        public const long Material = 2100000, Texture = 2800000, Shader = 4800000, TextAsset = 4900000, ComputeShader = 7200000;
    }
}
