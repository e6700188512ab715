using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Makes the <see cref="FluidCollider"/> beside it follow a mesh that deforms: a Skinned Mesh Renderer by its bones, or a Mesh Filter
    /// whose vertices scripts change. The mesh's signed distances are baked again on the GPU where it moved, within a budget.
    /// </summary>
    /// <remarks>
    /// Water is pushed by the surface as it moves along its normal. Bones are those of this frame, seen by a camera or not. Blend shapes,
    /// cloth and vertices that only the GPU knows are not followed. The mesh must be readable, and keeps its triangles: after a change of these
    /// call <see cref="Refresh"/>. Friction, events and forces are set at the collider.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Deforming Mesh"), Icon(PackagePaths.Icon), ManualPage("colliders", "fluid-deforming-mesh")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(FluidCollider))]
    public sealed class FluidDeformingMesh : MonoBehaviour, IDeformingShape, IHasProblems, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        /// <summary>Fewest and most voxels along the longest side.</summary>
        public const int MinResolution = 16, MaxResolution = 64;

        const int MinTriangles = 100, MaxTriangles = 10000000;
        const int Padding = 2;                  // voxels around the mesh
        const float MaxGrowth = 4f;             // of the box, in longest sides of the mesh
        const float StillVoxels = 1e-3f;        // what moves by less is not baked again

        [Tooltip("Voxels along the longest side of the box around the mesh, 16 to 64. A voxel must be smaller than the thinnest limb.")]
        [Range(MinResolution, MaxResolution)]
        [SerializeField] int resolution = 32;

        [Tooltip("Triangles that a frame may bake, 100 to 10,000,000. A mesh with more takes several frames, and follows later.")]
        [SerializeField] int trianglesPerFrame = 50000;

        [Tooltip("Space kept around the mesh for its next poses, as a fraction of its longest side, 0 to 1. " +
            "The box grows where it is too small.")]
        [Range(0f, 1f)]
        [SerializeField] float margin = 0.1f;

        [Tooltip("How inside is told from outside. Automatic: by the winding number, or as a shell where the mesh is open.")]
        [SerializeField] MeshSdfSign sign = MeshSdfSign.Automatic;

        [Tooltip("Thickness of the shell that an open mesh becomes, m. 0: two voxels.")]
        [SerializeField] float shellThickness;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] FluidCollider fluidCollider;
        DeformedMesh mesh;
        DeformingField field;
        SdfGrid grid;
        [NonSerialized] Bounds box, limits;     // that the grid holds, and may hold, in the mesh's frame, m
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] string refusal;         // why no mesh can be used
        [NonSerialized] ColliderShape shapeBefore;
        [NonSerialized] int lastFrame = -1, framesOfBake, framesOfLast, framesSince;
        [NonSerialized] float begun, poseTime;  // s
        (int, float, MeshSdfSign, float) taken;      // settings of the field: with others it is made again
        [NonSerialized] bool isStale, isTooWide;

        /// <summary>Voxels along the longest side of the box around the mesh, 16 to 64. With another the field is made again.</summary>
        public int Resolution { get => resolution; set { resolution = value; Changed(); } }

        /// <summary>Triangles that a frame may bake, 100 to 10,000,000.</summary>
        public int TrianglesPerFrame { get => trianglesPerFrame; set { trianglesPerFrame = value; Changed(); } }

        /// <summary>Space kept around the mesh for its next poses, as a fraction of its longest side, 0 to 1.</summary>
        public float Margin { get => margin; set { margin = value; Changed(); } }

        /// <summary>How inside is told from outside.</summary>
        public MeshSdfSign Sign { get => sign; set { sign = value; Changed(); } }

        /// <summary>Thickness of the shell that an open mesh becomes, m; 0 for two voxels.</summary>
        public float ShellThickness { get => shellThickness; set { shellThickness = value; Changed(); } }

        /// <summary>Side of a voxel, m; 0 without a mesh.</summary>
        public float VoxelSize => mesh != null ? grid.VoxelSize : 0f;

        /// <summary>Fields that were baked since it was enabled or the box grew; 0 while no fluid is near.</summary>
        public int BakedFields => field != null ? field.Version : 0;

        /// <summary>Frames that the newest bake was spread over; 0 before the first.</summary>
        public int FramesPerBake => framesOfLast;

        /// <summary>How long ago the mesh had the pose of the newest field, s. Does not grow while the mesh keeps that pose. 0 before the
        /// first.</summary>
        [field: NonSerialized] public float FieldAge { get; private set; }

        /// <summary>Triangles that are baked; 0 without a mesh.</summary>
        internal int TriangleCount => mesh != null ? mesh.TriangleCount : 0;

        /// <summary>Starts a frame, as if the last one were over.</summary>
        internal void StartFrame() => lastFrame = -1;

        /// <summary>Center of the field now, world space, m.</summary>
        internal Vector3 WorldCenter => mesh != null && mesh.Problem == null ? (Vector3)CenterPose.position : transform.position;

        /// <summary>From the center of the field, m.</summary>
        internal Matrix4x4 FieldToWorld => mesh != null && mesh.Problem == null
            ? Matrix4x4.TRS(CenterPose.position, CenterPose.rotation, Vector3.one) : transform.localToWorldMatrix;

        internal SdfGrid Grid => grid;

        DeformingField IDeformingShape.Field => field;

        RigidPose CenterPose
        {
            get
            {
                RigidPose pose = mesh.Pose;
                pose.position += math.mul(pose.rotation, grid.Bounds.center);
                return pose;
            }
        }

        /// <summary>Takes the mesh again: after it got other triangles, vertices or bones.</summary>
        public void Refresh()
        {
            ReleaseField();
            isStale = false;
            taken = (resolution, margin, sign, shellThickness);
            mesh = DeformedMesh.Of(this, sign, out refusal);
            if (mesh == null)
            {
                Debug.LogError($"Rill: FluidDeformingMesh '{name}' is not a collider: {refusal}", this);
                return;
            }
            limits = mesh.Bounds;
            limits.Expand((MaxGrowth - 1f) * math.cmax((float3)limits.size));
            isTooWide = false;
            FitBox(mesh.Bounds);
        }

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("resolution", ref resolution, MinResolution, MaxResolution, ref problem);
            Limit.Clamp("triangles per frame", ref trianglesPerFrame, MinTriangles, MaxTriangles, ref problem);
            Limit.Clamp("margin", ref margin, 0f, 1f, 0.1f, ref problem);
            Limit.Clamp("shell thickness", ref shellThickness, 0f, 1000f, 0f, ref problem);
            return problem == null;
        }

        /// <summary>Its place and size as a collider, world space, m.</summary>
        /// <returns>Why it is not a collider; null if it is one.</returns>
        internal string Describe(ref ColliderMotion motion, ref RigidPose pose)
        {
            if (mesh == null)
                return refusal ?? "its Fluid Deforming Mesh has not started.";
            if (mesh.Problem is string problem)
                return problem;
            if (isStale)
                Refresh();
            pose = CenterPose;
            if (!Limit.IsPose(pose.position, pose.rotation))
                return "its root bone is not finite. Set its transform to numbers.";
            motion.shape = ColliderShape.Mesh;
            motion.size = grid.Bounds.extents;
            motion.voxel = grid.VoxelSize;
            motion.fieldUnit = 1f;
            motion.field = null;
            motion.deforming = this;
            return null;
        }

        float IDeformingShape.Follow(float reached)
        {
            if (lastFrame != Time.frameCount || !Application.isPlaying)
            {
                lastFrame = Time.frameCount;
                framesSince++;
                Bake();
            }
            return BakedFields < 2 ? 1f : math.saturate((framesSince + reached) / framesOfLast);
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(refusal);
            problems.AddIfAny(isTooWide ? TooWideProblem : null);
            problems.AddIfAny(mesh != null ? mesh.Problem : refusal == null ? DeformedMesh.ProblemOf(this) : null);
        }

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => true;

        FeatureSet IUsesFeatures.UsedFeatures => Features.Baking;

        StageReferences IUsesFeatures.StageReferences => shaders;

        void OnEnable()
        {
            fluidCollider = GetComponent<FluidCollider>();
            shapeBefore = fluidCollider.Shape;
            shaders.Hold();
            Refresh();
            fluidCollider.Shape = ColliderShape.Mesh;
            fluidCollider.Deforming = this;
        }

        void OnDisable()
        {
            if (fluidCollider != null && ReferenceEquals(fluidCollider.Deforming, this))
            {
                fluidCollider.Deforming = null;
                if (!Application.isPlaying)         // the scene keeps what it stores
                    fluidCollider.Shape = shapeBefore;
            }
            ReleaseField();
            mesh = null;
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            Validate(out string problem);
            clamped.Set(problem);
            isStale = mesh != null && taken != (resolution, margin, sign, shellThickness);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(Features.Baking);
        }

        // Bakes for this frame: a bake goes on, or begins where the mesh has moved.
        void Bake()
        {
            if (field == null || !field.IsBaking)
            {
                bool moved = mesh.Follow(StillVoxels * grid.VoxelSize);
                if (field != null && !moved)
                {
                    FieldAge = 0f;
                    return;
                }
                Bounds posed = Limited(mesh.Bounds);
                if (!Contains(box, posed))
                    Grow(posed);
                if (field == null && !TryMakeField())
                    return;
                mesh.Bake();
                field.Begin();
                begun = Time.time;
                framesOfBake = 0;
            }
            framesOfBake++;
            // The first is needed at once.
            if (field.Advance(field.Version == 0 ? mesh.TriangleCount : trianglesPerFrame))
            {
                framesOfLast = framesOfBake;
                framesSince = 0;
                poseTime = begun;
            }
            FieldAge = Time.time - poseTime;
        }

        bool TryMakeField()
        {
            try
            {
                field = new DeformingField(mesh, grid);
                return true;
            }
            catch (InvalidOperationException missing)
            {
                refusal = missing.Message;
                mesh = null;
                Debug.LogError($"Rill: FluidDeformingMesh '{name}' is not a collider: {refusal}", this);
                return false;
            }
        }

        // With what it already holds, so that a motion that repeats makes it grow but once.
        void Grow(Bounds wanted)
        {
            wanted.Encapsulate(box);
            ReleaseField();
            FitBox(wanted);
        }

        // Without what is so far away that a voxel would become too large for the rest.
        Bounds Limited(Bounds wanted)
        {
            if (Contains(limits, wanted))
                return wanted;
            if (!isTooWide)
                Debug.LogWarning($"Rill: FluidDeformingMesh '{name}' {TooWideProblem}", this);
            isTooWide = true;
            wanted.SetMinMax(Vector3.Max(wanted.min, limits.min), Vector3.Min(wanted.max, limits.max));
            return wanted;
        }

        static string TooWideProblem => Invariant($"reaches over more than {MaxGrowth} times its size, and what is beyond is left out. ") +
            "Bring its bones and vertices back, or call Refresh in its new pose.";

        void FitBox(Bounds around)
        {
            float longest = math.cmax((float3)around.size);
            box = around;
            box.Expand(2f * margin * longest);
            var settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            settings.padding = Padding;
            settings.shellThickness = shellThickness;
            grid = new SdfGrid(box, settings, mesh.IsShell);
        }

        static bool Contains(in Bounds outer, in Bounds inner)
            => !(math.any((float3)inner.min < (float3)outer.min) || math.any((float3)inner.max > (float3)outer.max));

        void ReleaseField()
        {
            field?.Dispose();
            field = null;
            framesOfLast = 0;
            FieldAge = 0f;
        }
    }
}
