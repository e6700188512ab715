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
        TwoLists = 1,
        Colliders = 2,
        DeepWater = 4,
        Viscosity = 8,
        Emitters = 16,
        /// <summary>Phases and lifetimes of particles.</summary>
        Tags = 32,
        Drains = 64,
        ForceFields = 128,
        Elasticity = 256,
        Vorticity = 512,
        /// <summary>What the fluid does to colliders.</summary>
        Reactions = 1024,
        Sleep = 2048,
        /// <summary>Less numerical damping than that of a first-order step.</summary>
        Extrapolation = 4096,
        /// <summary>Foam, spray and bubbles.</summary>
        Foam = 8192,
        Statistics = 16384,
        /// <summary>What has to be drawn of the water's surface, found once a frame.</summary>
        Surface = 32768,
        /// <summary>Distance fields of meshes, made on the GPU; no part of a simulation.</summary>
        Baking = 65536,
        /// <summary>Viscosity in Pa s.</summary>
        DynamicViscosity = 131072,
    }
}
