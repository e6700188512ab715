using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Assets
{
    /// <summary>
    /// Replaces each PrefabInstance document by a prefab's documents, overrides applied, so that what turns
    /// documents into objects never meets a prefab. Prefabs in prefabs and variants need nothing more: a prefab file is
    /// expanded before its documents are copied.
    /// </summary>
    internal sealed class PrefabExpander
    {
        public const int GameObject = 1, Transform = 4, RectTransform = 224, PrefabInstance = 1001;

        readonly Func<FileReference, string, UnityYaml> loadPrefab;
        readonly Action<string> warn;

        /// <param name="loadPrefab">The expanded documents of the prefab meant by a reference, or null after it has
        /// reported why there are none; the text says which instance asks.</param>
        public PrefabExpander(Func<FileReference, string, UnityYaml> loadPrefab, Action<string> warn)
        {
            this.loadPrefab = loadPrefab;
            this.warn = warn;
        }

        public UnityYaml Expand(UnityYaml source)
        {
            if (!source.Documents.Any(d => d.ClassId == PrefabInstance)) return source;

            var result = new UnityYaml(source.File);
            foreach (var document in source.Documents)
                if (document.ClassId != PrefabInstance && !document.Stripped) result.Add(document);

            var standIns = source.Documents.Where(d => d.Stripped).ToLookup(d => InstanceOf(d));
            foreach (var document in source.Documents)
                if (document.ClassId == PrefabInstance && !IsOldPrefabHeader(document))
                    new Instance(this, document, standIns[document.FileId]).AddTo(result);
            return result;
        }

        // Editors before 2018.3 named these differently and put such a document into the prefab's own file too.
        static long InstanceOf(UnityDocument stripped) => Either(stripped.Fields, "m_PrefabInstance", "m_PrefabInternal").FileId;
        static long SourceOf(UnityDocument stripped) => Either(stripped.Fields, "m_CorrespondingSourceObject", "m_PrefabParentObject").FileId;
        static bool IsOldPrefabHeader(UnityDocument document) => document.Fields.Bool("m_IsPrefabParent") || document.Fields.Bool("m_IsPrefabAsset");
        static FileReference Either(YamlNode fields, string key, string oldKey) => FileReference.Of(fields[key] ?? fields[oldKey]);

        sealed class Instance
        {
            readonly PrefabExpander owner;
            readonly UnityDocument instance;
            readonly YamlNode modification;
            readonly Dictionary<long, long> standIns = new Dictionary<long, long>();

            public Instance(PrefabExpander owner, UnityDocument instance, IEnumerable<UnityDocument> stripped)
            {
                this.owner = owner;
                this.instance = instance;
                modification = instance.Fields["m_Modification"] ?? new YamlMapping(instance.Location);
                foreach (var document in stripped) standIns[SourceOf(document)] = document.FileId;
            }

            public void AddTo(UnityYaml result)
            {
                var prefab = owner.loadPrefab(Either(instance.Fields, "m_SourcePrefab", "m_ParentPrefab"), $"the prefab instance {instance.FileId}");
                if (prefab == null)
                {
                    result.LeftOut.UnionWith(standIns.Values);
                    return;
                }
                foreach (var id in prefab.LeftOut) result.LeftOut.Add(IdHere(id));

                var kept = prefab.Documents.Where(d => !Removed(prefab).Contains(d.FileId)).ToDictionary(d => d.FileId,
                    d => d.Clone(IdHere(d.FileId)));
                foreach (var (target, document) in kept) document.Origin = new PrefabOrigin(instance.FileId, target);
                foreach (var document in kept.Values) Relink(document.Fields, kept);
                foreach (var document in kept.Values)
                    if (IsTransform(document) && document.Fields.Reference("m_Father").IsNone)
                    {
                        document.Fields.Set("m_Father", modification["m_TransformParent"] ?? Reference(0, instance.Location));
                        // A scene lists its roots by their instances.
                        document.Fields.Set("m_PrefabInstance", Reference(instance.FileId, instance.Location));
                    }
                foreach (var change in modification.Items("m_Modifications")) Apply(change, kept);
                foreach (var document in prefab.Documents)
                    if (kept.TryGetValue(document.FileId, out var copy)) result.Add(copy);
            }

            /// <summary>The id of a stripped document if the file has one, otherwise the one that the editor makes up.</summary>
            long IdHere(long idInPrefab) => standIns.TryGetValue(idInPrefab, out var id) ? id : (instance.FileId ^ idInPrefab) & long.MaxValue;

            HashSet<long> removed;

            HashSet<long> Removed(UnityYaml prefab)
            {
                if (removed != null) return removed;
                removed = new HashSet<long>(modification.Items("m_RemovedComponents").Concat(modification.Items("m_RemovedGameObjects"))
                    .Select(r => FileReference.Of(r).FileId));
                removed.Remove(0);
                // With a GameObject go its components and everything below.
                for (var before = -1; before != removed.Count;)
                {
                    before = removed.Count;
                    foreach (var document in prefab.Documents)
                    {
                        var owned = document.Fields.Reference("m_GameObject").FileId;
                        var parent = document.Fields.Reference("m_Father").FileId;
                        if (!removed.Contains(owned) && !removed.Contains(parent)) continue;
                        removed.Add(document.FileId);
                        if (IsTransform(document)) removed.Add(owned);
                    }
                }
                return removed;
            }

            /// <summary>References within the prefab become references within this file; those to removed objects none.</summary>
            static void Relink(YamlNode node, Dictionary<long, UnityDocument> kept)
            {
                if (node is YamlSequence list)
                    foreach (var item in list.Elements) Relink(item, kept);
                if (!(node is YamlMapping mapping)) return;
                var reference = FileReference.Of(mapping);
                if (!FileReference.Is(mapping))
                    foreach (var entry in mapping.Entries) Relink(entry.Value, kept);
                else if (reference.IsLocal && !reference.IsNone)
                    mapping.Set("fileID", Number(kept.TryGetValue(reference.FileId, out var target) ? target.FileId : 0, mapping.Location));
            }

            void Apply(YamlNode change, Dictionary<long, UnityDocument> kept)
            {
                var target = change.Reference("target");
                var path = change.Text("propertyPath");
                if (!kept.TryGetValue(target.FileId, out var document))
                {
                    if (!removed.Contains(target.FileId))
                        owner.warn($"{change.Location}: the override of '{path}' is for object {target.FileId}, which the prefab no " +
                            $"longer has: right-click the instance in Unity and remove unused overrides");
                    return;
                }
                var reference = change["objectReference"];
                var isReference = !FileReference.Of(reference).IsNone;
                // A reference set to none looks like an empty text; the field that reads it knows which it is.
                var value = isReference ? reference : change["value"] ?? new YamlScalar(change.Location, "");
                PropertyPath.Set(document.Fields, path, value);
            }

            static YamlNode Number(long value, SourceLocation location)
                => new YamlScalar(location, value.ToString(System.Globalization.CultureInfo.InvariantCulture));

            static YamlNode Reference(long fileId, SourceLocation location)
            {
                var reference = new YamlMapping(location);
                reference.Set("fileID", Number(fileId, location));
                return reference;
            }
        }

        public static bool IsTransform(UnityDocument document) => document.ClassId == Transform || document.ClassId == RectTransform;
    }
}
