using System;
using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine.Headless;

namespace UnityEngine.Headless
{
    /// <summary>The keywords that one shader asset declares.</summary>
    internal sealed class KeywordSpace
    {
        public readonly string Owner;
        public readonly string[] Names;
        readonly Dictionary<string, int> indices = new Dictionary<string, int>();

        public KeywordSpace(string owner, IReadOnlyList<string> names)
        {
            Owner = owner;
            Names = new string[names.Count];
            for (int i = 0; i < names.Count; i++)
            {
                Names[i] = names[i];
                indices[names[i]] = i;
            }
        }

        public bool Has(string name) => indices.ContainsKey(name);
    }

    /// <summary>Which keywords are enabled on one object; <see cref="Version"/> changes with every change.</summary>
    internal sealed class KeywordSet
    {
        readonly HashSet<string> enabled = new HashSet<string>();

        public int Version { get; private set; }
        public ICollection<string> Enabled => enabled;

        public bool Has(string name) => enabled.Contains(name);

        public void Set(string name, bool value)
        {
            if (string.IsNullOrEmpty(name))
                return;
            if (value ? enabled.Add(name) : enabled.Remove(name))
                Version++;
        }

        public void Replace(IEnumerable<string> names)
        {
            enabled.Clear();
            foreach (string name in names)
                if (!string.IsNullOrEmpty(name))
                    enabled.Add(name);
            Version++;
        }

        public string[] ToArray()
        {
            var array = new string[enabled.Count];
            enabled.CopyTo(array);
            Array.Sort(array, StringComparer.Ordinal);
            return array;
        }
    }

    internal static class GlobalKeywords
    {
        public static readonly KeywordSet Set = new KeywordSet();
        public static readonly List<string> Known = new List<string>();

        public static void Create(string name)
        {
            if (!Known.Contains(name))
                Known.Add(name);
        }
    }
}

namespace UnityEngine.Rendering
{
    public readonly struct LocalKeyword : IEquatable<LocalKeyword>
    {
        readonly string keyword;
        internal readonly KeywordSpace Space;

        public LocalKeyword(Shader shader, string name)
            : this(shader == null ? throw new ArgumentNullException(nameof(shader)) : shader.Keywords, name) { }
        public LocalKeyword(ComputeShader shader, string name)
            : this(shader == null ? throw new ArgumentNullException(nameof(shader)) : shader.Keywords, name) { }

        internal LocalKeyword(KeywordSpace space, string name)
        {
            Space = space;
            keyword = name;
            if (!space.Has(name))
            {
                GpuError.Report($"Shader '{space.Owner}' declares no keyword '{name}'; it has: " +
                    $"{(space.Names.Length == 0 ? "none" : string.Join(", ", space.Names))}.",
                    $"Local keyword {name} doesn't exist in the shader {space.Owner}.");
                Space = null;
            }
        }

        public string name => keyword ?? "";
        public bool isValid => Space != null;
        public bool isDynamic => false;
        public bool isOverridable => Space != null;
        public ShaderKeywordType type => Space == null ? ShaderKeywordType.None : ShaderKeywordType.UserDefined;

        public bool Equals(LocalKeyword rhs) => Space == rhs.Space && keyword == rhs.keyword;
        public override bool Equals(object o) => o is LocalKeyword other && Equals(other);
        public override int GetHashCode() => HashCode.Combine(Space, keyword);
        public override string ToString() => name;
        public static bool operator ==(LocalKeyword lhs, LocalKeyword rhs) => lhs.Equals(rhs);
        public static bool operator !=(LocalKeyword lhs, LocalKeyword rhs) => !lhs.Equals(rhs);
    }

    public readonly struct LocalKeywordSpace : IEquatable<LocalKeywordSpace>
    {
        readonly KeywordSpace space;
        internal LocalKeywordSpace(KeywordSpace space) => this.space = space;

        public uint keywordCount => space == null ? 0 : (uint)space.Names.Length;
        public string[] keywordNames => space == null ? Array.Empty<string>() : (string[])space.Names.Clone();
        public LocalKeyword[] keywords
        {
            get
            {
                if (space == null)
                    return Array.Empty<LocalKeyword>();
                var all = new LocalKeyword[space.Names.Length];
                for (int i = 0; i < all.Length; i++)
                    all[i] = new LocalKeyword(space, space.Names[i]);
                return all;
            }
        }

        /// <summary>An invalid keyword when the shader does not declare the name.</summary>
        public LocalKeyword FindKeyword(string name) => space != null && space.Has(name) ? new LocalKeyword(space, name) : default;

        public bool Equals(LocalKeywordSpace rhs) => space == rhs.space;
        public override bool Equals(object o) => o is LocalKeywordSpace other && Equals(other);
        public override int GetHashCode() => space == null ? 0 : space.GetHashCode();
        public static bool operator ==(LocalKeywordSpace lhs, LocalKeywordSpace rhs) => lhs.Equals(rhs);
        public static bool operator !=(LocalKeywordSpace lhs, LocalKeywordSpace rhs) => !lhs.Equals(rhs);
    }

    public readonly struct GlobalKeyword
    {
        readonly string keyword;
        public GlobalKeyword(string name)
        {
            keyword = name;
            GlobalKeywords.Create(name);
        }

        public string name => keyword ?? "";
        public static GlobalKeyword Create(string name) => new GlobalKeyword(name);
        public override string ToString() => name;
    }

    public struct ShaderTagId : IEquatable<ShaderTagId>
    {
        readonly string tag;
        public static readonly ShaderTagId none = default;
        public ShaderTagId(string name) => tag = name;
        public string name => tag ?? "";
        public bool Equals(ShaderTagId other) => name == other.name;
        public override bool Equals(object obj) => obj is ShaderTagId other && Equals(other);
        public override int GetHashCode() => name.GetHashCode();
        public static bool operator ==(ShaderTagId tag1, ShaderTagId tag2) => tag1.Equals(tag2);
        public static bool operator !=(ShaderTagId tag1, ShaderTagId tag2) => !tag1.Equals(tag2);
        public static explicit operator ShaderTagId(string name) => new ShaderTagId(name);
        public static explicit operator string(ShaderTagId tagId) => tagId.name;
    }
}

namespace UnityEngine.Headless
{
    internal static class KeywordUnion
    {
        static readonly HashSet<string> union = new HashSet<string>();

        /// <summary>Local and global keywords together; the set is reused by the next call.</summary>
        /// <param name="more">One that the draw adds; null for none.</param>
        public static ICollection<string> Of(KeywordSet local, KeywordSet global, string more = null)
        {
            union.Clear();
            if (more != null)
                union.Add(more);
            foreach (string name in local.Enabled)
                union.Add(name);
            foreach (string name in global.Enabled)
                union.Add(name);
            return union;
        }

        public static LocalKeyword[] Local(KeywordSpace space, KeywordSet set)
        {
            var list = new List<LocalKeyword>();
            foreach (string name in space.Names)
                if (set.Has(name))
                    list.Add(new LocalKeyword(space, name));
            return list.ToArray();
        }

        /// <summary>A keyword of another shader does nothing in Unity but log.</summary>
        public static bool Belongs(in LocalKeyword keyword, KeywordSpace space)
        {
            if (keyword.Space == space)
                return true;
            GpuError.Report($"Keyword '{keyword.name}' belongs to " +
                $"{(keyword.Space == null ? "no shader" : $"'{keyword.Space.Owner}'")}, not to '{space.Owner}'.",
                $"Keyword space of the local keyword {keyword.name} doesn't match shader {space.Owner}.");
            return false;
        }
    }
}
