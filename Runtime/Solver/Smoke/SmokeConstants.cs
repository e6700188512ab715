using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>Constants of a step of smoke; lengths in d.</summary>
    [GenerateHlsl("Smoke", ConstantBuffer = "RillSmoke")]
    [StructLayout(LayoutKind.Sequential)]
    struct SmokeConstants
    {
        /// <summary>d/s²</summary>
        public float3 smokeGravity;
        /// <summary>length of the step, s</summary>
        public float smokeStep;
        /// <summary>blocks of the fluid's cells along each axis, see FluidCells.hlsl</summary>
        public uint3 waterCounts;
        /// <summary>sources that act</summary>
        public uint sourceCount;
        /// <summary>the fluid's cells in such a block, along each axis</summary>
        public uint3 cellsPerWaterCell;
        /// <summary>bit 2 a + b: the lower (b 0) or upper side of the box along axis a is open</summary>
        public uint openSides;
        /// <summary>of the fresh air, K</summary>
        public float airTemperature;
        /// <summary>fraction of the heat that is left after the step</summary>
        public float heatKept;
        /// <summary>fraction of the smoke that is left after the step</summary>
        public float densityKept;
        /// <summary>vorticity confinement, 1/s</summary>
        public float smokeVorticity;
        /// <summary>of air beside water, 1/m; 0 for no steam</summary>
        public float steamDensity;
        /// <summary>of air beside water, K above the fresh air</summary>
        public float steamHeat;
        /// <summary>added to the potential, so that it is never below 0, d²</summary>
        public float potentialShift;
        /// <summary>after which the heat of a source is another</summary>
        public uint flickerSteps;
    }

    /// <summary>Air that a source heats and fills with smoke, in the domain's frame.</summary>
    [GenerateHlsl("Smoke")]
    [StructLayout(LayoutKind.Sequential)]
    struct SmokeRegion
    {
        /// <summary>d</summary>
        public float3 center;
        /// <summary>d</summary>
        public float radius;
        /// <summary>that the air gets, d/s; 0: it keeps its own</summary>
        public float3 velocity;
        /// <summary>temperature above that of the fresh air, K</summary>
        public float heat;
        /// <summary>extinction of light, 1/m</summary>
        public float density;
        public float unused0, unused1, unused2;
    }
}
