using System;

namespace Rill
{
    /// <summary>All features of a fluid, a row each.</summary>
    /// <remarks>To add one: its class, its shader, its setting, and a row here, in <see cref="All"/> too. What a step does, and in which order,
    /// stands in <see cref="PbfSolver.Step"/>.</remarks>
    static class Features
    {
        public static readonly Feature Core = new Feature("the fluid itself",
            stages: new[] { "ParticleUpload", "NeighborSearch", "PrefixSum", "DensityConstraint", "VelocityUpdate", "Clear" });

        /// <summary>Neighbor lists in two buffers, because one cannot hold the capacity: part of the fluid, where it is so large.</summary>
        public static readonly Feature TwoLists = new Feature("neighbor lists in two buffers", defines: new[] { "RILL_TWO_LISTS" });

        public static readonly Feature Colliders = new Feature("colliders", "disable the colliders in its box",
            stages: new[] { "Colliders" },
            kernels: new[] { "Colliders", "CoarseColliders" },
            defines: new[] { "CARRIES", "RILL_DEFORMING", "WITH_COLLIDERS" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Colliders.IsNeeded(step),
            turnOff: (ref StepInput step) => step.colliders = null,
            make: (PbfSolver solver, in StepInput step) => new Rill.Colliders(solver.Layout, solver.ReadbackErrors));

        // A collider can reach into deep water at any time, and brings only the stage that does not depend on the depth.
        public static readonly Feature DeepWater = new Feature("deep water", "set Deep Water to Off and keep the water shallow",
            stages: new[] { "CoarseGrid", "CoarseSolver", "CoarseColliders" },
            defines: new[] { "DEEP" },
            asked: (PbfSolver solver, in StepInput step) => solver.IsDeep(step),
            turnOff: (ref StepInput step) => step.settings.deepWater = Rill.DeepWater.Off,
            make: (PbfSolver solver, in StepInput step) => new CoarseCorrection(solver.Layout, solver.CoarseCellSize(step), solver.Limits,
                MaterialTable.IsNeeded(step)));

        public static readonly Feature VelocitySmoothing = new Feature("velocity smoothing", "set the velocity smoothing to 0",
            defines: new[] { "VISCOUS" },
            asked: (PbfSolver solver, in StepInput step) => step.material.velocitySmoothing > 0f || step.needsDensity,
            turnOff: (ref StepInput step) => (step.material.velocitySmoothing, step.needsDensity) = (0f, false));

        public static readonly Feature Emitters = new Feature("emitters", "disable its emitters",
            stages: new[] { "Emitters" },
            defines: new[] { "RILL_RECYCLING" },
            asked: (PbfSolver solver, in StepInput step) => step.sources != null && step.sources.keepsEmitters,
            turnOff: (ref StepInput step) => step.sources?.LeaveOutEmitters());

        public static readonly Feature Tags = new Feature("phases and lifetimes of emitted particles", "set phase and lifetime of its emitters to 0",
            defines: new[] { "RILL_LIFETIMES", "RILL_TAGS" },
            asked: (PbfSolver solver, in StepInput step) => step.HasPhases || step.sources != null && step.sources.needsTags,
            turnOff: (ref StepInput step) =>
            {
                step.tracksPhases = false;
                step.phases = default;
                step.sources?.LeaveOutTags();
            });

        public static readonly Feature Materials = new Feature("several materials", "give its phases one material",
            defines: new[] { MaterialTable.Keyword },
            asked: (PbfSolver solver, in StepInput step) => MaterialTable.IsNeeded(step),
            turnOff: (ref StepInput step) => step.phases = default,
            make: (PbfSolver solver, in StepInput step) => new MaterialTable(solver.Layout.Capacity),
            ofSettings: true);

        // They replace the density constraint, and all that acts through it.
        public static readonly Feature Contacts = new Feature("contacts of loose balls", "set Contacts to off",
            stages: new[] { "Contacts" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Contacts.IsNeeded(step),
            turnOff: (ref StepInput step) => step.material.contacts = false,
            make: (PbfSolver solver, in StepInput step) => new Rill.Contacts(solver.Layout.Capacity),
            ofSettings: true);

        public static readonly Feature Diffusion = new Feature("diffusion of materials", "set the diffusion of its material pairs to 0",
            stages: new[] { "Diffusion" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Diffusion.IsNeeded(step),
            turnOff: (ref StepInput step) => step.phases = step.phases.WithoutDiffusion(),
            make: (PbfSolver solver, in StepInput step) => new Rill.Diffusion(solver.Layout.Capacity),
            ofSettings: true);

        public static readonly Feature Drains = new Feature("drains and lifetimes", "disable its drains and set the lifetime of its emitters to 0",
            stages: new[] { "Drains" },
            defines: new[] { "RILL_RECYCLING" },
            asked: (PbfSolver solver, in StepInput step) => step.sources != null && (step.sources.keepsDrains || step.sources.needsLifetimes),
            turnOff: (ref StepInput step) => step.sources?.LeaveOutDrains());

        public static readonly Feature ForceFields = new Feature("force fields", "disable its force fields",
            stages: new[] { "ForceFields" },
            asked: (PbfSolver solver, in StepInput step) => Rill.ForceFields.IsNeeded(step.sources),
            turnOff: (ref StepInput step) => step.sources?.LeaveOutFields(),
            make: (PbfSolver solver, in StepInput step) => new Rill.ForceFields());

        // An open side holds its level by what emitters and drains do.
        public static readonly Feature Borders = new Feature("absorbing and open borders", "make its borders walls",
            stages: new[] { "Borders" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Borders.IsNeeded(step),
            turnOff: (ref StepInput step) => step.borders = default,
            make: (PbfSolver solver, in StepInput step) => new Rill.Borders(),
            ofSettings: true);

        public static readonly Feature Viscosity = new Feature("dynamic viscosity", "set the dynamic viscosity to 0",
            stages: new[] { "ImplicitViscosity" },
            asked: (PbfSolver solver, in StepInput step) => ImplicitViscosity.IsNeeded(step),
            turnOff: (ref StepInput step) => (step.material.dynamicViscosity, step.phases) = (0f, step.phases.WithoutViscosity()),
            make: (PbfSolver solver, in StepInput step) => new ImplicitViscosity(solver.Layout.Capacity),
            ofSettings: true);

        public static readonly Feature GrainFriction = new Feature("friction of grains", "set the friction angle and the cohesion to 0",
            stages: new[] { "GrainFriction" },
            asked: (PbfSolver solver, in StepInput step) => Rill.GrainFriction.IsNeeded(step),
            turnOff: (ref StepInput step) => step.LeaveOutGrains(),
            make: (PbfSolver solver, in StepInput step) => new Rill.GrainFriction(solver.Layout),
            ofSettings: true);

        public static readonly Feature Elasticity = new Feature("elasticity", "set the shear modulus to 0",
            stages: new[] { "Viscoelasticity" },
            asked: (PbfSolver solver, in StepInput step) => Viscoelasticity.IsNeeded(step),
            turnOff: (ref StepInput step) => step.material.shearModulus = 0f,
            make: (PbfSolver solver, in StepInput step) => new Viscoelasticity(solver.Layout.Capacity),
            ofSettings: true);

        public static readonly Feature Vorticity = new Feature("vorticity confinement", "set vorticity to 0",
            stages: new[] { "VorticityConfinement" },
            asked: (PbfSolver solver, in StepInput step) => VorticityConfinement.IsNeeded(step),
            turnOff: (ref StepInput step) => step.material.vorticity = 0f,
            make: (PbfSolver solver, in StepInput step) => new VorticityConfinement(solver.Layout.Capacity),
            ofSettings: true);

        public static readonly Feature Reactions = new Feature("forces on colliders", "let no collider measure its force",
            defines: new[] { "REACT", "TAKE", "WETTED" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Colliders.IsNeeded(step) && step.colliders.Reacts,
            turnOff: (ref StepInput step) => step.colliders?.LeaveOutReactions());

        public static readonly Feature Sleep = new Feature("sleep", "set the sleep speed to 0",
            stages: new[] { "RestingRegions" },
            defines: new[] { "RILL_SLEEP" },
            asked: (PbfSolver solver, in StepInput step) => RestingRegions.IsNeeded(step),
            turnOff: (ref StepInput step) => step.settings.sleepSpeed = 0f,
            make: (PbfSolver solver, in StepInput step) => new RestingRegions(solver.Layout),
            ofSettings: true);

        public static readonly Feature Extrapolation = new Feature("less numerical damping", "set the numerical damping to 1",
            defines: new[] { "EXTRAPOLATE" },
            asked: (PbfSolver solver, in StepInput step) => VelocityExtrapolation.IsNeeded(step),
            turnOff: (ref StepInput step) => step.settings.numericalDamping = 1f,
            make: (PbfSolver solver, in StepInput step) => new VelocityExtrapolation(solver.Layout.Capacity));

        public static readonly Feature Foam = new Feature("foam", "disable its FluidFoam",
            stages: new[] { "Foam", "FoamSources" },
            defines: new[] { "ADD_FOAM", "WITH_FOAM" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Foam.IsNeeded(step),
            turnOff: (ref StepInput step) => step.foam.budget = 0,
            make: (PbfSolver solver, in StepInput step) => new Rill.Foam(solver.Layout, step.foam.budget, solver.ReadbackErrors));

        // Its grid is made of deep water's parts.
        public static readonly Feature Smoke = new Feature("smoke", "disable its FluidSmoke",
            stages: new[] { "Smoke" },
            asked: (PbfSolver solver, in StepInput step) => Rill.Smoke.IsNeeded(step),
            turnOff: (ref StepInput step) => step.hasSmoke = false,
            make: (PbfSolver solver, in StepInput step) => new Rill.Smoke(solver.Layout, Rill.Smoke.WantedSize(step, solver.Layout.Spacing),
                solver.Limits));

        public static readonly Feature Statistics = new Feature("statistics", "set the statistics interval to 0", stages: new[] { "Statistics" });

        // A device that does not hold a part of the surface does not get any.
        public static readonly Feature SurfaceParticles = new Feature("the water's surface", "draw it with a ParticleRenderer",
            stages: new[] { "SurfaceParticles" },
            kernels: new[] { "SurfaceParticles", "SurfaceMesh", "RenderedMesh", "Caustics", "WaterPhases", "WaterRays", "WaterSpray",
                "WaterShadow" });

        public static readonly Feature Queries = new Feature("probes and detectors", "disable its probes and detectors",
            stages: new[] { "Queries" });

        public static readonly Feature ParticleAccess = new Feature("passes of scripts, and what they remove and read back",
            "let no script listen to BeforeStep", stages: new[] { "ParticleAccess" });

        public static readonly Feature ParticleEdits = new Feature("Fill, RemoveInside and Recenter", "fill it by Fluid Volumes",
            stages: new[] { "ParticleEdits" });

        public static readonly Feature Transfer = new Feature("connections, and what is kept outside the box",
            "disable its connections", stages: new[] { "ParticleTransfer" });

        public static readonly Feature Recording = new Feature("recording and playback", "record and play on another device",
            stages: new[] { "Recording" });

        public static readonly Feature SurfaceMesh = new Feature("the water's surface", stages: new[] { "SurfaceMesh" }, kernels: NoKernels);

        /// <summary>Draws that mesh as water.</summary>
        public static readonly Feature Surface = new Feature("the water's surface", kernels: NoKernels,
            stages: new[] { "Water", "WaterInside", "WaterDrops", "WaterRays", "WaterShadow", "WaterSpray", "SurfaceMotion", "ShadowCopy" });

        /// <summary>Hands that mesh to renderers.</summary>
        public static readonly Feature RenderedMesh = new Feature("the water's surface", stages: new[] { "RenderedMesh" }, kernels: NoKernels);

        public static readonly Feature Wetness = new Feature("wet surfaces", "disable its FluidWetness", stages: new[] { "Wetness" });

        public static readonly Feature ParticleRenderer = new Feature("the drawing of particles",
            stages: new[] { "ParticleRenderer" }, kernels: NoKernels);

        public static readonly Feature DomainRenderer = new Feature("the drawing of its box",
            stages: new[] { "DomainRenderer" }, kernels: NoKernels);

        /// <summary>Distance fields of meshes, made on the GPU; no part of a simulation.</summary>
        public static readonly Feature Baking = new Feature("distance fields of meshes", stages: new[] { StageShader.OfBaking });

        /// <summary>The most important first: where a device does not hold two of them together, the first stays.</summary>
        public static readonly Feature[] All = Numbered(Core, TwoLists, Colliders, DeepWater, VelocitySmoothing, Emitters, Tags, Materials,
            Contacts, Drains, ForceFields, Borders, Viscosity, GrainFriction, Elasticity, Vorticity, Reactions, Sleep, Extrapolation, Diffusion, Foam,
            Smoke, Statistics, SurfaceParticles, Queries, ParticleAccess, ParticleEdits, Transfer, Recording, SurfaceMesh, Surface, RenderedMesh,
            Wetness, ParticleRenderer, DomainRenderer, Baking);

        /// <summary>Those that the settings of a fluid alone ask for.</summary>
        public static readonly Feature[] OfSettings = Array.FindAll(All, feature => feature.OfSettings);

        /// <summary>All that a script can switch on or add to a fluid.</summary>
        public static FeatureSet OfFluids => SetOf(All).Without(Baking);

        static string[] NoKernels => Array.Empty<string>();

        /// <summary>Returns the features that a scene must have for a kernel's variant to run in it.</summary>
        /// <param name="need">Row of the table of what kernels need.</param>
        /// <exception cref="ArgumentException">No feature has its shader.</exception>
        public static FeatureSet Of(in KernelNeed need)
        {
            FeatureSet features = FeatureSet.None;
            bool isKnown = false;
            foreach (Feature feature in All)
            {
                bool hasFile = Contains(feature.Kernels, need.File);
                isKnown |= hasFile;
                features = features.With(feature, hasFile || ContainsAny(feature.Defines, need.Defines));
            }
            if (!isKnown)
                throw new ArgumentException($"{need.File}.compute belongs to no feature. Add it to the kernels of a row of Features.");
            return features;
        }

        static FeatureSet SetOf(Feature[] features)
        {
            FeatureSet set = FeatureSet.None;
            foreach (Feature feature in features)
                set |= feature;
            return set;
        }

        static bool Contains(string[] words, string word) => Array.IndexOf(words, word) >= 0;

        static bool ContainsAny(string[] words, string text)
        {
            if (words.Length == 0 || text.Length == 0)
                return false;
            foreach (string word in text.Split(' '))
                if (Contains(words, word))
                    return true;
            return false;
        }

        static Feature[] Numbered(params Feature[] all)
        {
            for (int i = 0; i < all.Length; i++)
                all[i].Index = i;
            return all;
        }
    }
}
