using System;

namespace Rill
{
    /// <summary>What a scene may ask of the solver and a device may be too small for; a bit each, the most important first.</summary>
    [Flags]
    enum DeviceFeature
    {
        /// <summary>Fluid in its box: without it there is nothing.</summary>
        None = 0,
        /// <summary>Neighbor lists in two buffers, because one cannot hold the capacity: part of the fluid, where it is so large.</summary>
        TwoLists = 1 << 0,
        Colliders = 1 << 1,
        DeepWater = 1 << 2,
        Viscosity = 1 << 3,
        Emitters = 1 << 4,
        /// <summary>Phases and lifetimes of particles.</summary>
        Tags = 1 << 5,
        Drains = 1 << 6,
        ForceFields = 1 << 7,
        /// <summary>Viscosity in Pa s.</summary>
        DynamicViscosity = 1 << 8,
        Elasticity = 1 << 9,
        Vorticity = 1 << 10,
        /// <summary>What the fluid does to colliders.</summary>
        Reactions = 1 << 11,
        Sleep = 1 << 12,
        /// <summary>Less numerical damping than that of a first-order step.</summary>
        Extrapolation = 1 << 13,
        /// <summary>Foam, spray and bubbles.</summary>
        Foam = 1 << 14,
        Statistics = 1 << 15,
        /// <summary>What has to be drawn of the water's surface, found once a frame.</summary>
        Surface = 1 << 16,
        /// <summary>Probes and detectors.</summary>
        Queries = 1 << 17,
        /// <summary>Passes of scripts before a step. The last that a scene can ask for.</summary>
        ParticleAccess = 1 << 18,
        /// <summary>Distance fields of meshes, made on the GPU; no part of a simulation.</summary>
        Baking = 1 << 19,
    }
}
