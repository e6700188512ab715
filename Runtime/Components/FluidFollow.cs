using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Lets the box of its fluid follow a target through the world, in steps, and leaves the water where it is: by
    /// <see cref="FluidSimulation.Recenter"/>. Memory stays that of the box, however large the world.
    /// </summary>
    /// <remarks>It moves the box in LateUpdate, before the fluid steps: after scripts that move the target in Update.</remarks>
    [AddComponentMenu("Rill/Fluid Follow"), Icon(PackagePaths.Icon), ManualPage("control", "fluid-follow")]
    [RequireComponent(typeof(FluidSimulation)), DisallowMultipleComponent]
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder - 10)]
    public sealed class FluidFollow : MonoBehaviour, IHasProblems, IUsesFeatures, IAppliesSettings
    {
        const float DefaultDistance = 4f;

        [Tooltip("Object that the center of the box follows; not an object below the fluid.")]
        [SerializeField] Transform target;

        [Tooltip("How far the target gets from the center of the box before it moves, particle spacings, 1 to 10,000. Foam and deep water " +
            "begin again with each move, so let it move rarely.")]
        [SerializeField] float distance = DefaultDistance;

        [Tooltip("Keeps the box where it is along the world's x.")]
        [SerializeField] bool lockX;

        [Tooltip("Keeps the box at its height.")]
        [SerializeField] bool lockY = true;

        [Tooltip("Keeps the box where it is along the world's z.")]
        [SerializeField] bool lockZ;

        [Tooltip("Treatment of particles that the box leaves behind, apart from those that are handed over.")]
        [SerializeField] LeavingParticles leaving = LeavingParticles.Remove;

        [Tooltip("The fluid that gets the particles left behind that lie in its box; none where it is empty.")]
        [SerializeField] FluidSimulation handOverTo;

        [Tooltip("A volume that is filled again after each move, as far as there is room: a lake as wide as the box, on an object below " +
            "the fluid; none where it is empty.")]
        [SerializeField] FluidVolume refill;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] FluidSimulation fluid;
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] bool said;

        /// <summary>Object that the center of the box follows; not an object below the fluid.</summary>
        public Transform Target { get => target; set { target = value; said = false; } }

        /// <summary>How far the target gets from the center of the box before it moves, particle spacings, 1 to 10,000. Out-of-range values
        /// are clamped with a warning.</summary>
        public float Distance { get => distance; set { distance = value; Changed(); } }

        /// <summary>Whether the box stays where it is along the world's x.</summary>
        public bool LockX { get => lockX; set => lockX = value; }

        /// <summary>Whether the box stays at its height.</summary>
        public bool LockY { get => lockY; set => lockY = value; }

        /// <summary>Whether the box stays where it is along the world's z.</summary>
        public bool LockZ { get => lockZ; set => lockZ = value; }

        /// <summary>Treatment of particles that the box leaves behind, apart from those that are handed over.</summary>
        public LeavingParticles Leaving { get => leaving; set { leaving = value; Changed(); } }

        /// <summary>The fluid that gets the particles left behind that lie in its box; null for none.</summary>
        public FluidSimulation HandOverTo { get => handOverTo; set { handOverTo = value; Changed(); } }

        /// <summary>A volume that is filled again after each move, as far as there is room; null for none.</summary>
        public FluidVolume Refill { get => refill; set { refill = value; said = false; } }

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        FeatureSet UsedFeatures => Features.ParticleEdits
            | (leaving == LeavingParticles.Keep || handOverTo != null ? Features.Transfer : FeatureSet.None);

        FluidSimulation Fluid => fluid != null ? fluid : fluid = GetComponent<FluidSimulation>();

        string TargetProblem => target == null ? "it has no target. Set Target to what the box follows."
            : target.IsChildOf(transform) ? $"its target '{target.name}' is on or below the fluid and moves along with the box. Take it out of there."
            : null;

        // Without which it follows all the same.
        string HandOverProblem => handOverTo == null ? null
            : Fluid.Editing.Recentering.HandOverProblem(handOverTo) is string problem ? $"it hands nothing over: {problem}" : null;

        string RefillProblem => refill == null ? null
            : refill.ProblemWith(Fluid.ParticleSpacing) is string problem ? $"it fills nothing: {problem}" : null;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(TargetProblem);
            problems.AddIfAny(HandOverProblem);
            problems.AddIfAny(RefillProblem);
        }

        void OnEnable()
        {
            said = false;
            shaders.Hold();
        }

        void OnDisable() => shaders.Release();

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            said = false;
            string problem = null;
            Limit.Clamp("distance", ref distance, 1f, 10000f, DefaultDistance, ref problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(UsedFeatures);
        }

        void LateUpdate()
        {
            if (!Fluid.IsRunning)
                return;
            if (target == null || target.IsChildOf(transform))
            {
                if (!said)
                    LogOnce(TargetProblem);
                return;
            }
            Vector3 position = transform.position, away = target.position - position;
            away = new Vector3(lockX ? 0f : away.x, lockY ? 0f : away.y, lockZ ? 0f : away.z);
            float least = distance * fluid.ParticleSpacing;
            if (Limit.IsPose(position + away, Quaternion.identity) && away.sqrMagnitude > least * least)
                Move(position + away);
        }

        void Move(Vector3 position)
        {
            string noHandOver = HandOverProblem, noRefill = RefillProblem;
            LogOnce(noHandOver ?? noRefill);
            fluid.Recenter(position, leaving, noHandOver == null ? handOverTo : null);
            if (refill != null && noRefill == null)
                fluid.Fill(refill);
        }

        void LogOnce(string problem)
        {
            if (problem == null || said)
                return;
            said = true;
            Debug.LogWarning($"Rill: FluidFollow '{name}': {problem}", this);
        }
    }
}
