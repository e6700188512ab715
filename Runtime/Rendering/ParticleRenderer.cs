using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Draws the particles of the <see cref="FluidSimulation"/> on this object as lit spheres, straight from the GPU.</summary>
    /// <remarks>
    /// One indirect draw a camera and pass, opaque, with depth, shadows and motion vectors. Lit by the pipeline's main light, or by
    /// <see cref="Sun"/> where one is chosen.
    /// </remarks>
    [AddComponentMenu("Rill/Particle Renderer"), Icon(PackagePaths.Icon), ManualPage("rendering", "particle-renderer")]
    public sealed class ParticleRenderer : FluidRenderer
    {
        /// <summary>Quantity that the color of a particle shows.</summary>
        public enum Quantity
        {
            /// <summary>Speed, m/s.</summary>
            Speed,
            /// <summary>Density error relative to rest density.</summary>
            Density,
            /// <summary>The phase that the emitter gave.</summary>
            Phase,
        }

        [Tooltip("Radius of a sphere, particle spacings. Above 0.5 neighbors overlap and the surface closes.")]
        [Range(0.1f, 2f)]
        [SerializeField] float radius = 0.6f;

        [Tooltip("Quantity that the color shows. Density costs a visit to the neighbors if Velocity Smoothing is 0. Phase: the number that the " +
            "emitter gave, 0 without one.")]
        [SerializeField] Quantity colorBy = Quantity.Speed;

        [Tooltip("Speed, m/s, or relative density error at which the last color is reached.")]
        [Min(1e-4f)]
        [SerializeField] float colorRange = 3f;

        [Tooltip("Color where what is shown is 0, at rest. Each channel 0 to 1; alpha has no effect.")]
        [SerializeField] Color slowColor = new Color(0.03f, 0.22f, 0.55f);

        [Tooltip("Color at half of Color Range. Each channel 0 to 1; alpha has no effect.")]
        [SerializeField] Color middleColor = new Color(0.10f, 0.47f, 0.80f);

        [Tooltip("Color at Color Range and above. Each channel 0 to 1; alpha has no effect.")]
        [SerializeField] Color fastColor = new Color(0.85f, 0.95f, 1.00f);

        [Tooltip("Colors of the phases 0 to 7. A phase beyond those that are there has the last.")]
        [SerializeField]
        Color[] phaseColors =
        {
            new Color(0.10f, 0.40f, 0.75f), new Color(0.85f, 0.30f, 0.20f), new Color(0.20f, 0.65f, 0.30f), new Color(0.95f, 0.75f, 0.20f),
            new Color(0.55f, 0.30f, 0.70f), new Color(0.20f, 0.70f, 0.70f), new Color(0.90f, 0.50f, 0.65f), new Color(0.85f, 0.85f, 0.85f),
        };

        [Tooltip("Light whose direction and color the spheres take. None: the scene's main light; in HDRP, from above.")]
        [SerializeField] Light sun;

        [Tooltip("Light from all around, added to the sun's. Each channel 0 to 1; black: only the sun. Alpha has no effect.")]
        [SerializeField] Color ambient = new Color(0.42f, 0.47f, 0.55f);

        /// <summary>phases with a color of their own, those beyond counting as the last</summary>
        [GenerateHlsl("ParticleRenderer")] const int Phases = 8;

        readonly Vector4[] palette = new Vector4[Phases];
        MaterialPropertyBlock properties;

        /// <summary>Radius of a sphere, particle spacings, 0.1 to 2.</summary>
        public float Radius { get => radius; set => radius = Mathf.Clamp(value, 0.1f, 2f); }

        /// <summary>Color where what is shown is 0; alpha has no effect.</summary>
        public Color SlowColor { get => slowColor; set => slowColor = value; }

        /// <summary>Color at half of <see cref="ColorRange"/>; alpha has no effect.</summary>
        public Color MiddleColor { get => middleColor; set => middleColor = value; }

        /// <summary>Color at <see cref="ColorRange"/> and above; alpha has no effect.</summary>
        public Color FastColor { get => fastColor; set => fastColor = value; }

        /// <summary>Colors of the phases 0 to 7. A phase beyond those that are there has the last.</summary>
        /// <exception cref="ArgumentNullException">Set to null.</exception>
        public Color[] PhaseColors { get => phaseColors; set => phaseColors = value ?? throw new ArgumentNullException(nameof(value)); }

        /// <summary>Light from all around, added to the sun's; alpha has no effect.</summary>
        public Color Ambient { get => ambient; set => ambient = value; }

        /// <summary>Quantity that the color of a particle shows.</summary>
        public Quantity ColorBy { get => colorBy; set => colorBy = value; }

        /// <summary>Speed, m/s, or relative density error at which the last color is reached.</summary>
        public float ColorRange { get => colorRange; set => colorRange = Math.Max(value, 1e-4f); }

        /// <summary>Light whose direction and color the spheres take; null for the scene's main light (in HDRP, from above).</summary>
        public Light Sun { get => sun; set => sun = value; }

        ParticleRenderer() : base(ShadowCastingMode.On) { }

        private protected override Feature Drawn => Features.ParticleRenderer;
        private protected override string ShaderFile => "Particles";

        private protected override void Draw()
        {
            Simulation.Steps.NeedsDensity |= colorBy == Quantity.Density;
            SetProperties();
            int command = StereoInstancing.IsActive ? StereoInstancing.StereoCommand : StereoInstancing.MonoCommand;
            Graphics.RenderPrimitivesIndirect(Parameters(properties), MeshTopology.Triangles, Simulation.Solver.DrawArguments, 1, command);
        }

        private protected override void DescribeDraws(StageDescription description) => description.Draw(ShaderFile, 1);

        void SetProperties()
        {
            properties ??= new MaterialPropertyBlock();
            PbfSolver solver = Simulation.Solver;
            SetParticles(properties);
            properties.SetFloat(Ids.ParticleSpacing, Simulation.ParticleSpacing);
            properties.SetFloat(Ids.ParticleRadius, radius * Simulation.ParticleSpacing);
            SetColors(solver);
            bool speed = colorBy == Quantity.Speed;
            // Density errors have a sign: rest density is the center of the ramp.
            properties.SetVector(Ids.ColorRange, speed ? new Vector4(1f / colorRange, 0f, 0f, 0f) : new Vector4(0f, 0.5f / colorRange, 0.5f, 0f));
            SetSun(properties, sun);
            properties.SetVector(DrawnIds.AmbientColor, ShaderColor(ambient));
        }

        void SetColors(PbfSolver solver)
        {
            bool byPhase = colorBy == Quantity.Phase;
            bool hasPhases = byPhase && solver.Tags != null;
            SetKeyword(ParticleTags.Keyword, hasPhases);
            // If no emitter gave a phase, all are 0.
            properties.SetVector(Ids.SlowColor, ShaderColor(byPhase ? PhaseColor(0) : slowColor));
            properties.SetVector(Ids.MiddleColor, ShaderColor(byPhase ? PhaseColor(0) : middleColor));
            properties.SetVector(Ids.FastColor, ShaderColor(byPhase ? PhaseColor(0) : fastColor));
            if (!hasPhases)
                return;
            for (int phase = 0; phase < Phases; phase++)
                palette[phase] = ShaderColor(PhaseColor(phase));
            properties.SetVectorArray(Ids.PhaseColors, palette);
            properties.SetBuffer(Ids.Tags, solver.Tags);
        }

        Color PhaseColor(int phase) => phaseColors != null && phaseColors.Length > 0 ? phaseColors[Math.Min(phase, phaseColors.Length - 1)]
            : slowColor;

        static class Ids
        {
            public static readonly int Tags = Shader.PropertyToID("_Tags");
            public static readonly int PhaseColors = Shader.PropertyToID("_PhaseColors");
            public static readonly int ParticleSpacing = Shader.PropertyToID("_ParticleSpacing");
            public static readonly int ParticleRadius = Shader.PropertyToID("_ParticleRadius");
            public static readonly int SlowColor = Shader.PropertyToID("_SlowColor");
            public static readonly int MiddleColor = Shader.PropertyToID("_MiddleColor");
            public static readonly int FastColor = Shader.PropertyToID("_FastColor");
            public static readonly int ColorRange = Shader.PropertyToID("_ColorRange");
        }
    }
}
