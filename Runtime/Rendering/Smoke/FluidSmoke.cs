using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Fills the box of the <see cref="FluidSimulation"/> on this object with air, moves the smoke, steam and fire in it, and draws
    /// them.</summary>
    /// <remarks>
    /// The air lives on a grid. Heat lifts it, colliders and water push it; it pushes neither. Smoke comes from each
    /// <see cref="FluidSmokeSource"/> of the simulation, steam from the water's surface. Snapshots and recordings leave it out. Without this
    /// component none of it costs anything.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Smoke"), Icon(PackagePaths.Icon), ManualPage("smoke", "fluid-smoke")]
    [DisallowMultipleComponent]
    public sealed class FluidSmoke : FluidRenderer, IHasProblems, IHoldsSmoke
    {
        const int VerticesPerSlice = 6, MinSlices = 16, MaxSlices = 192;
        const float MaxGlow = 100f;

        [SerializeField] SmokeSettings settings = SmokeSettings.Default;

        [Tooltip("Color of the smoke in white light: the part of the light that it scatters. Steam is white, soot dark. Each channel 0 to 1; alpha " +
            "has no effect.")]
        [SerializeField] Color color = new Color(0.75f, 0.75f, 0.75f);

        [Tooltip("Light of glowing smoke, relative to that of a soot flame whose red is 1 at 1127 °C (1400 K). 0: none. 0 to 100.")]
        [Range(0f, MaxGlow)]
        [SerializeField] float glow = 1f;

        [Tooltip("Light whose direction and color the smoke takes. None: the scene's main light; in HDRP, from above.")]
        [SerializeField] Light sun;

        [Tooltip("Light from all around, added to the sun's. Each channel 0 to 1; black: only the sun. Alpha has no effect.")]
        [SerializeField] Color ambient = new Color(0.42f, 0.47f, 0.55f);

        MaterialPropertyBlock properties;
        CommandBuffer commands;
        [NonSerialized] int shadedSteps = -1;
        [NonSerialized] Vector3 shadedLight;
        Smoke shaded;

        FluidSmoke() : base(ShadowCastingMode.Off) { }

        /// <summary>How the air moves and what its smoke does. Out-of-range values are clamped with a warning. Another cell size begins
        /// with fresh air.</summary>
        public SmokeSettings Settings { get => settings; set { settings = value; Changed(); } }

        /// <summary>Color of the smoke in white light: the part of the light that it scatters; alpha has no effect.</summary>
        public Color Color { get => color; set => color = value; }

        /// <summary>Light of glowing smoke, relative to that of a soot flame whose red is 1 at 1400 K, 0 to 100; 0: none. One that is out of range
        /// is clamped with a warning.</summary>
        public float Glow { get => glow; set { glow = value; Changed(); } }

        /// <summary>Light whose direction and color the smoke takes; null for the scene's main light (in HDRP, from above).</summary>
        public Light Sun { get => sun; set => sun = value; }

        /// <summary>Light from all around, added to the sun's; alpha has no effect.</summary>
        public Color Ambient { get => ambient; set => ambient = value; }

        bool IHoldsSmoke.IsOn => enabled;

        private protected override Feature Drawn => Features.Smoke;
        private protected override FeatureSet UsedFeatures => Features.Smoke | Features.DeepWater;
        private protected override string ShaderFile => "SmokeVolume";

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(ClampedProblem);
            if (!TryGetComponent(out FluidSimulation simulation))
                return;
            if (simulation.Gravity == Vector3.zero)
                problems.Add("hot air does not rise: the simulation has no gravity. Let the sources blow, or set its Gravity.");
        }

        private protected override void Begin()
        {
            commands = new CommandBuffer { name = "Rill.Smoke.Shade" };
            Changed();
        }

        private protected override void End()
        {
            commands?.Dispose();
            commands = null;
            shaded = null;
        }

        private protected override string ValidateValues()
        {
            settings.Validate(out string problem);
            Limit.Clamp("glow", ref glow, 0f, MaxGlow, 1f, ref problem);
            return problem;
        }

        private protected override void Draw()
        {
            Simulation.Steps.NeedsSmoke = settings;
            Smoke smoke = Simulation.Solver.Smoke;
            if (smoke == null || smoke.Steps == 0)
                return;
            Shade(smoke);
            properties ??= new MaterialPropertyBlock();
            SetFrame(properties);
            properties.SetMatrix(DrawnIds.WorldToDomain, Simulation.DomainToWorld.inverse);
            properties.SetTexture(Ids.Volume, smoke.Volume);
            Vector3 box = Simulation.DomainSize;
            float radius = 0.5f * box.magnitude, cell = math.cmin(smoke.CellSize) * Simulation.ParticleSpacing;
            int slices = Mathf.Clamp(Mathf.CeilToInt(2f * radius / cell), MinSlices, MaxSlices);
            properties.SetVector(Ids.Slices, new Vector4(slices, 2f * radius / slices, radius, glow));
            properties.SetVector(Ids.Cells, new Vector4(smoke.Counts.x, smoke.Counts.y, smoke.Counts.z,
                settings.airTemperature - SmokeSettings.AbsoluteZero));
            properties.SetVector(Ids.Color, ShaderColor(color));
            properties.SetInteger(Ids.OpenSides, (int)settings.openSides);
            properties.SetVector(DrawnIds.AmbientColor, ShaderColor(ambient));
            SetSun(properties, sun);
            Graphics.RenderPrimitives(Parameters(properties), MeshTopology.Triangles, VerticesPerSlice * slices);
        }

        // Once for all cameras, where the air or the light is another.
        void Shade(Smoke smoke)
        {
            SunOf(sun != null ? sun : RenderSettings.sun, out Vector4 towards, out _);
            Vector3 light = Simulation.DomainToWorld.inverse.MultiplyVector(towards).normalized;
            if (smoke == shaded && smoke.Steps == shadedSteps && light == shadedLight)
                return;
            (shaded, shadedSteps, shadedLight) = (smoke, smoke.Steps, light);
            commands.Clear();
            smoke.RecordShade(commands, light, Simulation.ParticleSpacing);
            Graphics.ExecuteCommandBuffer(commands);
        }

        private protected override void DescribeDraws(StageDescription description) => description.Draw(ShaderFile, 1);

        static class Ids
        {
            public static readonly int Volume = Shader.PropertyToID("_SmokeVolume");
            public static readonly int Slices = Shader.PropertyToID("_SmokeSlices");
            public static readonly int Cells = Shader.PropertyToID("_SmokeCells");
            public static readonly int Color = Shader.PropertyToID("_SmokeColor");
            public static readonly int OpenSides = Shader.PropertyToID("_SmokeOpenSides");
        }
    }
}
