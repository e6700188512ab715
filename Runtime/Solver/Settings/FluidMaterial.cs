using System;
using UnityEngine;
using UnityEngine.Serialization;

namespace Rill
{
    /// <summary>Material of a fluid, in SI units, or relative where a unit would make the value depend on the spacing.</summary>
    [Serializable]
    public partial struct FluidMaterial
    {
        /// <summary>Rest density, kg/m³. Matters for energy and for forces on bodies; for the motion of the fluid alone only where it is
        /// elastic.</summary>
        [Tooltip("Rest density, kg/m³. Matters for energy and for forces on bodies; for the motion of the fluid alone only where it is elastic.")]
        [Min(1e-3f)] public float density;

        /// <summary>XSPH: fraction of the velocity difference to the neighbors that is evened out in 1/60 s. 0 (off) to 1. Against noise:
        /// it smooths more at a coarser spacing. For thick fluids use Dynamic Viscosity.</summary>
        [Tooltip("XSPH: fraction of the velocity difference to the neighbors that is evened out in 1/60 s. 0 (off) to 1. Against " +
            "noise: it smooths more at a coarser spacing. For thick fluids use Dynamic Viscosity.")]
        [FormerlySerializedAs("viscosity")]
        [Range(0f, 1f)] public float velocitySmoothing;

        /// <summary>Dynamic viscosity, Pa s: the same fluid at every spacing and step. 0 (off) to 1e6; water 0.001, olive oil 0.08,
        /// glycerol 1.4, honey 10. What Velocity Smoothing and the solver itself damp comes on top.</summary>
        [Tooltip("Dynamic viscosity, Pa s: the same fluid at every spacing and step. 0 (off) to 1e6; water 0.001, olive oil 0.08, " +
            "glycerol 1.4, honey 10. What Velocity Smoothing and the solver itself damp comes on top.")]
        [Min(0f)] public float dynamicViscosity;

        /// <summary>How the domain's walls hold a fluid with a Dynamic Viscosity: 0 slip, 1 no slip. Without one they always slip. Of
        /// colliders: Friction.</summary>
        [Tooltip("How the domain's walls hold a fluid with a Dynamic Viscosity: 0 slip, 1 no slip. Without one they always slip. Of " +
            "colliders: Friction.")]
        [Range(0f, 1f)] public float wallFriction;

        /// <summary>Vorticity confinement, m/s: acceleration per unit of vorticity that keeps eddies alive. 0 (off) to 10.</summary>
        [Tooltip("Vorticity confinement, m/s: acceleration per unit of vorticity that keeps eddies alive. 0 (off) to 10.")]
        [Range(0f, 10f)] public float vorticity;

        /// <summary>Artificial pressure k of s_corr, as the density error that it counters. 0 (off) to 1; 0.1 makes a surface of its own.</summary>
        [Tooltip("Artificial pressure k of s_corr, as the density error that it counters. 0 (off) to 1; 0.1 makes a surface of its own.")]
        [Range(0f, 1f)] public float artificialPressure;

        /// <summary>Distance at which the artificial pressure is k, in support radii. 0.1 to 0.3.</summary>
        [Tooltip("Distance at which the artificial pressure is k, in support radii. 0.1 to 0.3.")]
        [Range(0.1f, 0.3f)] public float artificialPressureDistance;

        /// <summary>Negative density error that is still pulled together. 0 (off) to 0.5; more makes strings and clumps.</summary>
        [Tooltip("Negative density error that is still pulled together. 0 (off) to 0.5; more makes strings and clumps.")]
        [Range(0f, 0.5f)] public float allowedTension;

        /// <summary>Shear modulus G of an elastic fluid, Pa: its stretch pulls back. 0 (off) to 1e6; slime and gels have 100 to 5000. At
        /// any value waves get 0.4 of a spacing in a substep at most.</summary>
        [Tooltip("Shear modulus G of an elastic fluid, Pa: its stretch pulls back. 0 (off) to 1e6; slime and gels have 100 to 5000. At " +
            "any value waves get 0.4 of a spacing in a substep at most.")]
        [Min(0f)] public float shearModulus;

        /// <summary>Time in which an elastic fluid forgets its stretch, s: stress at rest falls by a factor of e. 0.001 to 1000; slime has
        /// about 1, gels many.</summary>
        [Tooltip("Time in which an elastic fluid forgets its stretch, s: stress at rest falls by a factor of e. 0.001 to 1000; slime " +
            "has about 1, gels many.")]
        [Min(1e-3f)] public float relaxationTime;

