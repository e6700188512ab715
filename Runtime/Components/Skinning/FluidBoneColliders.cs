using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Makes a skinned character solid for the fluid by capsules on its bones: one <see cref="FluidCollider"/> below each bone that carries
    /// enough of the mesh. They follow the bones, and can be moved and edited as any other collider.
    /// </summary>
    /// <remarks>
    /// A new one fits itself, in the Editor. <see cref="Fit"/> fits again: capsules that are still there keep their friction, events and
    /// other settings and get new sizes, and only those that it made itself are changed. At run time this component does nothing.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Bone Colliders"), Icon(PackagePaths.Icon), ManualPage("colliders", "fluid-bone-colliders")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(SkinnedMeshRenderer))]
    public sealed class FluidBoneColliders : MonoBehaviour, IHasProblems, IAppliesSettings
    {
        const int MaxVertices = 100000;
        const string CapsuleName = "Fluid Capsule";

        [Tooltip("Weight from which a vertex belongs to a bone, 0.05 to 1. At 0.5 and below, one at a joint belongs to both bones.")]
        [Range(0.05f, 1f)]
        [SerializeField] float minWeight = 0.4f;

        [Tooltip("Vertices that a bone must carry to get a capsule, 4 to 100,000. More leaves out fingers and other small bones.")]
        [SerializeField] int minVertices = 12;

        [Tooltip("Fraction of a bone's surface that its capsule shall hold, 0.5 to 1. More swallows what stands out, less leaves it out.")]
        [Range(0.5f, 1f)]
        [SerializeField] float coverage = 0.9f;

        [SerializeField, HideInInspector] List<FluidCollider> capsules = new List<FluidCollider>();

        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] string refusal;     // why the newest fit made nothing

        /// <summary>Weight from which a vertex belongs to a bone, 0.05 to 1. Counts at the next <see cref="Fit"/>, as all settings
        /// here.</summary>
        public float MinWeight { get => minWeight; set { minWeight = value; Changed(); } }

        /// <summary>Vertices that a bone must carry to get a capsule, 4 to 100,000.</summary>
        public int MinVertices { get => minVertices; set { minVertices = value; Changed(); } }

        /// <summary>Fraction of a bone's surface that its capsule shall hold, 0.5 to 1.</summary>
        public float Coverage { get => coverage; set { coverage = value; Changed(); } }

        /// <summary>The capsules that the newest fit made, below their bones. One that was destroyed since is null.</summary>
        public IReadOnlyList<FluidCollider> Capsules => capsules;

        /// <summary>Hears of changes before they are made, in the Editor; null in a player.</summary>
        internal static IFitUndo Undo { get => undo; set => undo = value; }

        [KeptBetweenPlays] static IFitUndo undo;

        /// <summary>Fits capsules to the mesh in its bind pose and puts them below the bones. What cannot be fitted is logged, by name, and
        /// the capsules of before then stay.</summary>
        /// <returns>How many capsules there are now; 0 where nothing was fitted.</returns>
        public int Fit()
        {
            int count = TryFit();
            if (refusal != null)
                Debug.LogError($"Rill: FluidBoneColliders '{name}' fits nothing: {refusal}", this);
            return count;
        }

        /// <summary>Destroys the capsules that it made. In an instance of a prefab that has them, the Editor keeps their objects: those
        /// remain without a collider, and the next <see cref="Fit"/> uses them again.</summary>
        public void Clear()
        {
            if (ClosedPrefabProblem is string problem)
            {
                Debug.LogError($"Rill: FluidBoneColliders '{name}' removes nothing: {problem}", this);
                return;
            }
            Undo?.Changing(this);
            foreach (FluidCollider capsule in capsules)
                Destroy(capsule);
            capsules.Clear();
        }

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("min weight", ref minWeight, 0.05f, 1f, 0.4f, ref problem);
            Limit.Clamp("min vertices", ref minVertices, 4, MaxVertices, ref problem);
            Limit.Clamp("coverage", ref coverage, 0.5f, 1f, 0.9f, ref problem);
            return problem == null;
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(refusal);
            problems.AddIfAny(refusal == null && capsules.Count == 0 ? "it has fitted no capsules. Choose Fit to Bones." : null);
        }

        // In the Editor, where the component was added or reset. The inspector says what was refused.
        void Reset() => TryFit();

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            Validate(out string problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings() => clamped.Log(this);

        // Unity allows no additions to a closed prefab and no removals: it has no scene.
        string ClosedPrefabProblem => gameObject.scene.IsValid() ? null
            : "it is in a prefab that is not open. Open the prefab, or place it in a scene, and choose it there.";

        int TryFit()
        {
            var renderer = GetComponent<SkinnedMeshRenderer>();
            Transform[] bones = renderer.bones;
            refusal = ClosedPrefabProblem ?? SkinProblems.Of(renderer, bones);
            if (refusal != null)
                return 0;
            var points = new BonePoints(renderer.sharedMesh, bones.Length, minWeight);
            var wanted = new List<int>();
            for (int i = 0; i < bones.Length; i++)
                if (bones[i] != null && points.Count(i) >= minVertices)
                    wanted.Add(i);
            if (wanted.Count == 0)
                refusal = Invariant($"no bone carries {minVertices} vertices by {minWeight} and more. Lower Min Vertices or Min Weight.");
            else if (wanted.Count > ColliderSet.MaxCount)
                refusal = Invariant($"{wanted.Count} bones carry {minVertices} vertices and more, and a fluid takes {ColliderSet.MaxCount} ") +
                    "colliders. Raise Min Vertices.";
            if (refusal != null)
                return 0;
            Undo?.Changing(this);
            var made = new List<FluidCollider>();
            foreach (int bone in wanted)
                made.Add(FitBone(bones, bone, points));
            foreach (FluidCollider capsule in capsules)
                if (!made.Contains(capsule))
                    Destroy(capsule);
            capsules = made;
            return made.Count;
        }

        FluidCollider FitBone(Transform[] bones, int bone, BonePoints points)
        {
            float3[] vertices = points.Of(bone, out float[] areas);
            FittedCapsule fitted = FittedCapsule.Around(vertices, areas, coverage, Axes(bones, bone));
            FluidCollider capsule = Find(bones[bone]) ?? Make(bones[bone]);
            Undo?.Changing(capsule.transform);
            Undo?.Changing(capsule);
            capsule.transform.localPosition = fitted.center;
            capsule.transform.localRotation = Quaternion.FromToRotation(Vector3.up, fitted.axis);
            capsule.transform.localScale = Vector3.one;
            capsule.Shape = ColliderShape.Capsule;
            capsule.Center = Vector3.zero;
            capsule.Radius = fitted.radius;
            capsule.Height = fitted.height;
            return capsule;
        }

        // Directions along which a limb may lie: to the next bones, and the bone's own axes.
        static float3[] Axes(Transform[] bones, int bone)
        {
            var axes = new List<float3> { new float3(1f, 0f, 0f), new float3(0f, 1f, 0f), new float3(0f, 0f, 1f) };
            foreach (Transform other in bones)
                if (other != null && other.parent == bones[bone])
                    axes.Add(other.localPosition);
            return axes.ToArray();
        }

        FluidCollider Find(Transform bone)
        {
            foreach (FluidCollider capsule in capsules)
                if (capsule != null && capsule.transform.parent == bone)
                    return capsule;
            return null;
        }

        static FluidCollider Make(Transform bone)
        {
            GameObject made = FindEmpty(bone);
            bool isNew = made == null;
            if (isNew)
            {
                made = new GameObject(CapsuleName) { layer = bone.gameObject.layer };
                made.transform.SetParent(bone, false);
            }
            var capsule = made.AddComponent<FluidCollider>();
            Undo?.Created(isNew ? made : (UnityEngine.Object)capsule);
            return capsule;
        }

        // Finds what a capsule left in an instance of a prefab.
        static GameObject FindEmpty(Transform bone)
        {
            for (int i = 0; i < bone.childCount; i++)
                if (bone.GetChild(i).name == CapsuleName && IsPlain(bone.GetChild(i), 1))
                    return bone.GetChild(i).gameObject;
            return null;
        }

        static bool IsPlain(Transform one, int components) => one.childCount == 0 && one.GetComponents<Component>().Length == components;

        static void Destroy(FluidCollider capsule)
        {
            if (capsule == null)
                return;
            // An object that the user has put more on keeps what is not ours.
            bool goesWhole = IsPlain(capsule.transform, 2) && (Undo == null || Undo.MayDestroy(capsule.gameObject));
            UnityEngine.Object gone = goesWhole ? (UnityEngine.Object)capsule.gameObject : capsule;
            if (Undo != null)
                Undo.Destroy(gone);
            else
                DestroyImmediate(gone);
        }
    }
}
