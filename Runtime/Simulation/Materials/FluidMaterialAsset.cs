using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Material of a liquid that shares a fluid with others: of an emitter, a volume, or what a script fills in.</summary>
    /// <remarks>A fluid gives each material that is used in it a phase, 1 to 7; phase 0 has the fluid's own <see cref="FluidMaterial"/>. A
    /// change acts in the next step.</remarks>
    [CreateAssetMenu(menuName = "Rill/Fluid Material", fileName = "Fluid Material")]
    [Icon(PackagePaths.Icon), ManualPage("materials", "fluid-material-asset")]
    public sealed class FluidMaterialAsset : ScriptableObject, IAppliesSettings, IHasProblems
    {
        [Tooltip("Rest density, kg/m³. 0.001 to 1e6. Lighter liquids rise. Up to 20 times that of the lightest liquid of a fluid costs the " +
            "least; up to 1000 times is possible.")]
        [SerializeField] float density = 1000f;

        [Tooltip("Dynamic viscosity, Pa s, 0 to 1e6: water 0.001, olive oil 0.08, glycerol 1.4, honey 10. 0: none but what Velocity Smoothing " +
            "and the solver itself damp.")]
        [SerializeField] float dynamicViscosity;

        [Tooltip("Surface tension σ, N/m: drops become round, films draw in. 0 (off) to 1000; water 0.072, olive oil 0.032, mercury 0.485. " +
            "Between two liquids acts the difference of theirs.")]
        [SerializeField] float surfaceTension;

        [Tooltip("Angle at which the surface meets walls and colliders, degrees. 0 to 180: above 90 it forms beads, below it spreads. An angle " +
            "below 90 is approximate.")]
        [Range(0f, 180f)]
        [SerializeField] float contactAngle = 90f;

        [Tooltip("Angle of internal friction of grains, degrees: slopes up to it stand. 0 (a liquid) to 45; dry sand has 30 to 35.")]
        [Range(0f, FluidMaterial.MaxFrictionAngle)]
        [SerializeField] float frictionAngle;

        [Tooltip("Shear stress that grains bear without pressure, Pa. 0 to 5000; damp sand has about 500 to 2000. Among as many particles of " +
            "another liquid it is gone.")]
        [Range(0f, FluidMaterial.MaxCohesion)]
        [SerializeField] float cohesion;

        [NonSerialized] ClampedSettings clamped;

        /// <summary>Rest density, kg/m³, 0.001 to 1e6. Out-of-range values are clamped with a warning.</summary>
        public float Density { get => density; set { density = value; ChangedSettings.Apply(this); } }

        /// <summary>Dynamic viscosity, Pa s, 0 to 1e6. Out-of-range values are clamped with a warning.</summary>
        public float DynamicViscosity { get => dynamicViscosity; set { dynamicViscosity = value; ChangedSettings.Apply(this); } }

        /// <summary>Surface tension σ, N/m, 0 (off) to 1000. Out-of-range values are clamped with a warning.</summary>
        /// <remarks>It acts as <see cref="FluidMaterial.surfaceTension"/> does, up to the same limit. Between two liquids acts the difference
        /// of their tensions (Antonow 1907).</remarks>
        public float SurfaceTension { get => surfaceTension; set { surfaceTension = value; ChangedSettings.Apply(this); } }

        /// <summary>Angle at which the surface meets walls and colliders, degrees, 0 to 180. Out-of-range values are clamped with a
        /// warning.</summary>
        public float ContactAngle { get => contactAngle; set { contactAngle = value; ChangedSettings.Apply(this); } }

        /// <summary>Angle of internal friction of grains, degrees, 0 (a liquid) to 45. Out-of-range values are clamped with a
        /// warning.</summary>
        public float FrictionAngle { get => frictionAngle; set { frictionAngle = value; ChangedSettings.Apply(this); } }

        /// <summary>Shear stress that grains bear without pressure, Pa, 0 to 5000. Out-of-range values are clamped with a warning.</summary>
        /// <remarks>It falls to 0 where half of the particles around are of another liquid: damp sand that is flooded.</remarks>
        public float Cohesion { get => cohesion; set { cohesion = value; ChangedSettings.Apply(this); } }

        /// <summary>Returns a new material, for scripts.</summary>
        /// <param name="name">Name, for messages.</param>
        /// <param name="density">kg/m³.</param>
        /// <param name="dynamicViscosity">Pa s.</param>
        public static FluidMaterialAsset Create(string name, float density, float dynamicViscosity = 0f)
        {
            FluidMaterialAsset material = CreateInstance<FluidMaterialAsset>();
            material.name = name;
            material.density = density;
            material.DynamicViscosity = dynamicViscosity;
            return material;
        }

        /// <summary>Features of a fluid that has it besides its own material.</summary>
        internal FeatureSet UsedFeatures => ((FeatureSet)Features.Materials).With(Features.Viscosity, dynamicViscosity > 0f)
            .With(Features.GrainFriction, IsGranular).With(Features.DeepWater, IsGranular);

        bool IsGranular => frictionAngle > 0f || cohesion > 0f;

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings()
        {
            string problem = null;
            Limit.Clamp("density", ref density, 1e-3f, 1e6f, 1000f, ref problem);
            Limit.Clamp("dynamic viscosity", ref dynamicViscosity, 0f, 1e6f, 0f, ref problem);
            Limit.Clamp("surface tension", ref surfaceTension, 0f, FluidMaterial.MaxTension, 0f, ref problem);
            Limit.Clamp("contact angle", ref contactAngle, 0f, 180f, 90f, ref problem);
            Limit.Clamp("friction angle", ref frictionAngle, 0f, FluidMaterial.MaxFrictionAngle, 0f, ref problem);
            Limit.Clamp("cohesion", ref cohesion, 0f, FluidMaterial.MaxCohesion, 0f, ref problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings() => clamped.Log(this);

        void IHasProblems.ListProblems(List<string> problems) => problems.AddIfAny(clamped.Problem);
    }
}
