using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Makes a Terrain solid for the fluid: gives its heights to the <see cref="FluidCollider"/> beside it, again whenever they
    /// were changed and <see cref="Refresh"/> is called.
    /// </summary>
    /// <remarks>Holes of the terrain are closed; trees and details are no colliders. Without the terrain module this component is not there.</remarks>
    [AddComponentMenu("Rill/Fluid Terrain")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(FluidCollider), typeof(Terrain))]
    public sealed class FluidTerrain : MonoBehaviour, IHasProblems
    {
        [Tooltip("Part of the terrain that the fluid can reach, as fractions of its sides from 0 to 1. A smaller part is exact in large terrains and costs less memory.")]
        [SerializeField] Rect part = new Rect(0f, 0f, 1f, 1f);

        FluidCollider collider;
        HeightField heights;
        string clamped;     // what the newest validation changed
        string refusal;     // why the newest heights were not taken

        /// <summary>Part of the terrain that the fluid can reach, as fractions of its sides along x and z, 0 to 1. After a change call <see cref="Refresh"/>.</summary>
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

        /// <summary>Takes the terrain's heights again.</summary>
        public void Refresh()
        {
            Release();
            refusal = null;
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
                Refuse($"it has {countX} x {countZ} heights, and {HeightField.MaxHeights} along a side can be taken. Set Part to where the fluid gets, or lower the terrain's heightmap resolution.");
                return;
            }
            Vector3 size = data.size, spacing = size / last;
            float[,] fractions = data.GetHeights(x, z, countX, countZ);
            for (int i = 0; i < countZ; i++)
                for (int k = 0; k < countX; k++)
                    fractions[i, k] *= size.y;
            try
            {
                heights = new HeightField(fractions, (countX - 1) * spacing.x, (countZ - 1) * spacing.z, new Vector3(x * spacing.x, 0f, z * spacing.z));
            }
            catch (ArgumentException e)
            {
                Refuse(e.Message);
                return;
            }
            collider.Shape = ColliderShape.HeightField;
            collider.Heights = heights;
        }

        void OnEnable()
        {
            collider = GetComponent<FluidCollider>();
            Refresh();
        }

        void OnDisable() => Release();

        void OnValidate()
        {
            if (!Validate(out clamped))
                Debug.LogWarning($"Rill: FluidTerrain '{name}': {clamped}", this);
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped);
            problems.AddIfAny(refusal);
        }

        void Refuse(string problem)
        {
            refusal = problem;
            Debug.LogError($"Rill: FluidTerrain '{name}' is no collider: {problem}", this);
        }

        void Release()
        {
            if (collider != null && ReferenceEquals(collider.Heights, heights))
                collider.Heights = null;
            heights?.Dispose();
            heights = null;
        }
    }
}
