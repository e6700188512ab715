using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Makes a Terrain solid for the fluid: gives its heights to the <see cref="FluidCollider"/> beside it, again in the
    /// frame in which they were changed.
    /// </summary>
    /// <remarks>A terrain that a <c>FluidPhysicsColliders</c> takes by layer needs it for a part alone, or for a surface of its own.
    /// Holes of the terrain are closed, which is logged once; trees and details are not colliders. Without the terrain module this
    /// component is not there.</remarks>
    [AddComponentMenu("Rill/Fluid Terrain"), Icon(PackagePaths.Icon), ManualPage("colliders", "fluid-terrain")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(FluidCollider), typeof(Terrain))]
    public sealed class FluidTerrain : MonoBehaviour, IHasProblems, IRunsInEditMode, IAppliesSettings
    {
        [Tooltip("Part of the terrain that the fluid can reach, as fractions of its sides from 0 to 1. A smaller part is exact in " +
            "large terrains and costs less memory.")]
        [SerializeField] Rect part = new Rect(0f, 0f, 1f, 1f);

        [NonSerialized] FluidCollider fluidCollider;
        TerrainHeights heights;
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] string refusal;     // why the newest heights were not taken
        [NonSerialized] ColliderShape shapeBefore;
        [NonSerialized] bool holesAreKnown;

        /// <summary>Part of the terrain that the fluid can reach, as fractions of its sides along x and z, 0 to 1. After a change call
        /// <see cref="Refresh"/>.</summary>
        public Rect Part { get => part; set { part = value; Changed(); } }

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            var clamped = Rect.MinMaxRect(Mathf.Clamp01(part.xMin), Mathf.Clamp01(part.yMin), Mathf.Clamp01(part.xMax), Mathf.Clamp01(part.yMax));
            if (clamped == part && part.width > 0f && part.height > 0f)
                return true;
            string given = Invariant($"part {part} does not lie within 0 to 1 along both sides");
            part = clamped.width > 0f && clamped.height > 0f ? clamped : new Rect(0f, 0f, 1f, 1f);
            problem = Invariant($"{given}; {part} is used.");
            return false;
        }

        /// <summary>Takes the terrain's heights again: after a change of <see cref="Part"/>, or of the Terrain's data for other data.
        /// Edits of heights and holes and a change of size are noticed without it.</summary>
        public void Refresh()
        {
            Release();
            refusal = null;
            if (fluidCollider == null || !isActiveAndEnabled)
                return;         // taken as it is enabled
            TerrainData data = GetComponent<Terrain>().terrainData;
            if (data == null)
            {
                Refuse("its Terrain has no terrain data. Assign some.");
                return;
            }
            heights = new TerrainHeights(data, part);
            LogHoles();
            if (heights.Problem != null)
            {
                Refuse(heights.Problem);
                return;
            }
            fluidCollider.Heights = heights.Field;
        }

        void OnEnable()
        {
            fluidCollider = GetComponent<FluidCollider>();
            shapeBefore = fluidCollider.Shape;
            fluidCollider.Shape = ColliderShape.HeightField;        // without heights too: it is not a collider of another shape then
            Refresh();
        }

        void OnDisable()
        {
            Release();
            if (fluidCollider != null && !Application.isPlaying)        // the scene keeps what it stores
                fluidCollider.Shape = shapeBefore;
        }

        // Before the steps of the frame; once, however many edits there were.
        void LateUpdate()
        {
            if (heights != null && heights.IsStale)
                Refresh();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            Validate(out string problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings() => clamped.Log(this);

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => true;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(refusal);
            problems.AddIfAny(holesAreKnown ? TerrainHeights.HolesProblem : null);
        }

        void LogHoles()
        {
            if (heights.HasHoles && !holesAreKnown)
                Debug.LogWarning($"Rill: FluidTerrain '{name}': {TerrainHeights.HolesProblem}", this);
            holesAreKnown = heights.HasHoles;
        }

        void Refuse(string problem)
        {
            refusal = problem;
            Debug.LogError($"Rill: FluidTerrain '{name}' is not a collider: {problem}", this);
        }

        void Release()
        {
            if (fluidCollider != null && heights?.Field != null && ReferenceEquals(fluidCollider.Heights, heights.Field))
                fluidCollider.Heights = null;
            heights?.Dispose();
            heights = null;
        }
    }
}
