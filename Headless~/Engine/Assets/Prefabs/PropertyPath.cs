using System;
using System.Collections.Generic;
using System.Globalization;

namespace Host.Assets
{
    /// <summary>Writes a prefab override ("settings.radii.Array.data[2].x") into a document.</summary>
    internal static class PropertyPath
    {
        const string Size = "Array.size", Data = "Array.data[";

        /// <exception cref="AssetException">The path leads through something that is neither group nor list.</exception>
        public static void Set(YamlMapping root, string path, YamlNode value)
        {
            YamlNode at = root;
            // How to put a changed or new node back where the current one hangs.
            Action<YamlNode> assign = _ => { };
            for (var rest = path; ;)
            {
                if (rest.StartsWith(Size, StringComparison.Ordinal))
                {
                    if (IsPacked(at)) Packed(at, assign).Changes.Add(new KeyValuePair<int, YamlScalar>(YamlPackedList.Size, (YamlScalar)value));
                    else Resize(List(at, assign, path, value.Location), ((YamlScalar)value).ToInt(), value.Location);
                    return;
                }
                Action<YamlNode> put;
                YamlNode next;
                if (rest.StartsWith(Data, StringComparison.Ordinal))
                {
                    var close = rest.IndexOf(']');
                    if (close < 0 || !int.TryParse(rest.AsSpan(Data.Length, close - Data.Length), NumberStyles.None,
                        CultureInfo.InvariantCulture, out var index))
                        throw value.Location.Error($"the override path '{path}' has no number in its brackets");
                    if (IsPacked(at))
                    {
                        Packed(at, assign).Changes.Add(new KeyValuePair<int, YamlScalar>(index, (YamlScalar)value));
                        return;
                    }
                    var list = List(at, assign, path, value.Location);
                    if (index >= list.Elements.Count) Resize(list, index + 1, value.Location);
                    next = list.Elements[index];
                    put = node => list.Elements[index] = node;
                    rest = rest.Substring(close + 1).TrimStart('.');
                }
                else
                {
                    var group = Group(at, assign, path, value.Location);
                    var dot = rest.IndexOf('.');
                    var key = dot < 0 ? rest : rest.Substring(0, dot);
                    next = group.Find(key);
                    put = node => group.Set(key, node);
                    rest = dot < 0 ? "" : rest.Substring(dot + 1);
                }
                if (rest.Length == 0)
                {
                    put(value);
                    return;
                }
                at = next;
                assign = put;
            }
        }

        static bool IsVacant(YamlNode node) => node == null || node is YamlUnset || node is YamlScalar { IsEmpty: true };

        static YamlMapping Group(YamlNode at, Action<YamlNode> assign, string path, SourceLocation location)
        {
            if (at is YamlMapping mapping) return mapping;
            if (!IsVacant(at)) throw location.Error($"the override path '{path}' leads into {at.Kind} of {at.Location}");
            mapping = new YamlMapping(location);
            assign(mapping);
            return mapping;
        }

        static bool IsPacked(YamlNode at) => at is YamlPackedList || at is YamlScalar { IsEmpty: false };

        static YamlPackedList Packed(YamlNode at, Action<YamlNode> assign)
        {
            if (at is YamlPackedList list) return list;
            list = new YamlPackedList((YamlScalar)at);
            assign(list);
            return list;
        }

        static YamlSequence List(YamlNode at, Action<YamlNode> assign, string path, SourceLocation location)
        {
            if (at is YamlSequence list) return list;
            if (!IsVacant(at) && at is not YamlMapping { Entries: { Count: 0 } })
                throw location.Error($"the override path '{path}' takes {at.Kind} of {at.Location} for a list");
            list = new YamlSequence(location);
            assign(list);
            return list;
        }

        /// <summary>New elements repeat the last one, as in the inspector.</summary>
        static void Resize(YamlSequence list, int size, SourceLocation location)
        {
            if (size < 0) throw location.Error($"a list cannot have {size} elements");
            if (size < list.Elements.Count) list.Elements.RemoveRange(size, list.Elements.Count - size);
            while (list.Elements.Count < size)
                list.Elements.Add(list.Elements.Count > 0 ? list.Elements[list.Elements.Count - 1].Clone() : new YamlUnset(location));
        }
    }
}
