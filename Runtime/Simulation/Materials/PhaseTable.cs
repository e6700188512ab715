using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Materials of a fluid's phases: those of its list, and those that emitters, volumes and scripts bring besides.</summary>
    sealed class PhaseTable
    {
        const int TooMany = 0, TooLight = 1, TooFast = 2;       // problems

        readonly FluidSimulation fluid;
        readonly FluidMaterialAsset[] added = new FluidMaterialAsset[PhaseMaterials.Phases];        // by phase
        OnceLog log;
        string tooMany, tooLight;
        float diffusion;            // of the last step, m²/s; 0 where it acts in full
        double diffusionLimit;      // m²/s
        int substeps;
        float lightest;     // kg/m³ that a fluid can hold

        public PhaseTable(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Problem of the materials; null for none.</summary>
        public string Problem => tooMany ?? TooLightProblem ?? TooFastProblem;

        /// <summary>Forgets what was added, as the fluid begins.</summary>
        public void Clear()
        {
            Array.Clear(added, 0, added.Length);
            log.Reset();
            tooMany = tooLight = null;
            diffusion = 0f;
        }

        /// <summary>Returns the material of a phase; null for the fluid's own.</summary>
        public FluidMaterialAsset this[int phase]
        {
            get
            {
                if (phase < 1 || phase >= PhaseMaterials.Phases)
                    return null;
                FluidMaterialAsset[] listed = fluid.PhaseMaterials;
                FluidMaterialAsset own = phase <= listed.Length ? listed[phase - 1] : null;
                return own != null ? own : added[phase];
            }
        }

        /// <summary>Returns the phase of a material, which gets one if it has none. Logs once, by name, what has no phase left.</summary>
        /// <param name="material">Null for the fluid's own.</param>
        /// <param name="own">Phase without a material, or with one that none is left for.</param>
        public int PhaseOf(FluidMaterialAsset material, int own = 0)
        {
            if (material == null)
                return own;
            if (Find(material) is int known && known > 0)
                return known;
            for (int phase = 1; phase < PhaseMaterials.Phases; phase++)
            {
                if (this[phase] != null || fluid.Inputs.Parts.NamesPhase(phase))
                    continue;
                added[phase] = material;
                return phase;
            }
            tooMany = $"it has no phase left for the material '{material.name}', and uses its own instead: a fluid holds " +
                Invariant($"{PhaseMaterials.Phases - 1} materials besides its own, and has {Names()}. Let two liquids have ") +
                "one material, or put this one into a fluid of its own.";
            if (log.ShouldLog(TooMany))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {tooMany}", fluid);
            return own;
        }

        /// <summary>Whether the phases of the last steps differed in density or viscosity.</summary>
        public bool Differ => fluid.Input.phases.Differ(fluid.Material);

        /// <summary>Whether two phases mix, by themselves or through others, in the last steps. A phase mixes with itself.</summary>
        public bool Mix(int a, int b) => fluid.Input.phases.AreMixing(a, b);

        /// <summary>Returns the density with which the particles of a phase move, kg/m³.</summary>
        /// <param name="phase">0 to 7.</param>
        /// <param name="own">Density of the fluid's own material.</param>
        public float Density(int phase, float own) => (fluid.StepCount > 0 ? fluid.Input.phases : ForStep()).Density(phase, own);

        /// <summary>Finds phases for the materials of a connected fluid, whose particles come with them.</summary>
        /// <returns><see cref="ParticleTags.PhaseBits"/> for each phase of the other fluid, from phase 0 on: the bits that differ in the number
        /// that it has here. A phase without a material keeps its number, or becomes phase 0 where a material has the number.</returns>
        public uint ChangesFrom(PhaseTable other)
        {
            uint changes = 0;
            for (int phase = 1; phase < PhaseMaterials.Phases; phase++)
            {
                FluidMaterialAsset material = other[phase];
                int here = material != null ? PhaseOf(material) : this[phase] == null ? phase : 0;
                changes |= (uint)(phase ^ here) << ParticleTags.PhaseBits * phase;
            }
            return changes;
        }

        /// <summary>Returns the materials for a step, within what a fluid can hold together.</summary>
        public PhaseMaterials ForStep()
        {
            fluid.Inputs.Parts.FindPhases();
            var phases = new PhaseMaterials();
            FluidMaterial own = fluid.Material;
            float heaviest = own.density;
            for (int phase = 1; phase < PhaseMaterials.Phases; phase++)
                if (this[phase] != null)
                    heaviest = Mathf.Max(heaviest, this[phase].Density);
            lightest = heaviest / PhaseMaterials.MaxRatio;
            tooLight = own.density < lightest ? "own material" : null;
            for (int phase = 1; phase < PhaseMaterials.Phases; phase++)
            {
                FluidMaterialAsset material = this[phase];
                if (material == null)
                    continue;
                phases.Set(phase, Mathf.Max(material.Density, lightest), material.DynamicViscosity, material.SurfaceTension, material.ContactAngle,
                    material.FrictionAngle, material.Cohesion);
                tooLight = material.Density < lightest ? $"material '{material.name}'" : tooLight;
            }
            if (log.ShouldLog(TooLight, tooLight != null))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {TooLightProblem}", fluid);
            foreach (FluidMaterialPair pair in fluid.MaterialPairs)
            {
                int first = Find(pair.first), second = Find(pair.second);
                if (first >= 0 && second >= 0 && first != second)
                    phases.SetPair(first, second, pair.diffusion, pair.interfaceTension);
            }
            return phases;
        }

        /// <summary>Checks a step as it is recorded, and logs once where materials mix slower than they should.</summary>
        public void CheckDiffusion(in StepInput input)
        {
            float asked = input.phases.MaxDiffusion;
            diffusionLimit = Diffusion.Limit(fluid.ParticleSpacing, input.SubstepTime);
            substeps = input.settings.substeps;
            diffusion = asked > diffusionLimit ? asked : 0f;
            if (log.ShouldLog(TooFast, diffusion > 0f))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {TooFastProblem}", fluid);
        }

        string TooFastProblem
        {
            get
            {
                if (diffusion == 0f)
                    return null;
                double beyond = diffusion / diffusionLimit, needed = Math.Ceiling(substeps * beyond);
                return Invariant($"its diffusion of {diffusion:G3} m²/s acts like {diffusionLimit:G3} m²/s, the most at this spacing and substep. ") +
                    "Take " + (needed <= SolverSettings.MaxSubsteps ? Invariant($"{needed} substeps, or ") : "") +
                    Invariant($"a particle spacing of {fluid.ParticleSpacing * Math.Sqrt(beyond):G3} m, or lower it.");
            }
        }

        // Phase that a material has already, -1 for none.
        int Find(FluidMaterialAsset material)
        {
            if (material == null)
                return 0;
            for (int phase = 1; phase < PhaseMaterials.Phases; phase++)
                if (this[phase] == material)
                    return phase;
            return -1;
        }

        string TooLightProblem => tooLight == null ? null
            : Invariant($"its {tooLight} is lighter than 1/{PhaseMaterials.MaxRatio:0} of its heaviest, and acts as one of ") +
            Invariant($"{lightest:0.###} kg/m³. Bring the densities nearer together.");

        string Names()
        {
            var names = new List<string>();
            for (int phase = 1; phase < PhaseMaterials.Phases; phase++)
                names.Add(this[phase] != null ? $"'{this[phase].name}'" : Invariant($"phase {phase} of an emitter"));
            return string.Join(", ", names);
        }
    }
}
