using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>A fluid that goes by a name, as an asset: how it flows and how it looks. Presets of the package and of the project are in the
    /// inspector of a <see cref="FluidSimulation"/>.</summary>
    /// <remarks>It is copied to fluids: what is changed here later reaches those that it is applied to again.</remarks>
    [CreateAssetMenu(menuName = "Rill/Fluid Preset", fileName = "Fluid Preset"), Icon(PackagePaths.Icon), ManualPage("editor", "fluid-preset")]
    public sealed class FluidPreset : ScriptableObject, IAppliesSettings, IHasProblems
    {
        [SerializeField] FluidMaterial material = FluidMaterial.Water;

        [Tooltip("Look of the Fluid Surface by its name. Custom: the values below.")]
        [SerializeField] SurfacePreset surface = SurfacePreset.Water;

        [SerializeField] SurfaceLook look = SurfaceLook.Water;

        [Tooltip("Dynamic viscosity of the real fluid, Pa s, where it is so thin that the material has none. For the inspector's text alone. " +
            "0: that of the material.")]
        [Min(0f)]
        [SerializeField] float realViscosity;

        [Tooltip("Conditions that the figures hold for, such as 20 °C. For the inspector's text alone.")]
        [SerializeField] string conditions = "";

        [NonSerialized] ClampedSettings clamped;

        /// <summary>How it flows. Out-of-range values are clamped with a warning.</summary>
        public FluidMaterial Material { get => material; set { material = value; ChangedSettings.Apply(this); } }

        /// <summary>Look of the Fluid Surface by its name; with <see cref="SurfacePreset.Custom"/> <see cref="Look"/> is the preset's own.</summary>
        public SurfacePreset Surface { get => surface; set => surface = value; }

        /// <summary>How it looks. Setting it makes <see cref="Surface"/> Custom; out-of-range values are clamped with a warning.</summary>
        public SurfaceLook Look
        {
            get => surface == SurfacePreset.Custom ? look : SurfaceLook.Of(surface);
            set
            {
                surface = SurfacePreset.Custom;
                look = value;
                ChangedSettings.Apply(this);
            }
        }

        /// <summary>Dynamic viscosity of the real fluid, Pa s, also of one so thin that the material has none.</summary>
        public float RealViscosity { get => realViscosity > 0f ? realViscosity : material.dynamicViscosity; set => realViscosity = value; }

        /// <summary>Conditions that the figures hold for.</summary>
        public string Conditions { get => conditions; set => conditions = value ?? ""; }

        /// <summary>Gives a fluid this material, and the <see cref="FluidSurface"/> on its object, if there is one, this look.</summary>
        /// <remarks>A player has the shaders of the settings that it was built with. A fluid that gets a viscosity, elasticity or
        /// friction by a preset there needs <see cref="ShadersInBuild.AllFeatures"/>.</remarks>
        /// <exception cref="ArgumentNullException">There is no fluid.</exception>
        public void ApplyTo(FluidSimulation fluid)
        {
            if (fluid == null)
                throw new ArgumentNullException(nameof(fluid));
            fluid.Material = material;
            if (!fluid.TryGetComponent(out FluidSurface drawn))
                return;
            if (surface == SurfacePreset.Custom)
                drawn.Look = look;
            else
                drawn.Preset = surface;
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings()
        {
            material.Validate(out string problem);
            look.Validate(out string ofLook);
            Limit.Append(ref problem, ofLook);
            Limit.Clamp("real viscosity", ref realViscosity, 0f, 1e6f, 0f, ref problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings() => clamped.Log(this);

        void IHasProblems.ListProblems(List<string> problems) => problems.AddIfAny(clamped.Problem);
    }
}
