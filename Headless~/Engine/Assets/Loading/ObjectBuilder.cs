using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Host.Assets
{
    /// <summary>
    /// Makes the objects of a file: first all of them, then the values of their fields, so that every reference finds its
    /// object whatever the order in the file. Nothing is told to wake here.
    /// </summary>
    internal sealed class ObjectBuilder
    {
        const int MonoBehaviour = 114, RenderSettings = 104, SceneRoots = 1660057539;
        const int Material = 21, Texture2D = 28, Mesh = 43, RenderTexture = 84, Texture3D = 117, PhysicMaterial = 134;

        readonly ProjectAssets project;
        readonly UnityYaml documents;
        readonly LoadedAsset result;
        readonly Scene scene;
        readonly bool isScene;
        readonly Action<Action> whenAllIsRead;
        readonly ILookup<long, UnityDocument> childrenOf, componentsOf;
        readonly List<KeyValuePair<UnityDocument, Object>> made = new List<KeyValuePair<UnityDocument, Object>>();
        readonly List<GameObject> roots = new List<GameObject>();

        /// <param name="scene">Where the GameObjects go; an invalid one makes assets.</param>
        /// <param name="result">Filled as objects appear, so that files that refer to each other can find them.</param>
        /// <param name="whenAllIsRead">Takes what has to wait until every file that is being read has its values.</param>
        public ObjectBuilder(ProjectAssets project, UnityYaml documents, LoadedAsset result, Scene scene, Action<Action> whenAllIsRead)
        {
            this.project = project;
            this.documents = documents;
            this.result = result;
            this.scene = scene;
            isScene = scene.IsValid();
            this.whenAllIsRead = whenAllIsRead;
            result.LeftOut.UnionWith(documents.LeftOut);
            foreach (var document in documents.Documents)
                if (document.Origin != null) result.Origins[document.FileId] = document.Origin;
            childrenOf = documents.Documents.Where(PrefabExpander.IsTransform).ToLookup(ParentOf);
            componentsOf = documents.Documents.Where(d => d.ClassId != PrefabExpander.GameObject)
                .ToLookup(d => d.Fields.Reference("m_GameObject").FileId);
        }

        /// <returns>The GameObjects without a parent, in the order of the hierarchy window.</returns>
        public List<GameObject> Build()
        {
            foreach (var root in InRootOrder(childrenOf[0])) MakeTree(root, null);
            var lost = documents.Documents.FirstOrDefault(d => PrefabExpander.IsTransform(d) && !result.Objects.ContainsKey(d.FileId));
            if (lost != null) project.Fail($"{lost.Location}: the {lost.TypeName} {lost.FileId} is its own ancestor: correct m_Father");

            foreach (var document in documents.Documents)
                if (document.Fields.Reference("m_GameObject").IsNone && document.ClassId != PrefabExpander.GameObject
                    && !PrefabExpander.IsTransform(document)) MakeFree(document);
            foreach (var (document, target) in made) ReadValues(document, target);
            return roots;
        }

        /// <summary>0 for a root, and for the child of something that was left out.</summary>
        long ParentOf(UnityDocument transform)
        {
            var father = transform.Fields.Reference("m_Father");
            if (father.IsNone || documents.LeftOut.Contains(father.FileId)) return 0;
            if (documents.Find(father.FileId) != null) return father.FileId;
            project.Fail($"{father.Location}: the parent {father.FileId} of {PathOf(transform)} is not in this file: correct m_Father");
            return 0;
        }

        IEnumerable<UnityDocument> InRootOrder(IEnumerable<UnityDocument> transforms)
        {
            var listed = documents.Documents.Where(d => d.ClassId == SceneRoots).SelectMany(d => d.Fields.Items("m_Roots"))
                .Select(r => FileReference.Of(r).FileId).ToList();
            return transforms.OrderBy(t =>
            {
                var at = listed.IndexOf(t.FileId);
                if (at < 0) at = listed.IndexOf(t.Fields.Reference("m_PrefabInstance").FileId);
                return at >= 0 ? at : t.Fields.Int("m_RootOrder", int.MaxValue);
            });
        }

        IEnumerable<UnityDocument> ChildrenOf(UnityDocument transform)
        {
            var listed = transform.Fields.Items("m_Children").Select(c => FileReference.Of(c).FileId).ToList();
            return childrenOf[transform.FileId].OrderBy(c => listed.Contains(c.FileId) ? listed.IndexOf(c.FileId) : int.MaxValue);
        }

        // ---- making

        void MakeTree(UnityDocument transformDocument, Transform parent)
        {
            var id = transformDocument.Fields.Reference("m_GameObject").FileId;
            if (documents.Find(id) is not { ClassId: PrefabExpander.GameObject } document)
                throw transformDocument.Location.Error($"the GameObject {id} of this {transformDocument.TypeName} is not in the file");

            var gameObject = ObjectFactory.CreateGameObject(document.Fields.Text("m_Name"), scene);
            var transform = (Transform)ObjectFactory.AddComponent(gameObject, project.ComponentType(transformDocument.TypeName) ?? typeof(Transform));
            gameObject.SetActiveSilently(document.Fields.Bool("m_IsActive", true));
            gameObject.layer = document.Fields.Int("m_Layer");
            gameObject.tag = document.Fields.Text("m_TagString", "Untagged");
            gameObject.hideFlags = (HideFlags)document.Fields.Int("m_ObjectHideFlags");
            if (parent == null) roots.Add(gameObject);
            else transform.SetParent(parent, false);
            transform.localPosition = BuiltInValues.Vector3(transformDocument.Fields["m_LocalPosition"]);
            transform.localRotation = BuiltInValues.Quaternion(transformDocument.Fields["m_LocalRotation"]);
            transform.localScale = BuiltInValues.Vector3(transformDocument.Fields["m_LocalScale"], Vector3.one);
            result.Objects[document.FileId] = gameObject;
            result.Objects[transformDocument.FileId] = transform;
            gameObject.PrefabInstance = transform.PrefabInstance = InstanceOf(document);

            foreach (var component in ComponentsOf(document)) MakeComponent(component, gameObject);
            foreach (var child in ChildrenOf(transformDocument)) MakeTree(child, transform);
        }

        /// <summary>In the inspector's order; those that an override added come last.</summary>
        IEnumerable<UnityDocument> ComponentsOf(UnityDocument gameObject)
        {
            // Old editors used the component's class id for the key.
            var listed = gameObject.Fields.Items("m_Component").OfType<YamlMapping>().SelectMany(c => c.Entries)
                .Select(e => FileReference.Of(e.Value).FileId).ToList();
            return componentsOf[gameObject.FileId].Where(d => !PrefabExpander.IsTransform(d)).OrderBy(d => listed.Contains(d.FileId)
                ? listed.IndexOf(d.FileId) : int.MaxValue);
        }

        void MakeComponent(UnityDocument document, GameObject owner)
        {
            Type type;
            if (document.ClassId == MonoBehaviour)
            {
                var scope = new ReadScope(() => $"the script of a component on '{PathOf(owner)}'");
                type = project.ScriptType(document.Fields.Reference("m_Script"), scope);
                if (type != null && !typeof(MonoBehaviour).IsAssignableFrom(type))
                {
                    project.Fail($"{document.Location}: {scope} is {type.Name}, which is no MonoBehaviour: only those can sit on a GameObject");
                    type = null;
                }
            }
            else
            {
                type = project.ComponentType(document.TypeName);
                if (type == null) project.Note($"{document.Location}: the host has no {document.TypeName}; it is left out of " +
                    $"'{PathOf(owner)}' (and of others, if there are)", document.TypeName);
            }
            if (type != null && project.IsStub(type)) project.Note($"{document.Location}: the host has a {type.Name} in name only: the " +
                $"one on '{PathOf(owner)}' (and others, if there are) does nothing", type.Name);
            if (type == null)
            {
                result.LeftOut.Add(document.FileId);
                return;
            }
            var component = ObjectFactory.AddComponent(owner, type);
            if (component is Behaviour behavior) behavior.SetEnabledSilently(document.Fields.Bool("m_Enabled", true));
            component.PrefabInstance = InstanceOf(document);
            Made(document, component);
        }

        static long InstanceOf(UnityDocument document) => document.Origin?.Instance ?? 0;

        /// <summary>An object without a GameObject: an asset of its own, or a scene's settings.</summary>
        void MakeFree(UnityDocument document)
        {
            Object found = null;
            switch (document.ClassId)
            {
                case MonoBehaviour:
                    var scope = new ReadScope(() => $"the script of '{document.Fields.Text("m_Name")}'");
                    var type = project.ScriptType(document.Fields.Reference("m_Script"), scope);
                    if (type != null && !typeof(ScriptableObject).IsAssignableFrom(type))
                        project.Fail(
                        $"{document.Location}: {scope} is {type.Name}, which is no ScriptableObject: only those can be assets");
                    else if (type != null) found = ObjectFactory.CreateScriptableObject(type);
                    break;
                case Material: found = MaterialReader.Make(document.Fields, Resolve,
                    new ReadScope(() => $"Material '{document.Fields.Text("m_Name")}'")); break;
                case Mesh: found = MeshReader.Make(document.Fields); break;
                case Texture2D: found = TextureReader.MakeTexture2D(document.Fields); break;
                // `rill check` has no device to put voxels on, and needs none.
                case Texture3D: found = Player.Device == null ? null : TextureReader.MakeTexture3D(document.Fields); break;
                case RenderTexture: found = TextureReader.MakeRenderTexture(document.Fields); break;
                case PhysicMaterial: found = new UnityEngine.PhysicMaterial(); break;
                case RenderSettings when isScene:
                    NativeFields.Read(null, typeof(UnityEngine.RenderSettings), document.Fields, Reader(),
                        new ReadScope(() => "the scene's RenderSettings"));
                    UnityEngine.Headless.EnvironmentLighting.Invalidate();
                    return;
                default:
                    if (isScene) return;
                    project.Note($"{document.Location}: the host makes no {document.TypeName} from a file; " +
                        $"'{document.Fields.Text("m_Name")}' is left out");
                    break;
            }
            if (found == null)
            {
                result.LeftOut.Add(document.FileId);
                return;
            }
            found.name = document.Fields.Text("m_Name");
            found.hideFlags = (HideFlags)document.Fields.Int("m_ObjectHideFlags");
            found.IsAsset = !isScene;
            Made(document, found);
        }

        void Made(UnityDocument document, Object target)
        {
            result.Objects[document.FileId] = target;
            made.Add(new KeyValuePair<UnityDocument, Object>(document, target));
        }

        // ---- values

        void ReadValues(UnityDocument document, Object target)
        {
            var scope = new ReadScope(() => Describe(target));
            switch (target)
            {
                case UnityEngine.Material material: MaterialReader.Read(material, document.Fields, Resolve, scope); break;
                case UnityEngine.MonoBehaviour _: Reader().Read(target, document.Fields, scope); break;
                case ScriptableObject asset:
                    Reader().Read(target, document.Fields, scope);
                    whenAllIsRead(() => ObjectFactory.Wake(asset));
                    break;
                case Texture _: case UnityEngine.Mesh _: break;
                case Component _ when project.IsStub(target.GetType()): NativeFields.ReadStub(target, document.Fields, Reader(), scope); break;
                default: NativeFields.Read(target, target.GetType(), document.Fields, Reader(), scope); break;
            }
        }

        FieldReader Reader() => new FieldReader(Resolve, text => project.Note(text), project.Fail, project.Scripts.FindManaged);

        Object Resolve(FileReference reference, Type type, ReadScope scope)
        {
            if (reference.IsNone) return null;
            if (!reference.IsLocal) return project.Resolve(reference, type, scope);
            if (result.Objects.TryGetValue(reference.FileId, out var found)) return project.Checked(found, reference, type, scope);
            if (!result.LeftOut.Contains(reference.FileId))
                project.Fail($"{reference.Location}: {scope} refers to object {reference.FileId}, which is not in this file: assign the field again");
            return null;
        }

        // ---- names for messages

        static string Describe(Object target) => target is Component component
            ? $"{target.GetType().Name} on '{PathOf(component.gameObject)}'" : $"{target.GetType().Name} '{target.name}'";

        static string PathOf(GameObject gameObject)
        {
            var path = gameObject.name;
            for (var at = gameObject.transform.parent; at != null; at = at.parent) path = at.name + "/" + path;
            return path;
        }

        string PathOf(UnityDocument transform) => $"'{documents.Find(transform.Fields.Reference("m_GameObject").FileId)?.Fields.Text("m_Name")}'";
    }
}
