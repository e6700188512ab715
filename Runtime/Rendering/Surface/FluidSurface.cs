using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Draws the <see cref="FluidSimulation"/> on this object as a liquid: a smooth surface that refracts, reflects and absorbs
    /// light.</summary>
    /// <remarks>
    /// Every camera that shows the object's layer draws it, in every render pipeline, without further wiring. The surface is drawn before
    /// other transparent objects and writes depth; those beyond it are not seen through it while it refracts.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Surface"), Icon(PackagePaths.Icon), ManualPage("surface", "fluid-surface")]
    [DisallowMultipleComponent]
    public sealed class FluidSurface : FluidRenderer
    {
        const float ShadowOffset = 3f;      // d

        [Tooltip("A look that goes by a name. Custom keeps the values below.")]
        [SerializeField] SurfacePreset preset = SurfacePreset.Water;

        [SerializeField] SurfaceLook look = SurfaceLook.Water;

        [Tooltip("Looks of phases 1 to 3, which emitters give: what they absorb and scatter. A phase beyond those that are here has " +
            "the last. Empty: all phases look as above.")]
        [SerializeField] SurfaceLook[] phaseLooks = Array.Empty<SurfaceLook>();

        [Tooltip("Walls of the box at which the mesh has no face: those that stand in other water, or behind a solid.")]
        [SerializeField] BoxWalls hiddenWalls = BoxWalls.None;

        [Tooltip("How fine the surface is: nodes of its mesh 1, 0.75 or 0.5 particle spacings apart. Low is for mobile devices and untethered " +
            "headsets: its textures have half the picture's width and height.")]
        [SerializeField] SurfaceQuality quality = SurfaceQuality.Medium;

        [Tooltip("Shows the scene behind bent, through a copy of the opaque scene. Off: the surface blends over all that is " +
            "behind it; transparent objects behind it need that.")]
        [SerializeField] bool refraction = true;

        [Tooltip("Gathers the sun's light by the surface on what stands in the water, and absorbs it on its path. With Refraction, " +
            "where the sun is known: set Sun, or the sun in Lighting > Environment.")]
        [SerializeField] bool caustics = true;

        [Tooltip("Height of ripples smaller than the particles on water that moves, 0 to 1. 0: none.")]
        [Range(0f, 1f)]
        [SerializeField] float ripples = 0.5f;

        [Tooltip("Surroundings that it mirrors. None: the scene's sky or reflection probe.")]
        [SerializeField] Texture reflection;

        [Tooltip("Factor of what it mirrors, 0 to 4.")]
        [Range(0f, 4f)]
        [SerializeField] float reflectionStrength = 1f;

        [Tooltip("Opacity of the shadow that deep water casts, 0 to 1. Drops, sheets and spray cast less.")]
        [Range(0f, 1f)]
        [SerializeField] float shadowOpacity = 0.4f;

        [Tooltip("Light whose highlight is seen. None: the scene's main light; in HDRP, the brightest directional light that the camera sees.")]
        [SerializeField] Light sun;

        static List<FluidSurface> active = new List<FluidSurface>();

        MeshDraw meshDraw;
        WaterShadow shadow;     // this and the next are made when first needed
        SurfaceMotion motion;
        CausticMap causticMap;  // where caustics are on
        PhaseGrid phaseGrid;    // where phases have looks
        [NonSerialized] bool isCausticMapDue, isPhaseGridDue;     // in this frame, as soon as a camera sees the water
        [NonSerialized] bool hasSaidWhy;        // there is none
        readonly SurfaceWatch watch = new SurfaceWatch();
        MeshFrame? mesh, nextMesh;      // that is drawn, and from the next frame on

        /// <summary>All that are enabled and run, for the adapters of the render pipelines.</summary>
        internal static IReadOnlyList<FluidSurface> Active => active;

        FluidSurface() : base(ShadowCastingMode.On) { }

        /// <summary>A look that goes by a name; setting another than Custom sets <see cref="Look"/>.</summary>
        public SurfacePreset Preset { get => preset; set { preset = value; ApplyPreset(); } }

        /// <summary>How it treats light. Setting it makes the preset Custom; values out of range are brought back with a warning.</summary>
        public SurfaceLook Look { get => look; set { preset = SurfacePreset.Custom; look = value; Changed(); } }

        /// <summary>
        /// Looks of phases 1 to 3, which emitters give: what they absorb and scatter; index of refraction and roughness are those of
        /// <see cref="Look"/>.
        /// A phase beyond those that are here has the last. Empty: all phases have <see cref="Look"/>. More than 3 are left out with a warning.
        /// </summary>
        public SurfaceLook[] PhaseLooks { get => phaseLooks; set { phaseLooks = value ?? Array.Empty<SurfaceLook>(); Changed(); } }

        /// <summary>Walls of the box at which the mesh has no face.</summary>
        public BoxWalls HiddenWalls { get => hiddenWalls; set => hiddenWalls = value & BoxWalls.All; }

        /// <summary>How fine the surface is found and drawn.</summary>
        public SurfaceQuality Quality { get => quality; set => quality = value; }

        /// <summary>Whether the scene behind is seen bent; off, the surface blends over it.</summary>
        public bool Refraction { get => refraction; set => refraction = value; }

        /// <summary>Whether the surface gathers the sun's light on what stands in the water, and absorbs it on its path. With
        /// <see cref="Refraction"/>, where the sun is known.</summary>
        public bool Caustics { get => caustics; set => caustics = value; }

        /// <summary>Height of ripples smaller than the particles, 0 to 1: slopes of up to 0.15 rms at 1. The flow carries them, and water that
        /// stands still has none.</summary>
        public float Ripples { get => ripples; set => ripples = Mathf.Clamp01(value); }

        /// <summary>Cube map of the surroundings that it mirrors; null for the scene's sky or reflection probe.</summary>
        public Texture Reflection { get => reflection; set => reflection = value; }

        /// <summary>Factor of what it mirrors, 0 to 4.</summary>
        public float ReflectionStrength { get => reflectionStrength; set => reflectionStrength = Mathf.Clamp(value, 0f, 4f); }

        /// <summary>Opacity of the shadow that deep water casts, 0 to 1; what is thinner than four spacings casts less.</summary>
        public float ShadowOpacity { get => shadowOpacity; set => shadowOpacity = Mathf.Clamp01(value); }

        /// <summary>Light whose highlight is seen; null for the scene's main light (in HDRP, the brightest directional light that the
        /// camera sees).</summary>
        public Light Sun { get => sun; set => sun = value; }

        /// <summary>Gets or sets a mesh that is drawn instead of the fluid's own surface; null for that.</summary>
        internal MeshFrame? Mesh { get => nextMesh; set => nextMesh = value; }

        /// <summary>The light whose shadow it casts and receives; null where it is not known.</summary>
        internal Light KnownLight => sun != null ? sun : RenderSettings.sun;

        /// <summary>The light of this frame that has come through the surface; null without caustics.</summary>
        internal CausticMap CausticMap => causticMap;

        private protected override Feature Drawn => Features.Surface;
        private protected override FeatureSet UsedFeatures => Features.Surface | Features.SurfaceParticles | Features.SurfaceMesh;
        private protected override string ShaderFile => "Water";

        /// <summary>Before anything else of the surface for this camera and frame.</summary>
        /// <returns>Whether the camera sees it; then <see cref="Submit"/> puts its draw into the queue, before the camera culls, and
        /// <see cref="Record"/> fills what that shows.</returns>
        internal bool Prepare(in FluidViews camera)
        {
            if (!mesh.HasValue || !Simulation.IsRunning || (camera.camera.cullingMask & (1 << gameObject.layer)) == 0)
            {
                meshDraw.TurnOff(camera.camera);
                return false;
            }
            if (!meshDraw.Prepare(camera, mesh.Value))
                return false;
            watch.See();
            UpdateCaustics();
            UpdatePhases();
            return true;
        }

        /// <summary>Whether there is anything to record for the picture that the camera draws now.</summary>
        internal bool IsPreparedFor(Camera camera) => meshDraw.IsPreparedFor(camera);

        /// <summary>Records what the camera needs of the surface; nothing where it was not prepared.</summary>
        /// <param name="camera">With the matrices that it draws with: jittered where antialiasing wants that, of the eyes of this pass.</param>
        /// <param name="shadow">In the Built-in pipeline; null for none.</param>
        internal void Record(CommandBuffer cmd, in FluidViews camera, ShadowCopy shadow = null)
        {
            if (!(mesh is MeshFrame drawn))
                return;
            SurfaceConstants constants = default;
            SetLook(ref constants);
            if (camera.light is FluidViews.Light light)
                (constants.sunDirection, constants.sunColor) = (light.Direction, light.Color);
            if (shadow != null)
                shadow.SetOn(ref constants);
            else
                ShadowCopy.SetNone(ref constants);
            meshDraw.Record(cmd, camera, drawn, constants);
        }

        /// <summary>Draws the surface's motion vectors into the texture and depth that are bound, after <see cref="Record"/>; nothing where
        /// none are needed.</summary>
        internal void RecordMotion(CommandBuffer cmd, in FluidViews camera)
        {
            if (meshDraw.Find(camera.camera) is WaterView view && view.IsPrepared && view.HasMotion)
                (motion ??= new SurfaceMotion()).Record(cmd, view);
        }

        /// <summary>Has the pipeline draw them among the motion vectors of opaque objects instead, after <see cref="Prepare"/> for a camera
        /// that needs them.</summary>
        internal void SubmitMotion(in FluidViews camera)
        {
            WaterView view = meshDraw.Find(camera.camera);
            if (!view.TrySubmitMotion())
                return;
            RenderParams parameters = Parameters(view.Motion);
            parameters.camera = camera.camera;
            (motion ??= new SurfaceMotion()).Submit(parameters);
        }

        /// <summary>Has the camera draw the surface in this frame, after <see cref="Prepare"/>. Once a frame: Unity's queue lives longer than a
        /// picture where the camera draws several, and in the editor while it is paused.</summary>
        /// <param name="sceneColor">The opaque scene, in the Built-in pipeline; null where the pipeline has it as a global.</param>
        /// <param name="shadow">In the Built-in pipeline; null for none.</param>
        internal void Submit(in FluidViews camera, Texture sceneColor, ShadowCopy shadow = null)
        {
            if (mesh is MeshFrame drawn && meshDraw.BeginSubmit(camera, drawn) is MaterialPropertyBlock properties)
                meshDraw.Submit(ShadingParameters(camera, properties, sceneColor, shadow), drawn);
        }

        RenderParams ShadingParameters(in FluidViews camera, MaterialPropertyBlock properties, Texture sceneColor, ShadowCopy shadow)
        {
            if (reflection != null)
                properties.SetTexture(Ids.ReflectionCube, reflection);
            if (sceneColor != null)
                properties.SetTexture(Ids.SceneColor, sceneColor);
            if (shadow != null)
                shadow.SetOn(properties);
            else
                ShadowCopy.SetNone(properties);
            RenderParams parameters = Parameters(properties);
            parameters.camera = camera.camera;
            parameters.shadowCastingMode = ShadowCastingMode.Off;
            parameters.motionVectorMode = MotionVectorGenerationMode.Camera;
            parameters.reflectionProbeUsage = ReflectionProbeUsage.BlendProbes;
            parameters.lightProbeUsage = LightProbeUsage.BlendProbes;
            return parameters;
        }

        private protected override void Begin()
        {
            // Without compute shaders the fluid logs that itself.
            if (SystemInfo.supportsComputeShaders && (SurfaceMesh.DeviceProblem ?? WaterRays.DeviceProblem) is string why)
                throw new InvalidOperationException($"{why}. Draw the fluid with a Particle Renderer there.");
            meshDraw = new MeshDraw(ShaderMaterial);
            active.Add(this);
            Simulation.Results.Surface.Requesting += RequestSurface;
            BuiltInSurfaces.Begin();
        }

        private protected override void End()
        {
            mesh = null;
            active.Remove(this);
            if (Simulation != null)
                Simulation.Results.Surface.Requesting -= RequestSurface;
            BuiltInSurfaces.End();
            RenderSetups.End();
            shadow?.Dispose();
            shadow = null;
            meshDraw?.Dispose();
            meshDraw = null;
            motion?.Dispose();
            motion = null;
            ReleaseCaustics();
            ReleasePhases();
            if (active.Count == 0)
                WaterScratch.Instance.Release();
        }

        private protected override void ReleaseUnused()
        {
            meshDraw?.ReleaseUnused();
            WaterScratch.Instance.ReleaseUnused();
            BuiltInSurfaces.ReleaseUnused();
        }

        bool CastsShadow => CastShadows != ShadowCastingMode.Off && shadowOpacity > 0f;

        // The surface is found where a camera can see it or its shadow.
        void RequestSurface()
        {
            Simulation.Results.Surface.RequestMesh(CellOf(quality), BoxWalls.All & ~hiddenWalls);
            if (Simulation.IsInEditMode)        // scene views are not among the cameras that are asked
            {
                Simulation.Results.Surface.IsNeeded = true;
                return;
            }
            bool casts = CastsShadow;
            Light light = KnownLight;
            // The shadow of an unknown light may fall anywhere.
            if (casts && light == null || watch.IsSeen(gameObject.layer, new FluidBox(Simulation), casts
                ? light.transform.forward * QualitySettings.shadowDistance : Vector3.zero))
                Simulation.Results.Surface.IsNeeded = true;
        }

        private protected override void Draw()
        {
            PbfSolver solver = Simulation.Solver;
            mesh = nextMesh ?? (solver.Mesh != null ? MeshFrame.Of(Simulation, solver.Mesh, quality) : default(MeshFrame?));
            if (!(mesh is MeshFrame found))
            {
                ReleasePhases();
                ReleaseCaustics();
                return;
            }
            found.lastDomainToWorld = LastDomainToWorld;
            found.SetRipples(Simulation, ripples);
            if (TryGetComponent(out FluidFoam foam))
                found.foam = foam.Frame;
            found.phases = FollowPhases(solver);
            found.caustics = FollowCaustics();
            mesh = found;
            meshDraw.SetKeywords(refraction, reflection != null, found.HasFoam);
            if (!CastsShadow)
                return;
            shadow ??= new WaterShadow();
            shadow.Draw(Parameters(shadow.Properties), found, shadowOpacity, causticMap != null, KnownLight);
        }

        // Returns null where there are none.
        CausticMap FollowCaustics()
        {
            Light light = KnownLight;
            bool isOn = caustics && refraction && light != null && light.isActiveAndEnabled && light.intensity > 0f
                && light.type == LightType.Directional;
            if (isOn && causticMap == null && !hasSaidWhy && CausticMap.DeviceProblem is string why)
            {
                Debug.LogWarning($"Rill: FluidSurface '{name}' gathers no sunlight in the water: {why}. Turn its Caustics off there.", this);
                hasSaidWhy = true;
            }
            isOn &= !hasSaidWhy;
            if (isOn)
                causticMap ??= new CausticMap();
            else
                ReleaseCaustics();
            isCausticMapDue = isOn;
            return causticMap;
        }

        void ReleaseCaustics()
        {
            causticMap?.Dispose();
            causticMap = null;
            isCausticMapDue = false;
        }

        void UpdateCaustics()
        {
            if (!isCausticMapDue)
                return;
            isCausticMapDue = false;
            Light light = KnownLight;
            if (light == null)      // a script may have destroyed it meanwhile
                return;
            causticMap.Update(mesh.Value, -light.transform.forward, Simulation.Gravity, look.refractionIndex, quality);
        }

        // Returns null where all phases look alike.
        PhaseGrid FollowPhases(PbfSolver solver)
        {
            bool isOn = phaseLooks.Length > 0 && solver.Tags != null;
            if (!isOn || phaseGrid != null && !phaseGrid.IsOf(solver.Layout.DomainSize))
                ReleasePhases();
            if (isOn)
                phaseGrid ??= new PhaseGrid(solver.Layout.DomainSize);
            isPhaseGridDue = isOn;
            return phaseGrid;
        }

        void UpdatePhases()
        {
            if (!isPhaseGridDue)
                return;
            isPhaseGridDue = false;
            if (Simulation.Solver.Tags != null)     // a script may have cleared the fluid meanwhile
                phaseGrid.Update(Simulation.Solver);
        }

        void ReleasePhases()
        {
            isPhaseGridDue = false;
            phaseGrid?.Dispose();
            phaseGrid = null;
        }

        /// <summary>Distance of the mesh's nodes, d.</summary>
        internal static float CellOf(SurfaceQuality quality) => quality == SurfaceQuality.Low ? 1f : quality == SurfaceQuality.Medium ? 0.75f : 0.5f;

        private protected override void DescribeDraws(StageDescription description)
        {
            meshDraw?.Describe(description);
            causticMap?.Describe(description);
            phaseGrid?.Describe(description);
            shadow?.Describe(description);
            BuiltInSurfaces.Describe(description);
        }

        private protected override string ValidateValues()
        {
            ApplyPreset();
            look.Validate(out string problem);
            ValidatePhases(ref problem);
            return problem;
        }

        void ValidatePhases(ref string problem)
        {
            if (phaseLooks.Length >= PhaseGrid.MaxPhases)
            {
                Limit.Append(ref problem, Invariant($"of {phaseLooks.Length} phase looks only the first {PhaseGrid.MaxPhases - 1} can be told ") +
                    Invariant($"apart, for phases 1 to {PhaseGrid.MaxPhases - 1}. The rest are removed; give emitters phases up to ") +
                    Invariant($"{PhaseGrid.MaxPhases - 1}."));
                Array.Resize(ref phaseLooks, PhaseGrid.MaxPhases - 1);
            }
            for (int i = 0; i < phaseLooks.Length; i++)
            {
                if (phaseLooks[i].Equals(default(SurfaceLook)))
                    phaseLooks[i] = SurfaceLook.Water;      // an element that was just added
                phaseLooks[i].Validate(out string ofPhase);
                if (ofPhase != null)
                    Limit.Append(ref problem, Invariant($"look of phase {i + 1}: {ofPhase}"));
            }
        }

        void ApplyPreset()
        {
            if (preset != SurfacePreset.Custom)
                look = SurfaceLook.Of(preset);
        }

        void SetLook(ref SurfaceConstants constants)
        {
            SunOf(sun, out constants.sunDirection, out constants.sunColor);
            constants.absorption = look.Absorption;
            constants.scattering = ScatteringOf(look);
            bool showsPhases = phaseGrid != null;
            constants.hasPhases = !showsPhases ? 0f : Simulation.Phases.Differ ? 2f : 1f;
            for (int phase = 0; phase < PhaseGrid.MaxPhases && showsPhases; phase++)
            {
                SurfaceLook own = phase == 0 || phaseLooks.Length == 0 ? look : phaseLooks[Mathf.Min(phase, phaseLooks.Length) - 1];
                constants.phaseAbsorption[phase] = own.Absorption;
                constants.phaseScattering[phase] = ScatteringOf(own);
                constants.phaseGroups[phase] = new Vector4(Mix(phase, 1), Mix(phase, 2), Mix(phase, 3), Mix(phase, 0));
            }
            constants.surfaceOptics = new Vector4(look.refractionIndex, look.Reflectance, look.roughness,
                ShadowOffset * Simulation.ParticleSpacing);
            constants.reflectionStrength = reflectionStrength;
            constants.receiveShadows = ReceiveShadows ? 1f : 0f;
        }

        float Mix(int a, int b) => Simulation.Phases.Mix(a, b) ? 1f : 0f;

        static Vector4 ScatteringOf(in SurfaceLook look)
        {
            Vector4 scattering = ShaderColor(look.scattering);
            scattering.w = look.ScatteringRate;
            return scattering;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetStatics() => active = new List<FluidSurface>();

        static class Ids
        {
            public static readonly int SceneColor = Shader.PropertyToID("_SceneColor");
            public static readonly int ReflectionCube = Shader.PropertyToID("_ReflectionCube");
        }
    }
}
