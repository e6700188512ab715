using System;
using System.Collections.Generic;

namespace Rill
{
    /// <summary>The table of what each program of the package takes of a device, and which of its rows a scene needs.</summary>
    static partial class KernelNeeds
    {
        /// <summary>A row for each variant of each kernel; of a kernel the one without keywords first.</summary>
        public static IReadOnlyList<KernelNeed> OfKernels => Kernels;

        /// <summary>A row for each stage of each draw shader.</summary>
        public static IReadOnlyList<KernelNeed> OfDraws => Draws;

        /// <summary>What a scene has to have for a kernel's variant to run in it.</summary>
        /// <exception cref="ArgumentException">The table has a file or define that this does not know.</exception>
        public static DeviceFeature FeaturesOf(in KernelNeed need)
        {
            DeviceFeature features = OfFile(need.File);
            foreach (string word in need.Defines.Split(' '))
                features |= OfDefine(word, need);
            return features;
        }

        static DeviceFeature OfFile(string file)
        {
            switch (file)
            {
                case "Clear":
                case "DensityConstraint":
                case "ParticleUpload":
                case "NeighborSearch":
                case "PrefixSum":
                case "VelocityUpdate": return DeviceFeature.None;
                case "CoarseGrid":
                case "CoarseSolver": return DeviceFeature.DeepWater;
                case "CoarseColliders": return DeviceFeature.DeepWater | DeviceFeature.Colliders;
                case "Colliders": return DeviceFeature.Colliders;
                case "Drains": return DeviceFeature.Drains;
                case "Emitters": return DeviceFeature.Emitters;
                case "Foam":
                case "FoamSources": return DeviceFeature.Foam;
                case "ForceFields": return DeviceFeature.ForceFields;
                case "MeshSdf": return DeviceFeature.Baking;
                case "ParticleAccess":
                case "ParticleEdits":
                case "ParticleTransfer":
                case "Recording": return DeviceFeature.ParticleAccess;
                case "Queries": return DeviceFeature.Queries;
                case "RestingRegions": return DeviceFeature.Sleep;
                case "Statistics": return DeviceFeature.Statistics;
                case "RenderedMesh": return DeviceFeature.Surface;
                case "Caustics":
                case "SurfaceMesh":
                case "SurfaceParticles":
                case "WaterPhases":
                case "WaterRays":
                case "WaterSpray":
                case "WaterShadow":
                case "Wetness": return DeviceFeature.Surface;
                case "ImplicitViscosity": return DeviceFeature.DynamicViscosity;
                case "Viscoelasticity": return DeviceFeature.Elasticity;
                case "VorticityConfinement": return DeviceFeature.Vorticity;
                default:
                    throw new ArgumentException(
                    $"{file}.compute is in the table of what kernels need, but KernelNeeds does not say which feature it belongs to.");
            }
        }

        static DeviceFeature OfDefine(string word, in KernelNeed need)
        {
            switch (word)
            {
                case "":
                case "ADD_DROPLETS":
                case "ADD_ELEMENTS":
                case "ADD_NEW":
                case "APPLY":
                case "ARTIFICIAL_PRESSURE":
                case "AT_REST":
                case "AVERAGE":
                case "BEGIN":
                case "BINS":
                case "CHORDS":
                case "CLEAR_SUMS":
                case "COEFFICIENTS":
                case "COMPACT":
                case "CONFINE":
                case "COPY_INDICES":
                case "COPY_VERTICES":
                case "CORRECT":
                case "COUNT":
                case "COUNT_CELLS":
                case "ELEMENTS":
                case "EMIT":
                case "ESTIMATE":
                case "FACES":
                case "FEW":
                case "FIELDS":
                case "FIND":
                case "FIND_CONTACTS":
                case "FIND_FIELD":
                case "FINISH_MESH":
                case "FIRST":
                case "FLOW":
                case "HIDE_GHOSTS":
                case "LAST":
                case "LEAVE":
                case "LIST_DROPS":
                case "MAKE":
                case "MAKE_ELEMENTS":
                case "MAKE_QUADS":
                case "MAKE_VERTICES":
                case "MARK":
                case "MARK_BRICKS":
                case "MARK_CONTACTS":
                case "MESH":
                case "MOVE":
                case "NARROW":
                case "PASS":
                case "PATHS":
                case "PLACE_BRICKS":
                case "PROJECTION":
                case "REDUCE":
                case "REMOVE":
                case "RESIDUAL":
                case "RILL_BUILD_LIST":
                case "RILL_PHASES":
                case "ROOM":
                case "SHAPE":
                case "SHIFT":
                case "SMALL":
                case "SMOOTH":
                case "SMOOTH_BACK":
                case "SMOOTH_MESH":
                case "SPAWN":
                case "STORE_BRICKS":
                case "STORE_COUNTS":
                case "STORE_DRAWN":
                case "STORE_DROPS":
                case "SUN":
                case "TAGGED":
                case "TRACE":
                case "UNPACK":
                case "VOLUME": return DeviceFeature.None;
                case "CARRIES":
                case "RILL_DEFORMING":
                case "WITH_COLLIDERS": return DeviceFeature.Colliders;
                case "ADD_FOAM":
                case "WITH_FOAM": return DeviceFeature.Foam;
                case "DEEP": return DeviceFeature.DeepWater;
                case "REACT":
                case "TAKE":
                case "WETTED": return DeviceFeature.Reactions;
                case "RILL_LIFETIMES":
                case "RILL_TAGS": return DeviceFeature.Tags;
                case "RILL_RECYCLING": return DeviceFeature.Drains | DeviceFeature.Emitters;
                case "EXTRAPOLATE": return DeviceFeature.Extrapolation;
                case "RILL_SLEEP": return DeviceFeature.Sleep;
                case "RILL_TWO_LISTS": return DeviceFeature.TwoLists;
                case "VISCOUS": return DeviceFeature.Viscosity;
                default:
                    throw new ArgumentException($"'{word}' of kernel '{need.Kernel}' in {need.File}.compute is in the table of " +
                    $"what kernels need, but KernelNeeds does not say which feature it belongs to.");
            }
        }
    }
}
