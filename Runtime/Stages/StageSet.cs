using System;

namespace Rill
{
    /// <summary>Groups of stages that a fluid uses together, each with the stage assets that it needs.</summary>
    [Flags]
    enum StageSet
    {
        None = 0,
        /// <summary>What every fluid needs.</summary>
        Core = 1,
        DeepWater = 1 << 1,
        Viscoelasticity = 1 << 2,
        Vorticity = 1 << 3,
        Sleep = 1 << 4,
        Statistics = 1 << 5,
        Colliders = 1 << 6,
        Emitters = 1 << 7,
        Drains = 1 << 8,
        ForceFields = 1 << 9,
        ParticleRenderer = 1 << 10,
        DomainRenderer = 1 << 11,
        /// <summary>What draws the water's surface.</summary>
        Surface = 1 << 12,
        Foam = 1 << 13,
        ImplicitViscosity = 1 << 14,
        MeshBaking = 1 << 15,
        /// <summary>What passes and readbacks of scripts need.</summary>
        ParticleAccess = 1 << 16,
        /// <summary>Probes and detectors.</summary>
        Queries = 1 << 17,
        /// <summary>What scripts fill and remove between steps.</summary>
        ParticleEdits = 1 << 18,
        /// <summary>What packs frames of a recording, and shows them.</summary>
        Recording = 1 << 19,
        /// <summary>What hands particles over between fluids, and keeps them outside of a box that moves.</summary>
        Transfer = 1 << 20,
        /// <summary>What finds the water's surface as a mesh.</summary>
        SurfaceMesh = 1 << 21,
        /// <summary>What finds the pieces of that mesh.</summary>
        SurfaceParticles = 1 << 22,
        /// <summary>What hands it to renderers.</summary>
        RenderedMesh = 1 << 23,
        /// <summary>What keeps surfaces wet.</summary>
        Wetness = 1 << 24,
        /// <summary>All that a script can switch on or add to a fluid.</summary>
        OfFluids = All & ~MeshBaking,
        All = (1 << 25) - 1,
    }

    static class StageSets
    {
        /// <summary>Name of a stage asset that one group needs; null from their number on.</summary>
        /// <param name="group">A single bit.</param>
        public static string StageAt(StageSet group, int index)
        {
            switch (group)
            {
                case StageSet.Core: return CoreAt(index);
                // A collider can reach into deep water at any time, and brings only the stage that does not depend on the depth.
                case StageSet.DeepWater: return index == 0 ? "CoarseGrid" : index == 1 ? "CoarseSolver" : index == 2 ? "CoarseColliders" : null;
                case StageSet.Surface:
                    return index == 0 ? "Water" : index == 1 ? "WaterInside" : index == 2 ? "WaterDrops" : index == 3 ? "WaterRays"
                    : index == 4 ? "WaterShadow" : index == 5 ? "WaterSpray" : index == 6 ? "SurfaceMotion" : index == 7 ? "ShadowCopy" : null;
                case StageSet.Foam: return index == 0 ? "Foam" : index == 1 ? "FoamSources" : null;
                default: return index == 0 ? Only(group) : null;
            }
        }

        /// <summary>First stage of a group whose asset is not loaded; null where all are there.</summary>
        public static string FirstMissing(StageSet group)
        {
            for (int i = 0; StageAt(group, i) is string stage; i++)
                if (StageShader.Find(stage) == null)
                    return stage;
            return null;
        }

        static string CoreAt(int index)
        {
            switch (index)
            {
                case 0: return "ParticleUpload";
                case 1: return "NeighborSearch";
                case 2: return "PrefixSum";
                case 3: return "DensityConstraint";
                case 4: return "VelocityUpdate";
                case 5: return "Clear";
                default: return null;
            }
        }

        static string Only(StageSet group)
        {
            switch (group)
            {
                case StageSet.ImplicitViscosity: return "ImplicitViscosity";
                case StageSet.Viscoelasticity: return "Viscoelasticity";
                case StageSet.Vorticity: return "VorticityConfinement";
                case StageSet.Sleep: return "RestingRegions";
                case StageSet.Statistics: return "Statistics";
                case StageSet.Colliders: return "Colliders";
                case StageSet.Emitters: return "Emitters";
                case StageSet.Drains: return "Drains";
                case StageSet.ForceFields: return "ForceFields";
                case StageSet.ParticleRenderer: return "ParticleRenderer";
                case StageSet.DomainRenderer: return "DomainRenderer";
                case StageSet.MeshBaking: return "MeshSdf";
                case StageSet.ParticleAccess: return "ParticleAccess";
                case StageSet.ParticleEdits: return "ParticleEdits";
                case StageSet.Queries: return "Queries";
                case StageSet.Recording: return "Recording";
                case StageSet.Transfer: return "ParticleTransfer";
                case StageSet.SurfaceParticles: return "SurfaceParticles";
                case StageSet.SurfaceMesh: return "SurfaceMesh";
                case StageSet.RenderedMesh: return "RenderedMesh";
                case StageSet.Wetness: return "Wetness";
                default: return null;
            }
        }
    }
}
