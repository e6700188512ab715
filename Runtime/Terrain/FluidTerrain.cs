using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Makes a Terrain solid for the fluid: gives its heights to the <see cref="FluidCollider"/> beside it, again in the
    /// frame in which they were changed.
    /// </summary>
    /// <remarks>Holes of the terrain are closed, which is logged once; trees and details are no colliders. Without the terrain module this
    /// component is not there.</remarks>
    [AddComponentMenu("Rill/Fluid Terrain"), Icon(PackagePaths.Icon)]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(FluidCollider), typeof(Terrain))]
    public sealed class FluidTerrain : MonoBehaviour, IHasProblems, IRunsInEditMode
    {
        [Tooltip("Part of the terrain that the fluid can reach, as fractions of its sides from 0 to 1. A smaller part is exact in " +
            "large terrains and costs less memory.")]
        [SerializeField] Rect part = new Rect(0f, 0f, 1f, 1f);

        const string HolesProblem = "its Terrain has holes, which are closed to water. Lower the ground there, or leave the terrain " +
            "out and put Fluid Colliders where it is.";

        FluidCollider collider;
        Terrain terrain;
        HeightField heights;
        string clamped;     // what the newest validation changed
        string refusal;     // why the newest heights were not taken
        ColliderShape shapeBefore;
        RectInt taken;      // of the terrain's heights
        bool isStale, holesAreKnown;

        /// <summary>Part of the terrain that the fluid can reach, as fractions of its sides along x and z, 0 to 1. After a change call
        /// <see cref="Refresh"/>.</summary>
        public Rect Part { get => part; set { part = value; OnValidate(); } }

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            var clamped = Rect.MinMaxRect(Mathf.Clamp01(part.xMin), Mathf.Clamp01(part.yMin), Mathf.Clamp01(part.xMax), Mathf.Clamp01(part.yMax));
            if (clamped == part && part.width > 0f && part.height > 0f)
                return true;
            string given = $"part {part} does not lie within 0 to 1 along both sides";
            part = clamped.width > 0f && clamped.height > 0f ? clamped : new Rect(0f, 0f, 1f, 1f);
            problem = $"{given}; {part} is used.";
            return false;
        }

        /// <summary>Takes the terrain's heights again: after a change of <see cref="Part"/> or of the terrain's size. Edits of heights are
        /// noticed without it.</summary>
        public void Refresh()
        {
            Release();
            refusal = null;
            isStale = false;
            TerrainData data = GetComponent<Terrain>().terrainData;
            if (data == null)
            {
                Refuse("its Terrain has no terrain data. Assign some.");
                return;
            }
            int last = data.heightmapResolution - 1;
            int x = Mathf.FloorToInt(part.xMin * last), z = Mathf.FloorToInt(part.yMin * last);
            int countX = Mathf.CeilToInt(part.xMax * last) - x + 1, countZ = Mathf.CeilToInt(part.yMax * last) - z + 1;
            if (Mathf.Max(countX, countZ) > HeightField.MaxHeights)
            {
                Refuse($"it has {countX} x {countZ} heights, and {HeightField.MaxHeights} along a side can be taken. Set Part to where " +
                    $"the fluid gets, or lower the terrain's heightmap resolution.");
                return;
            }
            taken = new RectInt(x, z, countX, countZ);
            SayHoles(data);
            Vector3 size = data.size, spacing = size / last;
            float[,] fractions = data.GetHeights(x, z, countX, countZ);
            for (int i = 0; i < countZ; i++)
                for (int k = 0; k < countX; k++)
                    fractions[i, k] *= size.y;
            try
            {
                heights = new HeightField(fractions, (countX - 1) * spacing.x, (countZ - 1) * spacing.z,
                    new Vector3(x * spacing.x, 0f, z * spacing.z));
            }
            catch (ArgumentException e)
            {
                Refuse(e.Message);
                return;
            }
            shapeBefore = collider.Shape;
            collider.Shape = ColliderShape.HeightField;
            collider.Heights = heights;
        }

        void OnEnable()
        {
            collider = GetComponent<FluidCollider>();
            terrain = GetComponent<Terrain>();
            Refresh();
            TerrainCallbacks.heightmapChanged += OnHeightsChanged;
        }

        void OnDisable()
        {
            TerrainCallbacks.heightmapChanged -= OnHeightsChanged;
            Release();
        }

        // Before the steps of the frame; once, however many edits there were.
        void LateUpdate()
        {
            if (isStale)
                Refresh();
        }

        // Heights that were edited on the GPU come to the CPU later, which is told again.
        void OnHeightsChanged(Terrain changed, RectInt region, bool synched)
        {
            if (synched && ReferenceEquals(changed, terrain) && region.Overlaps(taken))
                isStale = true;
        }

        void OnValidate()
        {
            if (!Validate(out clamped))
                Debug.LogWarning($"Rill: FluidTerrain '{name}': {clamped}", this);
        }

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => true;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped);
            problems.AddIfAny(refusal);
            problems.AddIfAny(holesAreKnown ? HolesProblem : null);
        }

        void SayHoles(TerrainData data)
        {
            if (holesAreKnown || !HasHoles(data))
                return;
            holesAreKnown = true;
            Debug.LogWarning($"Rill: FluidTerrain '{name}': {HolesProblem}", this);
        }

        // A hole is false, between four heights.
        bool HasHoles(TerrainData data)
        {
            int last = data.holesResolution;
            int width = Mathf.Min(taken.xMax, last) - taken.xMin, length = Mathf.Min(taken.yMax, last) - taken.yMin;
            if (width <= 0 || length <= 0)
                return false;
            foreach (bool isGround in data.GetHoles(taken.xMin, taken.yMin, width, length))
                if (!isGround)
                    return true;
            return false;
        }

        void Refuse(string problem)
        {
            refusal = problem;
            Debug.LogError($"Rill: FluidTerrain '{name}' is no collider: {problem}", this);
        }

        void Release()
        {
            if (collider != null && heights != null && ReferenceEquals(collider.Heights, heights))
            {
                collider.Heights = null;
                if (!Application.isPlaying)         // the scene keeps what it stores
                    collider.Shape = shapeBefore;
            }
            heights?.Dispose();
            heights = null;
        }
    }
}