        /// <summary>Surface tension σ, N/m: drops become round, films draw in. 0 (off) to 1000; water 0.072, mercury 0.485. It needs two
        /// iterations, acts only up to a limit by spacing and substep, and replaces Artificial Pressure and Allowed Tension.</summary>
        [Tooltip("Surface tension σ, N/m: drops become round, films draw in. 0 (off) to 1000; water 0.072, mercury 0.485. It needs two " +
            "iterations, acts only up to a limit by spacing and substep, and replaces Artificial Pressure and Allowed Tension.")]
        [Min(0f)] public float surfaceTension;

        /// <summary>Angle at which the surface of a fluid with a Surface Tension meets walls and colliders, degrees. 0 to 180: above 90 it
        /// forms beads, below it spreads. An angle below 90 is approximate.</summary>
        [Tooltip("Angle at which the surface of a fluid with a Surface Tension meets walls and colliders, degrees. 0 to 180: above 90 it " +
            "forms beads, below it spreads. An angle below 90 is approximate.")]
        [Range(0f, 180f)] public float contactAngle;

        /// <summary>Angle of internal friction of grains, degrees: slopes up to it stand. 0 (a liquid) to 45; dry sand has 30 to 35. It needs
        /// Deep Water.</summary>
        [Tooltip("Angle of internal friction of grains, degrees: slopes up to it stand. 0 (a liquid) to 45; dry sand has 30 to 35. It needs " +
            "Deep Water.")]
        [Range(0f, MaxFrictionAngle)] public float frictionAngle;

        /// <summary>Shear stress that grains bear without pressure, Pa. 0 to 5000; damp sand has about 500 to 2000. It needs Deep
        /// Water.</summary>
        [Tooltip("Shear stress that grains bear without pressure, Pa. 0 to 5000; damp sand has about 500 to 2000. It needs Deep Water.")]
        [Range(0f, MaxCohesion)] public float cohesion;

        /// <summary>Particles are loose balls, one spacing across, instead of a liquid. For few layers: at 60, 120, 240 substeps a second
        /// 1, 2, 3 layers hold of balls of 1 cm, and 2, 3, 4 of 5 cm. Then Deep Water, Surface Tension and Friction Angle do not act.</summary>
        [Tooltip("Particles are loose balls, one spacing across, instead of a liquid. For few layers: at 60, 120, 240 substeps a second " +
            "1, 2, 3 layers hold of balls of 1 cm, and 2, 3, 4 of 5 cm. Then Deep Water, Surface Tension and Friction Angle do not act.")]
        public bool contacts;

        internal const float MaxTension = 1000f, MaxFrictionAngle = 45f, MaxCohesion = 5000f;

        /// <summary>Water: 1000 kg/m³, with as much smoothing as keeps it calm.</summary>
        public static FluidMaterial Water => new FluidMaterial
        {
            density = 1000f,
            velocitySmoothing = 0.01f,
            dynamicViscosity = 0f,
            wallFriction = 1f,
            vorticity = 0f,
            artificialPressure = 0f,
            artificialPressureDistance = 0.2f,
            allowedTension = 0f,
            shearModulus = 0f,
            relaxationTime = 1f,
            surfaceTension = 0f,
            contactAngle = 90f,
            frictionAngle = 0f,
            cohesion = 0f,
            contacts = false,
        };

        /// <summary>A fluid as thick as a real one, the same at every spacing and step; else as water.</summary>
        /// <param name="density">kg/m³.</param>
        /// <param name="dynamicViscosity">Pa s, 0 to 1e6. What smoothing acts like would come on top, so above 0 there is none.</param>
        public static FluidMaterial Viscous(float density, float dynamicViscosity)
        {
            FluidMaterial material = Water;
            material.density = density;
            material.dynamicViscosity = dynamicViscosity;
            if (dynamicViscosity > 0f)
                material.velocitySmoothing = 0f;
            return material;
        }

