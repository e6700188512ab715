using UnityEngine.Rendering;

namespace Rill
{
    // The stages that a fluid can do without: each is made when first needed, and null until then.
    partial class PbfSolver
    {
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

        /// <summary>Elements of the surface; null while nothing draws it.</summary>
        public SurfaceParticles Surface => (SurfaceParticles)stages[Features.SurfaceParticles.Index];

        /// <summary>The water's surface as a mesh; null while nothing draws it, or not as a mesh.</summary>
        public SurfaceMesh Mesh => (SurfaceMesh)stages[Features.SurfaceMesh.Index];

        /// <summary>Answers to probes and detectors; null while there are none.</summary>
        public Queries Queries => (Queries)stages[Features.Queries.Index];

        ImplicitViscosity Viscosity => (ImplicitViscosity)stages[Features.Viscosity.Index];
        VelocityExtrapolation Extrapolation => (VelocityExtrapolation)stages[Features.Extrapolation.Index];
        VorticityConfinement Vorticity => (VorticityConfinement)stages[Features.Vorticity.Index];
        ForceFields Fields => (ForceFields)stages[Features.ForceFields.Index];
        Emitters Emitters => (Emitters)stages[Features.Emitters.Index];
        Drains Drains => (Drains)stages[Features.Drains.Index];
        ParticleTags ParticleTags => (ParticleTags)stages[Features.Tags.Index];
        StatisticsPass Statistics => (StatisticsPass)stages[Features.Statistics.Index];
        ParticleAccess Access => (ParticleAccess)stages[Features.ParticleAccess.Index];
        ParticleEdits Edits => (ParticleEdits)stages[Features.ParticleEdits.Index];
        ParticleTransfer Transfer => (ParticleTransfer)stages[Features.Transfer.Index];
        FramePacking Packing => (FramePacking)stages[Features.Recording.Index];

        // Makes the stages that a step asks for and releases those that none does. What comes, goes or changes beside water at rest wakes it.
        void UpdateStages(CommandBuffer cmd, in StepInput input)
        {
            bool hadColliders = Colliders != null, hadFields = Fields != null;
            foreach (Feature feature in Features.All)
                if (feature.FollowsSteps)
                    Update(feature, input);
            bool wakes = hadColliders && Colliders == null || hadFields && Fields == null;
            wakes |= Colliders != null && Colliders.ConsumeChanges(input.colliders);
            wakes |= Fields != null && Fields.Upload(cmd, input.sources);
            if (wakes)
                Resting?.Wake();
        }

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
