using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Makes spray, foam and bubbles where the water of the <see cref="FluidSimulation"/> on this object breaks, and draws them.</summary>
    /// <remarks>
    /// Potentials of trapped air, wave crests and kinetic energy (Ihmsen et al. 2012) are summed over the solver's neighbor lists,
    /// once a step. Limits are fixed fractions of the scene's own speed √(g H), so that calm water makes none and the amount does not
    /// depend on the particle spacing. Without this component none of it costs anything. Foam takes no part in the motion of the fluid.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Foam"), Icon(PackagePaths.Icon), ManualPage("foam", "fluid-foam")]
    [DisallowMultipleComponent]
    public sealed class FluidFoam : FluidRenderer, IHasProblems
    {
        const float AutomaticRadius = 0.01f;        // of the scene's depth
        const float MaxRadius = 10f;
        const float Exposure = 0.5f;        // of a step: as a shutter that is open half of the time

        [SerializeField] FoamSettings settings = FoamSettings.Default;

        [Tooltip("Radius of the largest particle, m; the smallest have 0.4 of it. 0: a hundredth of the scene's depth. 0 to 10.")]
        [Range(0f, MaxRadius)]
        [SerializeField] float radius;

        [Tooltip("Color of the foam in white light. Each channel 0 to 1; alpha has no effect, Opacity has.")]
        [SerializeField] Color color = Color.white;

        [Tooltip("Fraction of the background that one particle covers at its center. 0 to 1.")]
        [Range(0f, 1f)]
        [SerializeField] float opacity = 0.6f;

        [Tooltip("Light whose direction and color the foam takes. None: the scene's main light; in HDRP, from above.")]
        [SerializeField] Light sun;

        [Tooltip("Light from all around, added to the sun's. Each channel 0 to 1; black: only the sun. Alpha has no effect.")]
        [SerializeField] Color ambient = new Color(0.42f, 0.47f, 0.55f);

        MaterialPropertyBlock properties;

        /// <summary>How much foam there is and how long it lasts. Out-of-range values are clamped with a warning. Another budget removes
        /// all foam.</summary>
        public FoamSettings Settings { get => settings; set { settings = value; Changed(); } }

        /// <summary>Radius of the largest particle, m, 0 to 10; 0 for a hundredth of the scene's depth. One that is out of range is clamped
        /// with a warning.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }

        /// <summary>Its color in white light.</summary>
        public Color Color { get => color; set => color = value; }

        /// <summary>Fraction of the background that one particle covers at its center, 0 to 1.</summary>
        public float Opacity { get => opacity; set { opacity = value; Changed(); } }

        /// <summary>Light from all around, added to the sun's; alpha has no effect.</summary>
        public Color Ambient { get => ambient; set => ambient = value; }

        /// <summary>Light whose direction and color the foam takes; null for the scene's main light (in HDRP, from above).</summary>
        public Light Sun { get => sun; set => sun = value; }

        FluidFoam() : base(ShadowCastingMode.Off) { }

        private protected override Feature Drawn => Features.Foam;
        private protected override string ShaderFile => "FoamParticles";

        /// <summary>The newest counts, a few frames old; false before the first since a restart, and where the simulation measures nothing
        /// (its statistics interval is 0).</summary>
        public bool TryGetStatistics(out FoamStatistics statistics)
        {
            statistics = default;
            Foam foam = Simulation != null ? Simulation.Solver?.Foam : null;
            return foam != null && foam.TryGetStatistics(out statistics);
        }

        bool IsDrawnBySurface => TryGetComponent(out FluidSurface surface) && surface.isActiveAndEnabled;

        /// <summary>Foam to draw in this frame.</summary>
        internal FoamFrame Frame
        {
            get
            {
                Foam foam = isActiveAndEnabled && Simulation.IsRunning ? Simulation.Solver.Foam : null;
                if (foam == null)
                    return default;
                float largest = radius > 0f ? radius : AutomaticRadius * (float)foam.Scales.Depth * Simulation.ParticleSpacing;
                return new FoamFrame
                {
                    particles = foam.Particles, counters = foam.Counters, arguments = foam.Arguments,
                    look = new Vector4(largest, 0.5f * Simulation.ParticleSpacing, opacity, Exposure * Simulation.FixedStep),
                    color = ShaderColor(color),
                };
            }
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(ClampedProblem);
            if (settings.referenceSpeed == 0f && TryGetComponent(out FluidSimulation simulation) && simulation.Gravity == Vector3.zero)
                problems.Add("makes no foam: without gravity the scene has no speed of its own. Set Reference Speed to that of its " +
                    "fast water, m/s, and Reference Depth to its size, m.");
        }

        private protected override void Begin() => Changed();

        private protected override string ValidateValues()
        {
            settings.Validate(out string problem);
            Limit.Clamp("radius", ref radius, 0f, MaxRadius, 0f, ref problem);
            Limit.Clamp("opacity", ref opacity, 0f, 1f, 0.6f, ref problem);
            return problem;
        }

        private protected override void Draw()
        {
            Simulation.Steps.NeedsFoam = settings;
            FoamFrame foam = Frame;
            if (foam.particles == null || IsDrawnBySurface)
                return;
            properties ??= new MaterialPropertyBlock();
            properties.SetBuffer(DrawnIds.FoamParticles, foam.particles);
            SetFrame(properties);
            properties.SetVector(DrawnIds.FoamLook, foam.look);
            properties.SetVector(Ids.FoamColor, foam.color);
            properties.SetVector(DrawnIds.AmbientColor, ShaderColor(ambient));
            SetSun(properties, sun);
            int command = StereoInstancing.IsActive ? StereoInstancing.StereoCommand : StereoInstancing.MonoCommand;
            Graphics.RenderPrimitivesIndirect(Parameters(properties), MeshTopology.Triangles, foam.arguments, 1, command);
        }

        private protected override void DescribeDraws(StageDescription description)
        {
            if (!IsDrawnBySurface)
                description.Draw(ShaderFile, 1);
        }

        static class Ids
        {
            public static readonly int FoamColor = Shader.PropertyToID("_FoamColor");
        }
    }
}
