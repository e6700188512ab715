using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Draws something of the <see cref="FluidSimulation"/> on the same object with a shader of the package.</summary>
    [RequireComponent(typeof(FluidSimulation))]
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 100)]    // after the simulation's step
    public abstract class FluidRenderer : MonoBehaviour, IUsesStages
    {
        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        Material material;
        string keyword;

        /// <summary>The one whose asset holds the shader.</summary>
        private protected abstract StageSet Stage { get; }

        StageSet IUsesStages.UsedStages => Stage;

        StageReferences IUsesStages.StageReferences => shaders;

        /// <summary>The shader's file, without its extension.</summary>
        private protected abstract string ShaderFile { get; }

        private protected FluidSimulation Simulation { get; private set; }

        /// <summary>Draws one frame; the simulation is running.</summary>
        private protected abstract void Draw();

        /// <summary>What this renderer costs the scene.</summary>
        internal StageDescription Describe()
        {
            var description = new StageDescription(GetType().Name, isActiveAndEnabled, isActiveAndEnabled ? $"component on '{name}'" : $"the component on '{name}' is off");
            if (isActiveAndEnabled)
                DescribeDraws(description);
            return description;
        }

        private protected abstract void DescribeDraws(StageDescription description);

        /// <summary>For a draw with these properties: the box is what can be seen of it.</summary>
        private protected RenderParams Parameters(MaterialPropertyBlock properties)
        {
            // Holds the box at any rotation, and the spheres at its walls.
            float across = Simulation.DomainSize.magnitude + 4f * Simulation.ParticleSpacing;
            return new RenderParams(material)
            {
                worldBounds = new Bounds(Simulation.DomainToWorld.MultiplyPoint3x4(Simulation.DomainSize * (0.5f / Simulation.ParticleSpacing)), Vector3.one * across),
                matProps = properties,
                layer = gameObject.layer,
                shadowCastingMode = ShadowCastingMode.Off,
                receiveShadows = false,
            };
        }

        /// <summary>What DrawnParticles.hlsl reads: the particles, at the time of this frame.</summary>
        private protected void SetParticles(MaterialPropertyBlock properties)
        {
            PbfSolver solver = Simulation.Solver;
            properties.SetBuffer(Ids.Positions, solver.Positions);
            properties.SetBuffer(Ids.StartPositions, solver.StartPositions);
            properties.SetBuffer(Ids.Velocities, solver.Velocities);
            properties.SetBuffer(Ids.Counters, solver.Counters);
            properties.SetVector(Ids.FrameLag, Simulation.FrameLag);
            properties.SetVector(Ids.DrawnDomainSize, Simulation.DomainSize / Simulation.ParticleSpacing);
            properties.SetMatrix(Ids.DomainToWorld, Simulation.DomainToWorld);
        }

        /// <summary>Turns the one keyword of this renderer's shader on or off.</summary>
        private protected void SetKeyword(string name, bool isOn)
        {
            if (isOn == (keyword != null))
                return;
            keyword = isOn ? name : null;
            if (isOn)
                material.EnableKeyword(name);
            else
                material.DisableKeyword(name);
        }

        /// <summary>A colour as shaders without declared properties need it: in the project's own colour space.</summary>
        private protected static Vector4 ShaderColor(Color color)
        {
            return QualitySettings.activeColorSpace == ColorSpace.Linear ? color.linear : color;
        }

        void OnEnable()
        {
            Simulation = GetComponent<FluidSimulation>();
            keyword = null;
            if (DeviceGate.HasNoGraphics)
                return;
            shaders.Hold();
            try
            {
                if (DeviceGate.ProblemOfDraw(ShaderFile, DeviceLimits.Current) is string tooSmall)
                    throw new InvalidOperationException(tooSmall);
                material = new Material(StageShader.Load(StageSets.StageAt(Stage, 0)).Shader) { hideFlags = HideFlags.HideAndDontSave };
            }
            catch (InvalidOperationException problem)
            {
                Debug.LogError($"Rill: {GetType().Name} '{name}' is off: {problem.Message}", this);
                enabled = false;
            }
        }

        void OnDisable()
        {
            if (Application.isPlaying)
                Destroy(material);
            else
                DestroyImmediate(material);
            material = null;
            shaders.Release();
        }

        void OnValidate() => shaders.Follow(Stage);

        void LateUpdate() => DrawFrame();

        /// <summary>Draws this frame if the simulation is running. Allocates no managed memory.</summary>
        internal void DrawFrame()
        {
            if (Simulation.IsRunning)
                Draw();
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
            public static readonly int FrameLag = Shader.PropertyToID("_FrameLag");
            public static readonly int DrawnDomainSize = Shader.PropertyToID("_DrawnDomainSize");
            public static readonly int DomainToWorld = Shader.PropertyToID("_DomainToWorld");
        }
    }
}
