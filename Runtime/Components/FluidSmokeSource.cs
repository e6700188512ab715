using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Heats the air in a ball and fills it with smoke, over a <see cref="FluidSimulation"/> with a Fluid Smoke: a fire, a chimney,
    /// a vent.</summary>
    /// <remarks>Air within the radius takes on what the source gives within a twentieth of a second. Follows position and rotation.</remarks>
    [AddComponentMenu("Rill/Fluid Smoke Source"), Icon(PackagePaths.Icon), ManualPage("smoke", "fluid-smoke-source")]
    public sealed class FluidSmokeSource : FluidPart, ISmokeSource
    {
        const float MaxSpeed = 100f;

        [Tooltip("Radius of the ball, m. Above 0; at least a cell of the smoke's grid is filled.")]
        [SerializeField] float radius = 0.1f;

        [Tooltip("Temperature of the air that it gives, °C. -100 to 3000: hot air rises, cold air sinks; above 525 smoke glows.")]
        [SerializeField] float temperature = 300f;

        [Tooltip("How dense its smoke is: extinction of light, 1/m. 0 (hot air alone) to 1000.")]
        [Range(0f, SmokeSettings.MaxDensity)]
        [SerializeField] float density = 20f;

        [Tooltip("Speed at which it blows along the forward axis, m/s. 0: it lets the air rise by itself. 0 to 100.")]
        [Range(0f, MaxSpeed)]
        [SerializeField] float speed;

        /// <summary>Radius of the ball, m, above 0. At least a cell of the smoke's grid is filled. Out-of-range values are clamped with a
        /// warning.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }

        /// <summary>Temperature of the air that it gives, °C, -100 to 3000. Out-of-range values are clamped with a warning.</summary>
        public float Temperature { get => temperature; set { temperature = value; Changed(); } }

        /// <summary>How dense its smoke is: extinction of light, 1/m, 0 to 1000. Out-of-range values are clamped with a warning.</summary>
        public float Density { get => density; set { density = value; Changed(); } }

        /// <summary>Speed at which it blows along the forward axis, m/s, 0 to 100; 0: the air rises by itself. Out-of-range values are clamped
        /// with a warning.</summary>
        public float Speed { get => speed; set { speed = value; Changed(); } }

        internal override PartKind PartKind => PartKind.SmokeSource;

        bool ISmokeSource.TryGetStep(in DomainFrame frame, float spacing, float airTemperature, out SmokeRegion region)
        {
            region = default;
            if (!TryGetPose(frame, out PoseInDomain pose))
                return false;
            region = new SmokeRegion
            {
                center = pose.position, radius = radius / spacing, velocity = pose.axisZ * (speed / spacing),
                heat = temperature - airTemperature, density = density,
            };
            return true;
        }

        private protected override FeatureSet UsedFeatures => FeatureSet.None;

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Clamp("radius", ref radius, 1e-4f, 1e4f, 0.1f, ref problem);
            Limit.Clamp("temperature", ref temperature, -100f, SmokeSettings.MaxTemperature, 300f, ref problem);
            Limit.Clamp("density", ref density, 0f, SmokeSettings.MaxDensity, 20f, ref problem);
            Limit.Clamp("speed", ref speed, 0f, MaxSpeed, 0f, ref problem);
            return problem;
        }

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems)
        {
            if (!fluid.TryGetComponent(out IHoldsSmoke smoke) || !smoke.IsOn)
                problems.Add(Invariant($"FluidSimulation '{fluid.name}' has no FluidSmoke, so this makes no smoke. Add that component to it."));
        }
    }
}
