using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Draws something of the <see cref="FluidSimulation"/> on the same object with a shader of the package.</summary>
    [RequireComponent(typeof(FluidSimulation))]
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 100)]    // after the simulation's step
    public abstract class FluidRenderer : MonoBehaviour, IDrawsFluid, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [Tooltip("Casts shadows of the scene's lights.")]
        [SerializeField] ShadowCastingMode castShadows;

        [Tooltip("Receives the shadow of the main light.")]
        [SerializeField] bool receiveShadows = true;

        [NonSerialized] Material shaderMaterial;
        [NonSerialized] Matrix4x4 domainToWorld;
        [NonSerialized] int drawnFrame = -2;
        [NonSerialized] ClampedSettings clamped;

        /// <param name="castShadows">What a new component of this kind has.</param>
        private protected FluidRenderer(ShadowCastingMode castShadows) => this.castShadows = castShadows;

        /// <summary>Whether it casts shadows of the scene's lights; <c>TwoSided</c> is the same as <c>On</c>.</summary>
        public ShadowCastingMode CastShadows { get => castShadows; set => castShadows = value; }

        /// <summary>Whether the shadow of the main light falls on it.</summary>
        public bool ReceiveShadows { get => receiveShadows; set => receiveShadows = value; }

        /// <summary>Feature whose first stage holds the shader.</summary>
        private protected abstract Feature Drawn { get; }

        /// <summary>Features that it makes a build contain.</summary>
        private protected virtual FeatureSet UsedFeatures => Drawn;

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => TryGetComponent(out FluidSimulation own) && own == fluid;

        /// <summary>The shader's file, without its extension.</summary>
        private protected abstract string ShaderFile { get; }

        /// <summary>Material with the shader; null while it is off.</summary>
        private protected Material ShaderMaterial => shaderMaterial;

        [field: NonSerialized] private protected FluidSimulation Simulation { get; private set; }

        /// <summary>At the frame before; where nothing was drawn then, at this one.</summary>
        [field: NonSerialized] private protected Matrix4x4 LastDomainToWorld { get; private set; }

        /// <summary>Draws one frame; the simulation is running.</summary>
        private protected abstract void Draw();

        StageDescription IDrawsFluid.Describe() => Describe();

        /// <summary>Describes what this renderer costs the scene.</summary>
        internal StageDescription Describe()
        {
            var description = new StageDescription(GetType().Name, isActiveAndEnabled, isActiveAndEnabled ? $"component on '{name}'"
                : $"the component on '{name}' is off");
            if (isActiveAndEnabled)
                DescribeDraws(description);
            return description;
        }

        private protected abstract void DescribeDraws(StageDescription description);

        /// <summary>When it is enabled and its shader is there.</summary>
        private protected virtual void Begin() { }

        /// <summary>When it is disabled, whether it could begin or not.</summary>
        private protected virtual void End() { }

        /// <summary>Puts every value into its range, when settings were changed or loaded.</summary>
        /// <returns>What was wrong and what it became; null if nothing was.</returns>
        private protected virtual string ValidateValues() => null;

        private protected string ClampedProblem => clamped.Problem;

        private protected void Changed() => ChangedSettings.Apply(this);

        /// <summary>For a draw with these properties: the box is what can be seen of it.</summary>
        private protected RenderParams Parameters(MaterialPropertyBlock properties)
        {
            // Holds the box at any rotation, and the spheres at its walls.
            properties.SetFloat(Ids.ReceiveShadows, receiveShadows ? 1f : 0f);
            float across = Simulation.DomainSize.magnitude + 4f * Simulation.ParticleSpacing;
            return new RenderParams(shaderMaterial)
            {
                worldBounds = new Bounds(Simulation.DomainToWorld.MultiplyPoint3x4(Simulation.DomainSize
                    * (0.5f / Simulation.ParticleSpacing)), Vector3.one * across),
                matProps = properties,
                layer = gameObject.layer,
                shadowCastingMode = castShadows,
                receiveShadows = receiveShadows,
                motionVectorMode = MotionVectorGenerationMode.Object,
            };
        }

        /// <summary>Sets what DrawnParticles.hlsl reads: the particles, at the time of this frame.</summary>
        private protected void SetParticles(MaterialPropertyBlock properties)
        {
            PbfSolver solver = Simulation.Solver;
            properties.SetBuffer(ParticleIds.Positions, solver.Positions);
            properties.SetBuffer(ParticleIds.StartPositions, solver.StartPositions);
            properties.SetBuffer(ParticleIds.Velocities, solver.Velocities);
            properties.SetBuffer(ParticleIds.Counters, solver.Counters);
            properties.SetMatrix(DrawnIds.LastDomainToWorld, LastDomainToWorld);
            SetFrame(properties);
        }

        /// <summary>The domain's pose and this frame's time since the newest step.</summary>
        private protected void SetFrame(MaterialPropertyBlock properties)
        {
            properties.SetVector(DrawnIds.FrameLag, Simulation.Clock.FrameLag);
            properties.SetVector(DrawnIds.DrawnDomainSize, Simulation.DomainSize / Simulation.ParticleSpacing);
            properties.SetMatrix(DrawnIds.DomainToWorld, Simulation.DomainToWorld);
        }

        /// <summary>Replaces the pipeline's main light; null to keep it.</summary>
        private protected static void SetSun(MaterialPropertyBlock properties, Light sun)
        {
            SunOf(sun, out Vector4 direction, out Vector4 color);
            properties.SetVector(Ids.SunDirection, direction);
            properties.SetVector(Ids.SunColor, color);
        }

        /// <summary>Returns the sun as MainLight.hlsl reads it.</summary>
        /// <param name="sun">Replaces the pipeline's; null: it shines from above where the pipeline's is not read.</param>
        private protected static void SunOf(Light sun, out Vector4 direction, out Vector4 color)
        {
            direction = sun != null ? -sun.transform.forward : new Vector3(0.3f, 0.9f, -0.3f).normalized;
            direction.w = sun != null ? 1f : 0f;
            color = sun != null ? ShaderColor(sun.color) * sun.intensity : Vector4.one;
        }

        /// <summary>Turns a keyword of what this renderer draws with on or off.</summary>
        /// <param name="instead">Material to set it on instead of its own; null for its own.</param>
        private protected void SetKeyword(string name, bool isOn, Material instead = null)
        {
            SetKeyword(instead != null ? instead : shaderMaterial, name, isOn);
        }

        /// <summary>Turns a keyword of a material on or off.</summary>
        internal static void SetKeyword(Material material, string name, bool isOn)
        {
            if (isOn == material.IsKeywordEnabled(name))
                return;
            if (isOn)
                material.EnableKeyword(name);
            else
                material.DisableKeyword(name);
        }

        /// <summary>A color as shaders without declared properties need it: in the project's own color space.</summary>
        private protected static Vector4 ShaderColor(Color color)
        {
            return QualitySettings.activeColorSpace == ColorSpace.Linear ? color.linear : color;
        }

        void OnEnable()
        {
            Simulation = GetComponent<FluidSimulation>();
            if (DeviceGate.HasNoGraphics)
                return;
            shaders.Hold();
            try
            {
                if (DeviceGate.ProblemOfDraw(ShaderFile, DeviceLimits.Current) is string tooSmall)
                    throw new InvalidOperationException(tooSmall);
                shaderMaterial = new Material(StageShader.Load(Drawn.Stages[0]).Shader) { hideFlags = HideFlags.HideAndDontSave };
                Begin();
            }
            catch (InvalidOperationException problem)
            {
                Debug.LogError($"Rill: {GetType().Name} '{name}' is off: {problem.Message}", this);
                if (Simulation.IsInEditMode)
                    OnDisable();        // and stored as it was
                else
                    enabled = false;
            }
        }

        void OnDisable()
        {
            End();
            EngineObject.Destroy(ref shaderMaterial);
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings() => clamped.Set(ValidateValues());

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(UsedFeatures);
        }

        void LateUpdate()
        {
            if (!ReferenceEquals(shaderMaterial, null))
                ReleaseUnused();
            DrawFrame();
        }

        /// <summary>Once a frame, whether the fluid runs or not: gives back what has not been needed lately.</summary>
        private protected virtual void ReleaseUnused() { }

        /// <summary>Draws this frame if the simulation is running. Allocates no managed memory.</summary>
        internal void DrawFrame()
        {
            if (!Simulation.IsRunning || ReferenceEquals(shaderMaterial, null))
                return;
            int frame = Time.frameCount;
            if (frame != drawnFrame)
                LastDomainToWorld = frame == drawnFrame + 1 ? domainToWorld : Simulation.DomainToWorld;
            (drawnFrame, domainToWorld) = (frame, Simulation.DomainToWorld);
            Draw();
        }

        static class Ids
        {
            public static readonly int SunDirection = Shader.PropertyToID("_SunDirection");
            public static readonly int SunColor = Shader.PropertyToID("_SunColor");
            public static readonly int ReceiveShadows = Shader.PropertyToID("_ReceiveShadows");
        }
    }
}
