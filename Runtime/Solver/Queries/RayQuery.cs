using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>A ray, or a ball that is cast along one, at the end of a step; lengths in d, in the domain's frame.</summary>
    [GenerateHlsl("Queries")]
    [StructLayout(LayoutKind.Sequential)]
    struct RayQuery
    {
        /// <summary>d</summary>
        public float3 origin;
        /// <summary>d, from the origin</summary>
        public float maxDistance;
        /// <summary>length 1</summary>
        public float3 direction;
        /// <summary>of the ball, d; 0 for a ray</summary>
        public float radius;
        /// <summary>of <see cref="FluidCrossing"/></summary>
        public uint crossings;
        /// <summary>that stand for the ball; 1 for a ray</summary>
        public uint lines;
        public float2 unused;

        /// <summary>the number of a line is below this bit, that of its ray from there on</summary>
        [GenerateHlsl("Queries")] public const int LineShift = 7;

        /// <summary>words of a ray's result</summary>
        [GenerateHlsl("Queries")] public const int RayWords = 12;

        /// <summary>Largest ball, d: a ball may touch what lies between its lines up to 0.2 d late.</summary>
        public const float MaxRadius = 20f;

        const int MinLines = 12, MaxLines = 1 << LineShift;

        /// <summary>Lines that stand for a ball of a radius, d: half a sphere of it in so many parts is flat within 0.1 d in each, up to
        /// 10 d.</summary>
        public static int LinesFor(float radius) => radius > 0f ? math.clamp((int)math.ceil(12f * radius), MinLines, MaxLines) : 1;
    }

    /// <summary>Words of a ray's result; floats by their bits.</summary>
    [GenerateHlsl("Queries", Prefix = "Ray")]
    enum RayWord
    {
        /// <summary>d</summary>
        Distance,
        /// <summary>and 2, 3: where the water was hit, d</summary>
        Point,
        /// <summary>and 5, 6: out of the water, length 1</summary>
        Normal = Point + 3,
        /// <summary>and 8, 9: d/s</summary>
        Velocity = Normal + 3,
        Phase = Velocity + 3,
        /// <summary>of <see cref="RayFlag"/></summary>
        Flags,
    }

    /// <summary>Flags of a ray's result.</summary>
    [Flags, GenerateHlsl("Queries", Prefix = "Ray")]
    enum RayFlag
    {
        Hit = 1,
        StartsInWater = 2,
        /// <summary>the hit is not at a wall, which has a normal of its own</summary>
        AtSurface = 4,
    }
}
