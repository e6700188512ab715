using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;
using Host.Output;
using Rill;
using Rill.Editor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Baking
{
    /// <summary>
    /// Bakes the mesh colliders of a loaded scene that have no field, one that cannot be used, or one whose mesh has changed;
    /// new fields lie beside the scene, and the scene's file then refers to them.
    /// </summary>
    sealed class SceneBakeRun
    {
        readonly LocatedScene scene;
        readonly ProjectAssets assets;
        readonly MeshSdfSettings settings;
        readonly bool again;
        readonly string pictures;
        readonly TextWriter output;
        // The field of each mesh that was baked in this run, for the colliders that fraction it.
        readonly Dictionary<Mesh, string> made = new();
        // By file, what was baked into it.
        readonly Dictionary<string, Mesh> meshOf = new();

        /// <param name="settings">Of new fields; one that is there is baked with its own.</param>
        /// <param name="again">Bakes those too that are up to date.</param>
        /// <param name="pictures">Folder for the slices; null for out~/name.</param>
        public SceneBakeRun(LocatedScene scene, ProjectAssets assets, MeshSdfSettings settings, bool again, string pictures, TextWriter output)
        {
            this.scene = scene;
            this.assets = assets;
            this.settings = settings;
            this.again = again;
            this.pictures = ResultsFolder.Of(pictures, Path.GetFileNameWithoutExtension(scene.File));
            this.output = output;
        }

        /// <summary>Colliders that were left without a field that can be used, or that the file of the scene could not be told of.</summary>
        public int Failures { get; private set; }

        public int Baked { get; private set; }

        public void Run()
        {
            if (!settings.Validate(out string problem))
                throw new HostException($"bake {scene.AssetPath}: {problem}");
            List<FluidCollider> colliders = Object.FindObjectsOfType<FluidCollider>(true).Where(c => c.Shape == ColliderShape.Mesh)
                .OrderBy(c => NameOf(c.transform), StringComparer.Ordinal).ToList();
            output.WriteLine($"{scene.AssetPath}: {colliders.Count} mesh colliders");
            foreach (FluidCollider collider in colliders)
            {
                string name = NameOf(collider.transform);
                try
                {
                    output.WriteLine($"{name}: {Handle(collider)}");
                }
                catch (Exception e) when (e is ArgumentException or HostException)
                {
                    Failures++;
                    output.WriteLine($"{name}: ERROR: {e.Message}");
                }
            }
            output.WriteLine($"{Baked} baked, {Failures} failed");
        }

        string Handle(FluidCollider collider)
        {
            SignedDistanceField field = collider.Field;
            string invalid = null;
            bool isValid = field != null && field.Validate(out invalid);
            Mesh mesh = collider.TryGetComponent(out MeshFilter filter) ? filter.sharedMesh : null;
            if (mesh == null)
                return isValid ? "kept: its object has no Mesh Filter with a mesh to compare it with"
                    : throw new HostException($"{invalid ?? "it has no signed distance field"}, and its object has no Mesh Filter with " +
                    $"a mesh that could be baked: add one, or assign a field.");
            if (made.TryGetValue(mesh, out string guid) && (field == null || !isValid || guid == GuidOf(field)))
                return field == null ? "shares the field above, " + Assign(collider, guid) : "shares the field above";

            TriangleMesh triangles = EditorMesh.Read(mesh);
            bool wasReplaced = isValid && assets.TryIdentify(field, out string own, out _, out _) && meshOf.ContainsKey(assets.ResolvePath(own));
            if (isValid && !again && !wasReplaced)
            {
                if (field.SourceHash == 0)
                    return $"kept: '{field.name}' does not know what it was baked from; --again bakes it again";
                if (!field.IsStale(triangles))
                    return "up to date";
            }
            string why = field == null ? "no field" : !isValid ? invalid : field.IsStale(triangles) ? "the mesh has changed" : "asked for";
            return $"{why}; {Bake(collider, triangles, mesh, field)}";
        }

        string Bake(FluidCollider collider, TriangleMesh triangles, Mesh mesh, SignedDistanceField field)
        {
            MeshReport report = MeshCheck.Run(triangles);
            MeshSdfSettings with = field != null && field.Validate(out _) ? field.Settings : settings;
            MeshSdfEstimate estimate = MeshSdfBaker.Estimate(report, with);
            if (estimate.Problem != null)
                throw new HostException($"'{mesh.name}' cannot be baked. {estimate.Problem}");
            assets.TryIdentify(mesh, out _, out string source, out long sourceId);
            string path = field != null ? OwnPathOf(field) : PathFor(mesh, (source, sourceId));
            if (meshOf.TryGetValue(path, out Mesh other) && other != mesh)
                throw new HostException($"its field '{field.name}' was baked from '{other.name}' for another collider, but its own " +
                    $"mesh is '{mesh.name}': assign a field of its own.");

            SdfBake bake = null;
            Output.Progress.Run(output, "baking " + mesh.name, 1, tell => bake = MeshSdfBaker.Bake(triangles, with, (fraction, stage) =>
            {
                tell(fraction, stage);
                return true;
            }));
            SignedDistanceField written = SignedDistanceField.Create(bake, source, sourceId);
            written.name = Path.GetFileNameWithoutExtension(path);
            string guid;
            try
            {
                guid = AssetWriter.Write(path, written, BakeRun.ScriptGuid(assets));
            }
            finally
            {
                Object.DestroyImmediate(written.Texture);
                Object.DestroyImmediate(written);
            }
            made[mesh] = guid;
            meshOf[path] = mesh;
            Baked++;
            string where = field != null ? "in place, " + path : $"{path}, {Assign(collider, guid)}";
            string picture = Path.Combine(pictures, Path.GetFileNameWithoutExtension(path) + "-slices.png");
            bool isDrawn = SlicePicture.Draw(SdfVolume.Of(bake), picture);
            string lost = string.Concat(report.LossesOf(with).Select(loss => $"\n  WARNING: {BakeRun.Text(loss, with)}"));
            return $"{BakeTexts.Of(report)}; baked: {BakeTexts.Of(bake)}; {where}{(isDrawn ? "; " + picture : "")}{lost}";
        }

        string GuidOf(SignedDistanceField field) => assets.TryIdentify(field, out _, out string guid, out _) ? guid : "";

        string OwnPathOf(SignedDistanceField field)
        {
            string file = assets.TryIdentify(field, out string path, out _, out _) ? assets.ResolvePath(path) : null;
            bool isOwn = file != null && Path.GetFullPath(file).StartsWith(Path.GetFullPath(scene.Root) + Path.DirectorySeparatorChar,
                StringComparison.Ordinal);
            return isOwn ? file : throw new HostException($"its field '{field.name}' is stale, but " +
                $"{(path == "" ? "no file of its own" : path)} is not the project's to write: copy it into the project and assign the copy.");
        }

        /// <summary>Beside the scene, under the mesh's name: free, or with a field of this mesh that no one referred to.</summary>
        string PathFor(Mesh mesh, (string, long) source)
        {
            for (int i = 1; ; i++)
            {
                string name = $"{FieldAssets.FileName(mesh.name)} Distances{(i > 1 ? " " + i : "")}{FieldAssets.Extension}",
                    file = Path.Combine(Path.GetDirectoryName(scene.File), name);
                if (!File.Exists(file))
                    return file;
                var there = assets.LoadAtPath<SignedDistanceField>(scene.AssetPath.Substring(0, scene.AssetPath.LastIndexOf('/') + 1) + name);
                if (there != null && source.Item1 != "" && (there.SourceMesh, there.SourceMeshId) == source)
                    return file;
            }
        }

        // Only the reference changes in the scene's file; everything else stays as Unity wrote it. What a prefab brought is overridden
        // there, as by the window in the editor: the prefab may be a package's, and other scenes have it too.
        string Assign(FluidCollider collider, string guid)
        {
            string reference = $"{{fileID: 11400000, guid: {guid}, type: 2}}", text = File.ReadAllText(scene.File);
            PrefabOrigin origin = assets.OriginIn(scene.AssetPath, collider);
            string changed = origin != null ? SceneText.WithOverride(text, origin.Instance, origin.Target, "field", reference)
                : SceneText.WithReference(text, assets.FileIdIn(scene.AssetPath, collider), "field", reference);
            if (changed == null)
            {
                Failures++;
                return "NOT ASSIGNED: the scene's file does not have the collider: assign the field by hand";
            }
            File.WriteAllText(scene.File, changed);
            return $"assigned in {Path.GetFileName(scene.File)}{(origin != null ? ", as an override of its prefab" : "")}";
        }

        static string NameOf(Transform at) => (at.parent != null ? NameOf(at.parent) + "/" : "") + at.name;
    }
}
