using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// Keeps surfaces of the opaque scene wet for a while where the <see cref="FluidSimulation"/> on this object has been: they are darker and
    /// mirror the sky until they have dried.
    /// </summary>
    /// <remarks>
    /// It is drawn over the picture of the scene, whatever its material and render pipeline: every camera that shows the object's layer shows
    /// it. Where water was last is kept on a grid over the fluid's box, in the box's own frame: what moves in the box leaves its wetness behind.
    /// See-through materials stay dry. Time is that of the fluid: while it is paused nothing dries.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Wetness"), Icon(PackagePaths.Icon), ManualPage("wetness", "fluid-wetness")]
    [RequireComponent(typeof(FluidSimulation)), DisallowMultipleComponent]
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 100)]    // after the simulation's step
    public sealed class FluidWetness : MonoBehaviour, IDrawsFluid, IHasProblems, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        static FeatureSet UsedFeatures => Features.Wetness;
        const string File = "Wetness";
        const float MinDryingTime = 0.01f, MaxDryingTime = 10000f;
        const float DefaultDryingTime = 8f, DefaultDarkening = 0.4f, DefaultSmoothness = 0.7f;
        const int Vertices = 6;

        [Tooltip("Time in which the wetness falls to 37 % (1/e) once the water is gone, s of the fluid's time. 0.01 to 10,000.")]
        [Range(MinDryingTime, MaxDryingTime)]
        [SerializeField] float dryingTime = DefaultDryingTime;

        [Tooltip("Part of its light that a wet surface loses, 0 to 1. Rough ground that shows a fifth of the light dry loses 0.4; what is " +
            "polished or painted loses less.")]
        [Range(0f, 1f)]
        [SerializeField] float darkening = DefaultDarkening;

        [Tooltip("How smooth the film of water on a wet surface is, 0 to 1: how much of the sky it mirrors, and how sharply. 0: nothing.")]
        [Range(0f, 1f)]
        [SerializeField] float smoothness = DefaultSmoothness;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        static List<FluidWetness> active = new List<FluidWetness>();

        [NonSerialized] FluidSimulation fluid;
        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] Material material;
        [NonSerialized] Cubemap black;      // where the scene has no sky
        WetGrid grid;
        CameraViews<WetnessView> views;
        [NonSerialized] bool isFluidOpaque;

        /// <summary>All that are enabled, for the adapters of the render pipelines.</summary>
        internal static IReadOnlyList<FluidWetness> Active => active;

        /// <summary>Time in which the wetness falls to 37 % (1/e) once the water is gone, s of the fluid's time, 0.01 to 10,000. One that is out
        /// of range is clamped with a warning.</summary>
        public float DryingTime { get => dryingTime; set { dryingTime = value; ChangedSettings.Apply(this); } }

        /// <summary>Part of its light that a wet surface loses, 0 to 1. One that is out of range is clamped with a warning.</summary>
        /// <remarks>By Lekner and Dorf (Applied Optics 27, 1988) a rough surface that shows 0.2 of the light dry loses 0.4 of that by water, one
        /// that shows 0.5 loses 0.3.</remarks>
        public float Darkening { get => darkening; set { darkening = value; ChangedSettings.Apply(this); } }

        /// <summary>How smooth the film of water on a wet surface is, 0 to 1: how much of the sky it mirrors, and how sharply. One that is out of
        /// range is clamped with a warning.</summary>
        public float Smoothness { get => smoothness; set { smoothness = value; ChangedSettings.Apply(this); } }

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        bool IRunsInEditMode.BelongsTo(FluidSimulation of) => TryGetComponent(out FluidSimulation own) && own == of;

        void IHasProblems.ListProblems(List<string> problems) => problems.AddIfAny(clamped.Problem);

        /// <summary>Whether there is anything to draw.</summary>
        internal bool HasAnything => grid != null && grid.HasWater && fluid.IsRunning && (darkening > 0f || smoothness > 0f);

        /// <summary>Makes it ready for a camera and frame.</summary>
        /// <returns>Whether the camera sees any of it; then <see cref="Record"/> draws it.</returns>
        internal bool Prepare(in FluidViews camera)
        {
            if (views.Find(camera.camera) is WetnessView before)
                before.IsPrepared = false;
            if (!HasAnything || (camera.camera.cullingMask & (1 << gameObject.layer)) == 0 || !BoundsOn(camera).IsSeen)
                return false;
            views.ViewOf(camera.camera).IsPrepared = true;
            return true;
        }

        /// <summary>Whether <see cref="Prepare"/> has found that the camera sees any in the picture that it draws now.</summary>
        internal bool IsPreparedFor(Camera camera) => views.IsPreparedFor(camera);

        /// <summary>Records the draw into the target that is bound, with the pipeline's matrices: after the opaque scene, whose depth the pipeline
        /// gives to shaders. Nothing where it was not prepared.</summary>
        /// <param name="camera">With the matrices that it draws with.</param>
        internal void Record(CommandBuffer cmd, in FluidViews camera)
        {
            if (!HasAnything || !(views.Find(camera.camera) is WetnessView view) || !view.IsPrepared)
                return;
            SurfaceConstants constants = default;
            constants.Set(camera);
            constants.pictureBounds = BoundsOn(camera).Bounds;
            view.Write(cmd, constants);
            MaterialPropertyBlock block = view.Properties;
            grid.SetOn(block, fluid.FrameTime);
            block.SetMatrix(DrawnIds.DomainToWorld, fluid.DomainToWorld);
            block.SetMatrix(DrawnIds.WorldToDomain, fluid.DomainToWorld.inverse);
            block.SetVector(DrawnIds.DrawnDomainSize, fluid.DomainSize / fluid.ParticleSpacing);
            block.SetVector(Ids.Look, new Vector4(darkening, smoothness, 1f / dryingTime, isFluidOpaque ? 1f : 0f));
            block.SetVector(Ids.Fog, SceneFog.Parameters);
            block.SetVector(Ids.FogColor, QualitySettings.activeColorSpace == ColorSpace.Linear ? RenderSettings.fogColor.linear
                : RenderSettings.fogColor);
            SetSky(block);
            cmd.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, Vertices, 1, block);
        }

        BoxOnPicture BoundsOn(in FluidViews camera) => BoxOnPicture.Of(camera, new FluidBox(fluid));

        // Probes are given to renderers alone: the draw takes what URP and the Built-in pipeline show where no probe is.
        void SetSky(MaterialPropertyBlock block)
        {
            Texture sky = ReflectionProbe.defaultTexture;
            bool hasSky = sky != null && sky.dimension == TextureDimension.Cube;
            if (!hasSky && black == null)
            {
                black = new Cubemap(1, TextureFormat.RGBA32, false) { name = "Rill.Wetness.NoSky", hideFlags = HideFlags.HideAndDontSave };
                black.Apply(false, true);
            }
            block.SetTexture(Ids.Sky, hasSky ? sky : black);
            block.SetVector(Ids.SkyDecode, hasSky ? ReflectionProbe.defaultTextureHDRDecodeValues : Vector4.zero);
        }

        StageDescription IDrawsFluid.Describe() => Describe();

        /// <summary>Returns the kernels, buffers and draws that it costs the scene.</summary>
        internal StageDescription Describe()
        {
            var description = new StageDescription(nameof(FluidWetness), isActiveAndEnabled, isActiveAndEnabled
                ? $"component on '{name}'" : $"the component on '{name}' is off");
            if (!isActiveAndEnabled)
                return description;
            description.Draw(File, 1);
            grid?.Describe(description);
            return description;
        }

        void OnEnable()
        {
            fluid = GetComponent<FluidSimulation>();
            if (DeviceGate.HasNoGraphics)
                return;
            shaders.Hold();
            try
            {
                if (DeviceGate.ProblemOfDraw(File, DeviceLimits.Current) is string tooSmall)
                    throw new InvalidOperationException(tooSmall);
                material = new Material(StageShader.Load(File).Shader) { hideFlags = HideFlags.HideAndDontSave };
            }
            catch (InvalidOperationException problem)
            {
                Debug.LogError($"Rill: {nameof(FluidWetness)} '{name}' is off: {problem.Message}", this);
                if (fluid.IsInEditMode)
                    OnDisable();        // and stored as it was
                else
                    enabled = false;
                return;
            }
            views = new CameraViews<WetnessView>(camera => new WetnessView(camera));
            fluid.Editing.Recentering.Recentered += Shift;
            active.Add(this);
            BuiltInWetness.Begin();
        }

        void OnDisable()
        {
            if (active.Remove(this))
                BuiltInWetness.End();
            if (fluid != null)
                fluid.Editing.Recentering.Recentered -= Shift;
            views?.Dispose();
            views = null;
            grid?.Dispose();
            grid = null;
            EngineObject.Destroy(ref material);
            EngineObject.Destroy(ref black);
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings()
        {
            string problem = null;
            Limit.Clamp("drying time", ref dryingTime, MinDryingTime, MaxDryingTime, DefaultDryingTime, ref problem);
            Limit.Clamp("darkening", ref darkening, 0f, 1f, DefaultDarkening, ref problem);
            Limit.Clamp("smoothness", ref smoothness, 0f, 1f, DefaultSmoothness, ref problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(UsedFeatures);
        }

        void LateUpdate() => DrawFrame();

        /// <summary>Marks where the water of this frame is. Allocates no managed memory once it runs.</summary>
        internal void DrawFrame()
        {
            if (views == null)
                return;
            views.ReleaseUnused();
            BuiltInWetness.ReleaseUnused();
            if (!fluid.IsRunning)
                return;
            PbfSolver solver = fluid.Solver;
            if (grid != null && !grid.IsOf(solver.Layout.DomainSize))
            {
                grid.Dispose();
                grid = null;
            }
            grid ??= new WetGrid(solver.Layout.DomainSize);
            grid.Mark(solver, fluid.FluidTime);
            isFluidOpaque = TryGetComponent(out ParticleRenderer particles) && particles.isActiveAndEnabled
                || TryGetComponent(out FluidSurfaceMesh mesh) && mesh.isActiveAndEnabled;
        }

        void Shift(Vector3 by) => grid?.Shift(by);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetStatics() => active = new List<FluidWetness>();

        static class Ids
        {
            public static readonly int Look = Shader.PropertyToID("_WetLook");
            public static readonly int Fog = Shader.PropertyToID("_WetFog");
            public static readonly int FogColor = Shader.PropertyToID("_WetFogColor");
            public static readonly int Sky = Shader.PropertyToID("_WetSky");
            public static readonly int SkyDecode = Shader.PropertyToID("_WetSkyDecode");
        }
    }
}