        /// <summary>Dynamic viscosity that the velocity smoothing acts like, Pa s, in flow that is smooth over a few particles.</summary>
        /// <remarks>
        /// XSPH evens out the velocity's curvature over the kernel: Σ (v_j − v_i) W / ρ0 ≈ ½ Σ W x² / ρ0 · ∇²v, each 1/60 s times the setting. So
        /// it grows with the square of the spacing, and the same setting is a thicker fluid at a coarser resolution.
        /// With a numerical damping q below 1 flow over many spacings sees (2 − q) times that.
        /// </remarks>
        /// <param name="spacing">Particle spacing, m.</param>
        public float SmoothingViscosity(float spacing)
            => (float)(0.5 * velocitySmoothing * density * SolverConstants.SmoothingRate * LatticeKernels.Poly6Spread * spacing * spacing);

        /// <summary>Shear modulus that the setting acts like at most, Pa: beyond it waves, at √(G/ρ), would outrun what a substep can
        /// follow.</summary>
        /// <remarks>That of fluid at rest; one that is stretched, or at a ragged surface, is limited earlier. See Viscoelasticity.compute.</remarks>
        /// <param name="spacing">Particle spacing, m.</param>
        /// <param name="substep">Length of a substep, s.</param>
        public float MaxShearModulus(float spacing, float substep)
            => (float)(Viscoelasticity.MaxStiffness * density * spacing * spacing / ((double)substep * substep));

        /// <summary>Surface tension that the setting acts like at most, N/m: a stronger one would outrun what the passes of a substep can
        /// follow.</summary>
        /// <remarks>See <see cref="SolverSettings"/> for both; Research~/solver-study.md has the measurements.</remarks>
        /// <param name="spacing">Particle spacing, m.</param>
        /// <param name="substep">Length of a substep, s.</param>
        /// <param name="iterations">Iterations of a substep; with fewer than 2 none acts.</param>
        /// <param name="deepWater">Whether the coarse grid carries the pressure of deep water.</param>
        public float MaxSurfaceTension(float spacing, float substep, int iterations = 4, bool deepWater = false)
            => (float)(SurfaceTension.MaxStrength(iterations, deepWater) * SurfaceTension.UnitTension(density, spacing, substep));

        /// <summary>Returns the fluid without anything that acts between its particles.</summary>
        internal FluidMaterial WithoutForces()
        {
            FluidMaterial still = this;
            still.velocitySmoothing = still.dynamicViscosity = still.shearModulus = still.vorticity = still.artificialPressure = 0f;
            still.surfaceTension = still.frictionAngle = still.cohesion = 0f;
            still.contacts = false;
            return still;
        }

        /// <summary>Puts every value into its range.</summary>
        /// <param name="problem">What was wrong and what it became; null if nothing was.</param>
        /// <returns>Whether the material was valid as it stood.</returns>
        public bool Validate(out string problem)
        {
            problem = null;
            FluidMaterial water = Water;
            Limit.Clamp("density", ref density, 1e-3f, 1e6f, water.density, ref problem);
            Limit.Clamp("velocity smoothing", ref velocitySmoothing, 0f, 1f, water.velocitySmoothing, ref problem);
            Limit.Clamp("dynamic viscosity", ref dynamicViscosity, 0f, 1e6f, water.dynamicViscosity, ref problem);
            Limit.Clamp("wall friction", ref wallFriction, 0f, 1f, water.wallFriction, ref problem);
            Limit.Clamp("vorticity", ref vorticity, 0f, 10f, water.vorticity, ref problem);
            Limit.Clamp("artificial pressure", ref artificialPressure, 0f, 1f, water.artificialPressure, ref problem);
            Limit.Clamp("artificial pressure distance", ref artificialPressureDistance, 0.1f, 0.3f, water.artificialPressureDistance, ref problem);
            Limit.Clamp("allowed tension", ref allowedTension, 0f, 0.5f, water.allowedTension, ref problem);
            Limit.Clamp("shear modulus", ref shearModulus, 0f, 1e6f, water.shearModulus, ref problem);
            Limit.Clamp("relaxation time", ref relaxationTime, 1e-3f, 1e3f, water.relaxationTime, ref problem);
            Limit.Clamp("surface tension", ref surfaceTension, 0f, MaxTension, water.surfaceTension, ref problem);
            Limit.Clamp("contact angle", ref contactAngle, 0f, 180f, water.contactAngle, ref problem);
            Limit.Clamp("friction angle", ref frictionAngle, 0f, MaxFrictionAngle, water.frictionAngle, ref problem);
            Limit.Clamp("cohesion", ref cohesion, 0f, MaxCohesion, water.cohesion, ref problem);
            return problem == null;
        }
    }
}
