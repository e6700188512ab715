using System.Collections.Generic;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    // A step at a glance: its order, its stages, and what they cost. A stage that a fluid can do without is made when first needed, and null
    // until then.
    partial class PbfSolver
    {
        /// <summary>Records one step: algorithm 1 of the paper, once a substep.</summary>
        public void Step(CommandBuffer cmd, in StepInput input)
        {
            stepIndex++;
            SurfaceIsCurrent = false;
            InvalidateParticles(false);
            UploadConstants(cmd, input);
            PrepareSources(input);
            PrepareConnections(input);
            UpdateStages(cmd, input);
            Materials?.Upload(cmd, input, Layout.Spacing, Coarse != null);
            Diffusion?.Upload(cmd, input, Layout);
            StepContext step = Context(cmd, input);
            RecordKills(step);
            RecordDrains(step);
            RecordConnections(step);
            for (int substep = 0; substep < step.Substeps; substep++)
            {
                Resting?.Record(step);
                Fields?.Record(step);
                Borders?.Record(step, WaterDepth(input.gravity));
                Colliders?.RecordSubstep(step, substep);
                RecordStart(step);
                Coarse?.RecordColliders(step);
                bool solvesFriction = Friction != null && Coarse != null;
                if (solvesFriction)
                    Friction.RecordAnticipation(step);
                Coarse?.RecordProjection(step);
                bool solvesViscosity = Viscosity != null && hasLists;      // which adds the projection to the velocities
                if (solvesViscosity)
                    Viscosity.Record(step);
                if (solvesFriction)
                    Friction.RecordBefore(step, takesProjection: !solvesViscosity);
                neighborSearch.RecordSort(step, takesProjection: Coarse != null && !solvesViscosity && !solvesFriction,
                    Viscoelasticity?.PreviousIndices);
                ParticleTags?.RecordSort(step);
                if (Contacts == null)
                    densityConstraint.Record(step);
                else
                {
                    densityConstraint.RecordList(step);
                    Contacts.Record(step);
                }
                velocityUpdate.Record(step);
                Viscoelasticity?.Record(step);
                Vorticity?.Record(step);
                if (solvesFriction)
                    Friction.RecordAfter(step);
                hasLists = true;
                particles.Advance();
                Diffusion?.Record(step, (stepIndex - 1) * SolverSettings.MaxSubsteps + (uint)substep);
                if (substep < step.Substeps - 1)
                    RecordEmission(step, substep);
            }
            lastSubsteps = step.Substeps;
            isRestored = false;
            substepsSinceSurface += lastSubsteps;
            Foam?.Record(step, WaterDepth(input.gravity));
            Smoke?.Record(step);
            RecordEmission(step, step.Substeps - 1);
            hasNew = Emitters.IsNeeded(input.sources);
        }

        void RecordStart(in StepContext step)
        {
            if (isStart)
                Colliders?.RecordLeaveOut(step);
            isStart = false;
        }

        readonly Stage[] stages = new Stage[Features.All.Length];       // by Feature.Index

        /// <summary>Solid colliders; null without any.</summary>
        public Colliders Colliders => (Colliders)stages[Features.Colliders.Index];

        /// <summary>Pressure of deep water, on a coarse grid; null while no step has needed it.</summary>
        public CoarseCorrection Coarse => (CoarseCorrection)stages[Features.DeepWater.Index];

        /// <summary>Stretch of an elastic fluid; null while it is not elastic.</summary>
        public Viscoelasticity Viscoelasticity => (Viscoelasticity)stages[Features.Elasticity.Index];

        /// <summary>Sleep of water at rest; null while the settings do without.</summary>
        public RestingRegions Resting => (RestingRegions)stages[Features.Sleep.Index];

        /// <summary>Foam, spray and bubbles; null while nothing asks for them.</summary>
        public Foam Foam => (Foam)stages[Features.Foam.Index];

        /// <summary>Air with smoke; null while nothing asks for it.</summary>
        public Smoke Smoke => (Smoke)stages[Features.Smoke.Index];

        /// <summary>Elements of the surface; null while nothing draws it.</summary>
        public SurfaceParticles Surface => (SurfaceParticles)stages[Features.SurfaceParticles.Index];

        /// <summary>The water's surface as a mesh; null while nothing draws it, or not as a mesh.</summary>
        public SurfaceMesh Mesh => (SurfaceMesh)stages[Features.SurfaceMesh.Index];

        /// <summary>Answers to probes and detectors; null while there are none.</summary>
        public Queries Queries => (Queries)stages[Features.Queries.Index];

        MaterialTable Materials => (MaterialTable)stages[Features.Materials.Index];
        Contacts Contacts => (Contacts)stages[Features.Contacts.Index];
        Diffusion Diffusion => (Diffusion)stages[Features.Diffusion.Index];
        ImplicitViscosity Viscosity => (ImplicitViscosity)stages[Features.Viscosity.Index];
        GrainFriction Friction => (GrainFriction)stages[Features.GrainFriction.Index];
        VelocityExtrapolation Extrapolation => (VelocityExtrapolation)stages[Features.Extrapolation.Index];
        VorticityConfinement Vorticity => (VorticityConfinement)stages[Features.Vorticity.Index];
        Borders Borders => (Borders)stages[Features.Borders.Index];
        ForceFields Fields => (ForceFields)stages[Features.ForceFields.Index];
        Emitters Emitters => (Emitters)stages[Features.Emitters.Index];
        Drains Drains => (Drains)stages[Features.Drains.Index];
        ParticleTags ParticleTags => (ParticleTags)stages[Features.Tags.Index];
        StatisticsPass Statistics => (StatisticsPass)stages[Features.Statistics.Index];
        ParticleAccess Access => (ParticleAccess)stages[Features.ParticleAccess.Index];
        ParticleEdits Edits => (ParticleEdits)stages[Features.ParticleEdits.Index];
        ParticleTransfer Transfer => (ParticleTransfer)stages[Features.Transfer.Index];
        FramePacking Packing => (FramePacking)stages[Features.Recording.Index];

        /// <summary>Returns what each stage costs with this input, in the order of the step.</summary>
        /// <param name="statisticsInterval">Steps between measurements; 0 for none.</param>
        public List<StageDescription> Describe(in StepInput input, int statisticsInterval)
        {
            var state = new StageDescription("Particles", true, Invariant($"capacity {Layout.Capacity:N0}"));
            particles.Describe(state);
            state.Buffer("Rill.Constants", constants);
            StepContext step = Context(null, input);
            return new List<StageDescription>
            {
                state,
                ParticleAccess.Describe(Access, step, noTags),
                Drains.Describe(Drains, step, TagsWithLifetimes),
                ParticleTransfer.Describe(Transfer, input.connections?.count ?? 0, ParticleTags != null, outside),
                RestingRegions.Describe(Resting, input),
                ForceFields.Describe(Fields, input),
                Borders.Describe(Borders, input),
                CoarseCorrection.Describe(Coarse, input, WaterDepth(input.gravity)),
                Colliders.Describe(Colliders, input),
                ImplicitViscosity.Describe(Viscosity, step),
                GrainFriction.Describe(Friction, step),
                neighborSearch.Describe(step, Coarse != null && Viscosity == null && Friction == null),
                ParticleTags.Describe(ParticleTags, step),
                MaterialTable.Describe(Materials, input),
                densityConstraint.Describe(step),
                Contacts.Describe(Contacts, step),
                velocityUpdate.Describe(step),
                VelocityExtrapolation.Describe(Extrapolation, step),
                Viscoelasticity.Describe(Viscoelasticity, step),
                VorticityConfinement.Describe(Vorticity, step),
                Diffusion.Describe(Diffusion, step),
                Foam.Describe(Foam, step),
                Smoke.Describe(Smoke, step),
                Emitters.Describe(Emitters, step, ParticleTags),
                SurfaceParticles.Describe(Surface, step, Mesh != null),
                SurfaceMesh.Describe(Mesh),
                Queries.Describe(Queries, queried, ParticleTags),
                FramePacking.Describe(Packing),
                StatisticsPass.Describe(Statistics, step, statisticsInterval),
            };
        }

        /// <param name="hasSteps">False leaves out what the last step would have left.</param>
        StepContext Context(CommandBuffer cmd, in StepInput input, bool hasSteps = true)
            => new StepContext(cmd, constants, particles, neighborSearch, densityConstraint.Lists, Layout, input,
            hasSteps ? Coarse : null, hasSteps ? Resting : null, Colliders, Extrapolation, Vorticity?.Unconfined, Materials, ParticleTags);

        // Returns the context for passes that read or edit the particles as the last step left them, without an input.
        StepContext BetweenSteps(CommandBuffer cmd) => Context(cmd, default);

        // Makes the stages that a step asks for and releases those that none does. What comes, goes or changes beside water at rest wakes it.
        void UpdateStages(CommandBuffer cmd, in StepInput input)
        {
            bool hadColliders = Colliders != null, hadFields = Fields != null, hadBorders = Borders != null;
            foreach (Feature feature in Features.All)
                if (feature.FollowsSteps)
                    Update(feature, input);
            bool wakes = hadColliders && Colliders == null || hadFields && Fields == null || hadBorders && Borders == null;
            wakes |= Colliders != null && Colliders.ConsumeChanges(input.colliders);
            wakes |= Fields != null && Fields.Upload(cmd, input.sources);
            wakes |= Borders != null && Borders.ConsumeChanges(input.borders) && !isRestored;
            if (wakes)
                Wake();
        }

        /// <summary>Lets nothing sleep in the next step, where regions can.</summary>
        public void Wake() => Resting?.Wake();

        void Update(Feature feature, in StepInput input)
        {
            if (!feature.IsAsked(this, input))
            {
                Release(feature);
                return;
            }
            if (stages[feature.Index] != null && !stages[feature.Index].Fits(this, input))
                Release(feature);
            stages[feature.Index] ??= feature.Make(this, input);
        }

        T Keep<T>(Feature feature, T stage) where T : Stage
        {
            stages[feature.Index] = stage;
            return stage;
        }

        void Release(Feature feature)
        {
            stages[feature.Index]?.Dispose();
            stages[feature.Index] = null;
        }

        void ReleaseWhatEnds(ParticleChange change)
        {
            foreach (Feature feature in Features.All)
                if (stages[feature.Index] != null && !stages[feature.Index].Survives(change))
                    Release(feature);
        }

        void ReleaseStages()
        {
            foreach (Feature feature in Features.All)
                Release(feature);
        }
    }
}
