using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Gives the surface of the <see cref="FluidSimulation"/> on this object to the Mesh Filter there as a closed mesh, so that the Mesh Renderer
    /// draws it with any material: lit or made with Shader Graph, in every render pipeline.
    /// </summary>
    /// <remarks>
    /// Shadows, probes, layers, motion vectors and all else are the Mesh Renderer's. The mesh has positions, normals and, as texture coordinates, x
    /// and z in the world in m; no tangents. Its vertices are on the GPU alone. What is thinner than it can hold, such as drops, is not in it.
    /// A <see cref="FluidSurface"/> is not needed; on the same object it draws its water too.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Surface Mesh"), Icon(PackagePaths.Icon), ManualPage("surface", "fluid-surface-mesh")]
    [RequireComponent(typeof(FluidSimulation), typeof(MeshFilter), typeof(MeshRenderer)), DisallowMultipleComponent]
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 100)]    // after the simulation's step
    public sealed class FluidSurfaceMesh : MonoBehaviour, IDrawsFluid, IHasProblems, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        static FeatureSet UsedFeatures => Features.SurfaceParticles | Features.SurfaceMesh | Features.RenderedMesh;

        [Tooltip("How fine the mesh is: distance of its nodes 1, 0.75 or 0.5 particle spacings. With Low, sheets of one particle tear.")]
        [SerializeField] SurfaceQuality quality = SurfaceQuality.Medium;

        [Tooltip("Walls of the box at which the mesh has no face: those that stand in other water, or behind a solid.")]
        [SerializeField] BoxWalls hiddenWalls = BoxWalls.None;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] FluidSimulation fluid;
        [NonSerialized] MeshFilter filter;
        [NonSerialized] MeshRenderer meshRenderer;
        [NonSerialized] string failure, said;       // why it cannot draw this fluid; what was logged last
        RenderedMesh rendered;

        /// <summary>How fine the mesh is. With a <see cref="FluidSurface"/> on the object the finer of the two holds for both.</summary>
        public SurfaceQuality Quality { get => quality; set => quality = value; }

        /// <summary>Walls of the box at which the mesh has no face. With a <see cref="FluidSurface"/> on the object, walls that both hide.</summary>
        public BoxWalls HiddenWalls { get => hiddenWalls; set => hiddenWalls = value & BoxWalls.All; }

        /// <summary>The mesh, for other renderers on objects with the same transform; null while there is none. It is another once the water has
        /// outgrown it. Its vertices and triangles are on the GPU alone.</summary>
        public Mesh Mesh => rendered?.Mesh;

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        bool IRunsInEditMode.BelongsTo(FluidSimulation of) => TryGetComponent(out FluidSimulation own) && own == of;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(failure);
            problems.AddIfAny(ScaleProblem);
            problems.AddIfAny(MaterialProblem);
        }

        string ScaleProblem => transform.localToWorldMatrix.determinant == 0f
            ? "it draws nothing, since the scale of its transform is 0 along an axis. Set it to another value." : null;

        string MaterialProblem => TryGetComponent(out MeshRenderer own) && own.enabled && own.sharedMaterial == null
            ? "the Mesh Renderer on this object has no material. Give it one." : null;

        StageDescription IDrawsFluid.Describe() => Describe();

        /// <summary>Returns the kernels and buffers that it costs the scene.</summary>
        internal StageDescription Describe()
        {
            var description = new StageDescription(nameof(FluidSurfaceMesh), isActiveAndEnabled, isActiveAndEnabled
                ? $"component on '{name}'" : $"the component on '{name}' is off");
            rendered?.Describe(description);
            return description;
        }

        void OnEnable()
        {
            fluid = GetComponent<FluidSimulation>();
            filter = GetComponent<MeshFilter>();
            meshRenderer = GetComponent<MeshRenderer>();
            failure = said = null;
            if (DeviceGate.HasNoGraphics)
                return;
            shaders.Hold();
            try
            {
                if (SystemInfo.supportsComputeShaders && SurfaceMesh.DeviceProblem is string why)
                    throw new InvalidOperationException($"{why}. Draw the fluid with a Particle Renderer there.");
                rendered = new RenderedMesh();
            }
            catch (InvalidOperationException problem)
            {
                Debug.LogError($"Rill: {nameof(FluidSurfaceMesh)} '{name}' is off: {problem.Message}", this);
                if (fluid.IsInEditMode)
                    OnDisable();        // and stored as it was
                else
                    enabled = false;
                return;
            }
            fluid.Results.Surface.Requesting += RequestSurface;
        }

        void OnDisable()
        {
            if (fluid != null)
                fluid.Results.Surface.Requesting -= RequestSurface;
            Hide();
            rendered?.Dispose();
            rendered = null;
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings() => hiddenWalls &= BoxWalls.All;

        void IAppliesSettings.ApplySettings() => shaders.Follow(UsedFeatures);

        // Who looks at it is not known: shadows of any light and probes may show what no camera sees.
        bool IsWanted => failure == null && meshRenderer != null && meshRenderer.enabled && ScaleProblem == null;

        void RequestSurface()
        {
            if (!IsWanted)
                return;
            fluid.Results.Surface.IsNeeded = true;
            fluid.Results.Surface.RequestMesh(FluidSurface.CellOf(quality), BoxWalls.All & ~hiddenWalls);
        }

        void LateUpdate() => DrawFrame();

        /// <summary>Brings the mesh up to date. Allocates no managed memory while the water does not outgrow it.</summary>
        internal void DrawFrame()
        {
            if (rendered == null)
                return;
            LogOnce(ScaleProblem ?? MaterialProblem);
            if (fluid.IsRunning && fluid.Solver.Mesh is SurfaceMesh surface && IsWanted)
                Show(surface);
            else
                Hide();
        }

        void Show(SurfaceMesh surface)
        {
            try
            {
                rendered.Write(surface, MeshFrame.Of(fluid, surface), transform);
            }
            catch (InvalidOperationException problem)
            {
                failure = $"it draws nothing, since {problem.Message}";
                Debug.LogError($"Rill: {nameof(FluidSurfaceMesh)} '{name}': {failure}", this);
                Hide();
                return;
            }
            if (filter.sharedMesh != rendered.Mesh)
                filter.sharedMesh = rendered.Mesh;
        }

        void Hide()
        {
            if (rendered == null || rendered.Mesh == null)
                return;
            if (filter != null && filter.sharedMesh == rendered.Mesh)
                filter.sharedMesh = null;
            rendered.Release();
        }

        void LogOnce(string problem)
        {
            if (problem != null && problem != said)
                Debug.LogWarning($"Rill: {nameof(FluidSurfaceMesh)} '{name}': {problem}", this);
            said = problem;
        }
    }
}
