using System;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Stages for players in which scripts add fluids, or turn features on, that no scene or prefab has. The package brings
    /// one with all of them; an own asset may list fewer.
    /// </summary>
    /// <remarks>
    /// Works while it is loaded: put it into the Preloaded Assets of the player settings, or refer to it from a component
    /// that is loaded before the fluid is enabled.
    /// </remarks>
    [CreateAssetMenu(menuName = "Rill/Fluid Shaders")]
    public sealed class FluidShaders : ScriptableObject
    {
        [Tooltip("Stages that a player with this asset contains. Those of the package lie in its folder Runtime/Stages.")]
        [SerializeField] StageShader[] stages = Array.Empty<StageShader>();

        [NonSerialized] StageShader[] held;

        /// <summary>Stages that a player with this asset contains; set where a script makes the asset.</summary>
        public StageShader[] Stages
        {
            get => stages;
            set
            {
                Release();
                stages = value ?? Array.Empty<StageShader>();
                Hold();
            }
        }

        void OnEnable() => Hold();

        void OnDisable() => Release();

        void Hold()
        {
            held = stages;
            foreach (StageShader stage in held)
                if (stage != null)
                    stage.Hold();
        }

        void Release()
        {
            if (held == null)
                return;
            foreach (StageShader stage in held)
                if (!ReferenceEquals(stage, null))
                    stage.Release();
            held = null;
        }
    }
}
