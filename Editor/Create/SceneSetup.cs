using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Rill.Editor
{
    /// <summary>Makes working objects in the open scene: below the given one, undone in one step, selected afterwards.</summary>
    /// <remarks>Objects are made inactive and switched on when they are whole, so that what looks for its fluid finds it.</remarks>
    static class SceneSetup
    {
        /// <summary>Water of a new fluid at the start.</summary>
        public enum Fill { Nothing, Pool, PoolAndDrop }

        /// <summary>Height of a basin's floor above what it stands on, m.</summary>
        public const float Stand = BasinSetup.Floor;

        static readonly Vector3 DefaultBox = new Vector3(2f, 1.2f, 1f);
        const float DefaultSpacing = 0.03f;
        const int DefaultCapacity = 50000;
        const float DropRadius = 0.22f, DropHeight = 0.9f;      // m; of its center above the floor

        /// <summary>A basin of water, and a large drop that falls into it.</summary>
        /// <param name="parent">Null for the root of the scene, in front of the scene view.</param>
        public static GameObject CreateFluid(GameObject parent)
        {
            GameObject made = MakeFluid(parent, Fill.PoolAndDrop);
            return FinishInView(made, "Fluid", made.GetComponent<FluidSimulation>());
        }

        /// <summary>Water at the start, in the fluid that the parent belongs to.</summary>
        public static GameObject CreateVolume(GameObject parent) => CreatePart<FluidVolume>(parent, "Fluid Volume", false, FillFloor);

        /// <summary>Draws a fluid that nothing draws. The selection stays.</summary>
        public static void AddRenderer(FluidSimulation fluid)
        {
            Undo.AddComponent<FluidSurface>(fluid.gameObject);
            Undo.SetCurrentGroupName("Add Fluid Surface");
        }

        /// <summary>Water at the start, below a fluid that nothing fills. The selection stays.</summary>
        public static void AddVolume(FluidSimulation fluid)
        {
            var made = new GameObject("Fluid Volume");
            made.SetActive(false);
            FluidVolume volume = made.AddComponent<FluidVolume>();
            Adopt(made, fluid.gameObject);
            FillFloor(volume, fluid);
            Register(made, "Fluid Volume");
            Undo.SetCurrentGroupName("Add Fluid Volume");
        }

        static void FillFloor(FluidVolume volume, FluidSimulation fluid)
        {
            Vector3 box = fluid.DomainSize;
            volume.Size = new Vector3(0.5f * box.x, 0.25f * box.y, 0.5f * box.z);
            SetPose(volume, fluid, new Vector3(0f, -0.375f * box.y, 0f), Quaternion.identity);
        }

        /// <summary>A tap below the lid, pointing down.</summary>
        public static GameObject CreateEmitter(GameObject parent)
        {
            return CreatePart<FluidEmitter>(parent, "Fluid Emitter", false, (emitter, fluid) =>
            {
                const float Speed = 2f, Fullness = 0.3f;
                float radius = 2f * fluid.ParticleSpacing;
                emitter.Radius = radius;
                emitter.Speed = Speed;
                emitter.Rate = Fullness * Mathf.PI * radius * radius * Speed;
                SetPose(emitter, fluid, new Vector3(0f, 0.4f * fluid.DomainSize.y, 0f), Quaternion.Euler(90f, 0f, 0f));
            });
        }

        /// <summary>A hole in the floor.</summary>
        public static GameObject CreateDrain(GameObject parent)
        {
            return CreatePart<FluidDrain>(parent, "Fluid Drain", true, (drain, fluid) =>
            {
                Vector3 box = fluid.DomainSize;
                float depth = 4f * fluid.ParticleSpacing;
                drain.Size = new Vector3(0.25f * box.x, depth, 0.25f * box.z);
                SetPose(drain, fluid, new Vector3(0.25f * box.x, 0.5f * (depth - box.y), 0f), Quaternion.identity);
            });
        }

        /// <summary>A gust along the box in its center.</summary>
        public static GameObject CreateForceField(GameObject parent)
        {
            return CreatePart<FluidForceField>(parent, "Fluid Force Field", true, (field, fluid) =>
            {
                field.Bounds = ForceFieldBounds.Sphere;
                field.Radius = 0.25f * Shortest(fluid.DomainSize);
                field.Falloff = ForceFieldFalloff.Smooth;
                SetPose(field, fluid, Vector3.zero, Quaternion.Euler(0f, 90f, 0f));
            });
        }

        /// <summary>A probe in the center.</summary>
        public static GameObject CreateProbe(GameObject parent)
        {
            return CreatePart<FluidProbe>(parent, "Fluid Probe", true, (probe, fluid) =>
            {
                probe.Radius = 2f * fluid.ParticleSpacing;
                SetPose(probe, fluid, Vector3.zero, Quaternion.identity);
            });
        }

        /// <summary>A detector on the floor, a quarter of the box along each side.</summary>
        public static GameObject CreateDetector(GameObject parent)
        {
            return CreatePart<FluidDetector>(parent, "Fluid Detector", true, (detector, fluid) =>
            {
                Vector3 box = fluid.DomainSize;
                detector.Size = 0.25f * box;
                SetPose(detector, fluid, new Vector3(0f, -0.375f * box.y, 0f), Quaternion.identity);
            });
        }

        /// <summary>A connection of the first two fluids that are selected, or are above what is, where their boxes meet; on an object beside
        /// both. Where there are not two, the ends that lack one are left to be set.</summary>
        public static GameObject CreateConnection(GameObject[] selected)
        {
            FluidSimulation first = null, second = null;
            foreach (GameObject one in selected)
            {
                FluidSimulation fluid = one.GetComponentInParent<FluidSimulation>(true);
                if (first == null)
                    first = fluid;
                else if (second == null && fluid != first)
                    second = fluid;
            }
            var made = new GameObject("Fluid Connection");
            made.SetActive(false);
            Transform beside = first != null ? first.transform.parent : null;
            Adopt(made, beside != null ? beside.gameObject : null);
            FluidConnection connection = made.AddComponent<FluidConnection>();
            connection.First = first;
            connection.Second = second;
            if (second != null)
                made.transform.position = 0.5f * (first.transform.position + second.transform.position);
            return Finish(made, "Fluid Connection");
        }

        /// <summary>A ball that the water goes around, in the center of the fluid that the parent belongs to.</summary>
        public static GameObject CreateCollider(GameObject parent)
            => CreateColliderObject(parent, PrimitiveType.Sphere, "Fluid Collider", 0.3f, null);

        /// <summary>A visible collider of the size of a fraction of the fluid's shortest side.</summary>
        /// <param name="shape">Sphere or cube.</param>
        /// <param name="add">Adds what else it needs; its collider is there. Null for nothing.</param>
        public static GameObject CreateColliderObject(GameObject parent, PrimitiveType shape, string name, float fraction,
            Action<GameObject, FluidSimulation> add)
        {
            return Create(parent, GameObject.CreatePrimitive(shape), name, (made, fluid) =>
            {
                made.transform.localScale *= fraction * Shortest(fluid.DomainSize);
                FluidCollider collider = made.AddComponent<FluidCollider>();
                collider.Shape = shape == PrimitiveType.Sphere ? ColliderShape.Sphere : ColliderShape.Box;
                collider.Radius = 0.5f;
                collider.Size = Vector3.one;
                add?.Invoke(made, fluid);
            });
        }

        /// <summary>An object in the center of the fluid that the parent belongs to, turned as that and not scaled.</summary>
        /// <param name="add">Adds all that it needs.</param>
        public static GameObject CreateObject(GameObject parent, string name, Action<GameObject, FluidSimulation> add)
            => Create(parent, new GameObject(), name, add);

        static GameObject Create(GameObject parent, GameObject made, string name, Action<GameObject, FluidSimulation> add)
        {
            FluidSimulation fluid = FindFluid(parent);
            GameObject root = null;
            made.SetActive(false);
            if (fluid == null)
                fluid = (root = MakeFluid(null, Fill.PoolAndDrop)).GetComponent<FluidSimulation>();
            made.name = name;
            Adopt(made, parent);
            made.transform.SetPositionAndRotation(fluid.transform.position, fluid.transform.rotation);
            Unscale(made);
            add(made, fluid);
            if (root != null)
                Register(root, name);
            return Finish(made, name);
        }

        /// <summary>The fluid that an object belongs to: above it, or the first of the open scenes, or of the prefab that is open.</summary>
        /// <returns>Null where there is none.</returns>
        public static FluidSimulation FindFluid(GameObject near)
        {
            FluidSimulation above = near != null ? near.GetComponentInParent<FluidSimulation>(true) : null;
            return above != null ? above : FirstOfScenes<FluidSimulation>(_ => true);
        }

        // Below the parent where it works there, else below the fluid; with a fluid of its own where there is none.
        static GameObject CreatePart<T>(GameObject parent, string name, bool needsWater, Action<T, FluidSimulation> set) where T : Component
        {
            FluidSimulation fluid = FindFluid(parent);
            GameObject root = null;
            if (fluid == null)
            {
                fluid = (root = MakeFluid(parent, needsWater ? Fill.PoolAndDrop : Fill.Nothing)).GetComponent<FluidSimulation>();
                parent = root;
            }
            var made = new GameObject(name);
            made.SetActive(false);
            T part = made.AddComponent<T>();
            bool isOutside = parent == null || parent.GetComponentInParent<FluidSimulation>(true) != fluid;
            Adopt(made, parent != null && (!isOutside || part is FluidPart) ? parent : fluid.gameObject);
            if (parent != null && isOutside && part is FluidPart acts)
                acts.Simulation = fluid;
            set(part, fluid);
            if (root == null)
                return Finish(made, name);
            made.SetActive(true);
            Finish(root, name);
            Selection.activeGameObject = made;
            return made;
        }

        /// <summary>A fluid in a basin, still inactive, at the parent's origin or in front of the scene view.</summary>
        public static GameObject MakeFluid(GameObject parent, Fill fill)
        {
            var made = new GameObject("Fluid");
            made.SetActive(false);
            Adopt(made, parent);
            Unscale(made);
            if (parent == null)
                made.transform.position = ScenePivot + new Vector3(0f, Stand + 0.5f * DefaultBox.y, 0f);    // it stands on the pivot

            FluidSimulation fluid = made.AddComponent<FluidSimulation>();
            fluid.Configure(DefaultBox, DefaultSpacing, DefaultCapacity);
            FluidSurface surface = made.AddComponent<FluidSurface>();
            surface.HiddenWalls = BasinSetup.Covered;
            surface.Sun = FirstOfScenes<Light>(light => light.type == LightType.Directional);       // what caustics need
            made.AddComponent<FluidFoam>();
            float floor = -0.5f * DefaultBox.y, depth = FluidSceneSetup.Depth;
            if (fill != Fill.Nothing)
            {
                FluidVolume pool = MakeVolume(made, "Water", floor + 0.5f * depth);
                pool.Size = new Vector3(DefaultBox.x, depth, DefaultBox.z);
            }
            if (fill == Fill.PoolAndDrop)
            {
                FluidVolume drop = MakeVolume(made, "Drop", floor + DropHeight);
                drop.Shape = VolumeShape.Sphere;
                drop.Radius = DropRadius;
            }
            BasinSetup.Make(fluid);
            return made;
        }

        static FluidVolume MakeVolume(GameObject fluid, string name, float height)
        {
            GameObject made = BasinSetup.Child(fluid, name);
            made.transform.localPosition = new Vector3(0f, height, 0f);
            return made.AddComponent<FluidVolume>();
        }

        /// <summary>Gives an object a scale that makes up for those above it: a fluid's box has none.</summary>
        public static void Unscale(GameObject made)
        {
            made.transform.localScale = Vector3.one;
            Vector3 scale = made.transform.lossyScale;
            made.transform.localScale = new Vector3(Inverse(scale.x), Inverse(scale.y), Inverse(scale.z));
        }

        /// <summary>Point that the scene view looks at, world space, m; the origin while there is none.</summary>
        public static Vector3 ScenePivot => SceneView.lastActiveSceneView != null ? SceneView.lastActiveSceneView.pivot : Vector3.zero;

        /// <summary>The first active component of a kind in the open scenes, or in the prefab that is open.</summary>
        /// <returns>Null where there is none.</returns>
        public static T FirstOfScenes<T>(Func<T, bool> fits) where T : Component
        {
            foreach (GameObject root in Roots())
                foreach (T found in root.GetComponentsInChildren<T>())
                    if (fits(found))
                        return found;
            return null;
        }

        // While a prefab is open, what is made goes into it and is saved with it: the scenes' objects are out of reach.
        static IEnumerable<GameObject> Roots()
        {
            PrefabStage stage = PrefabStageUtility.GetCurrentPrefabStage();
            if (stage != null)
            {
                yield return stage.prefabContentsRoot;
                yield break;
            }
            for (int scene = 0; scene < SceneManager.sceneCount; scene++)
                foreach (GameObject root in SceneManager.GetSceneAt(scene).GetRootGameObjects())
                    yield return root;
        }

        // In the frame of the domain, wherever in its tree the part is.
        static void SetPose(Component part, FluidSimulation fluid, Vector3 position, Quaternion rotation)
        {
            Transform box = fluid.transform;
            part.transform.SetPositionAndRotation(box.position + box.rotation * position, box.rotation * rotation);
        }

        /// <summary>Puts an object below the parent, or into the scene or prefab that is open, under a name of its own.</summary>
        public static void Adopt(GameObject made, GameObject parent)
        {
            if (parent == null)
                StageUtility.PlaceGameObjectInCurrentStage(made);
            GameObjectUtility.SetParentAndAlign(made, parent);
            GameObjectUtility.EnsureUniqueNameForSibling(made);
        }

        /// <summary>Ends the making of an object, and has the scene view show the fluid's box.</summary>
        public static GameObject FinishInView(GameObject made, string name, FluidSimulation fluid)
        {
            Finish(made, name);
            if (SceneView.lastActiveSceneView != null && FrameBounds.TryGet(fluid, out Bounds bounds))
                SceneView.lastActiveSceneView.Frame(bounds, false);
            return made;
        }

        static GameObject Finish(GameObject made, string name)
        {
            Register(made, name);
            Selection.activeGameObject = made;
            return made;
        }

        static void Register(GameObject made, string name)
        {
            made.SetActive(true);
            Undo.RegisterCreatedObjectUndo(made, $"Create {name}");
            Undo.SetCurrentGroupName($"Create {name}");
        }

        static float Shortest(Vector3 size) => Mathf.Min(size.x, size.y, size.z);
        static float Inverse(float scale) => scale != 0f ? 1f / scale : 1f;
    }
}
