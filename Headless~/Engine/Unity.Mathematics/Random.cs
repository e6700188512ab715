using System;
using static Unity.Mathematics.math;

namespace Unity.Mathematics
{
    /// <summary>Marsaglia's xorshift32; the state is never 0.</summary>
    [Serializable]
    public struct Random
    {
        public uint state;

        public Random(uint seed)
        {
            state = seed;
            CheckState(nameof(seed));
            NextState();
        }

        /// <summary>For indices one after another, whose plain use as seeds would give alike sequences.</summary>
        public static Random CreateFromIndex(uint index)
        {
            if (index == uint.MaxValue)
                throw new ArgumentException("Index must not be uint.MaxValue", nameof(index));
            return new Random(WangHash(index + 62u));
        }

        // Thomas Wang's integer hash.
        static uint WangHash(uint n)
        {
            n = (n ^ 61u) ^ (n >> 16);
            n *= 9u;
            n ^= n >> 4;
            n *= 0x27D4EB2Du;
            return n ^ n >> 15;
        }

        public void InitState(uint seed = 0x6E624EB7u)
        {
            state = seed;
            CheckState(nameof(seed));
            NextState();
        }

        void CheckState(string what)
        {
            if (state == 0)
                throw new ArgumentException("Seed must be non-zero", what);
        }

        uint NextState()
        {
            if (state == 0)
                throw new ArgumentException("Invalid state 0. Random object has not been properly initialized");
            uint t = state;
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            return t;
        }

        public bool NextBool() => (NextState() & 1) == 1;
        public bool2 NextBool2() => new bool2(NextBool(), NextBool());
        public bool3 NextBool3() => new bool3(NextBool(), NextBool(), NextBool());
        public bool4 NextBool4() => new bool4(NextBool(), NextBool(), NextBool(), NextBool());

        public int NextInt() => (int)NextState() ^ int.MinValue;
        public int NextInt(int max) => max >= 0 ? (int)(NextState() * (ulong)max >> 32) : throw new ArgumentException("max must be positive");
        public int NextInt(int min, int max) => min <= max ? (int)(uint)(NextState() * (ulong)((long)max - min) >> 32) + min
            : throw new ArgumentException("min must be less than or equal to max");
        public uint NextUInt() => NextState() - 1;
        public uint NextUInt(uint max) => (uint)(NextState() * (ulong)max >> 32);
        public uint NextUInt(uint min, uint max) => min <= max ? (uint)(NextState() * (ulong)(max - min) >> 32) + min
            : throw new ArgumentException("min must be less than or equal to max");

        public int2 NextInt2() => new int2(NextInt(), NextInt());
        public int3 NextInt3() => new int3(NextInt(), NextInt(), NextInt());
        public int4 NextInt4() => new int4(NextInt(), NextInt(), NextInt(), NextInt());
        public int2 NextInt2(int2 min, int2 max) => new int2(NextInt(min.x, max.x), NextInt(min.y, max.y));
        public int3 NextInt3(int3 min, int3 max) => new int3(NextInt(min.x, max.x), NextInt(min.y, max.y), NextInt(min.z, max.z));
        public uint2 NextUInt2() => new uint2(NextUInt(), NextUInt());
        public uint3 NextUInt3() => new uint3(NextUInt(), NextUInt(), NextUInt());
        public uint4 NextUInt4() => new uint4(NextUInt(), NextUInt(), NextUInt(), NextUInt());

        /// <summary>[0, 1)</summary>
        public float NextFloat() => asfloat(0x3F800000 | NextState() >> 9) - 1;
        public float NextFloat(float max) => NextFloat() * max;
        public float NextFloat(float min, float max) => NextFloat() * (max - min) + min;
        public float2 NextFloat2() => new float2(NextFloat(), NextFloat());
        public float3 NextFloat3() => new float3(NextFloat(), NextFloat(), NextFloat());
        public float4 NextFloat4() => new float4(NextFloat(), NextFloat(), NextFloat(), NextFloat());
        public float2 NextFloat2(float2 max) => NextFloat2() * max;
        public float3 NextFloat3(float3 max) => NextFloat3() * max;
        public float4 NextFloat4(float4 max) => NextFloat4() * max;
        public float2 NextFloat2(float2 min, float2 max) => NextFloat2() * (max - min) + min;
        public float3 NextFloat3(float3 min, float3 max) => NextFloat3() * (max - min) + min;
        public float4 NextFloat4(float4 min, float4 max) => NextFloat4() * (max - min) + min;

        public double NextDouble()
        {
            ulong bits = (ulong)NextState() << 20 ^ NextState();
            return BitConverter.Int64BitsToDouble((long)(0x3FF0000000000000 | bits)) - 1;
        }

        public double NextDouble(double max) => NextDouble() * max;
        public double NextDouble(double min, double max) => NextDouble() * (max - min) + min;

        public float2 NextFloat2Direction()
        {
            sincos(NextFloat() * PI * 2, out float s, out float c);
            return new float2(c, s);
        }

        public float3 NextFloat3Direction()
        {
            float2 u = NextFloat2();
            float z = u.x * 2 - 1, r = sqrt(max(1 - z * z, 0));
            sincos(u.y * PI * 2, out float s, out float c);
            return new float3(c * r, s * r, z);
        }

        public quaternion NextQuaternionRotation()
        {
            float3 u = NextFloat3(new float3(2 * PI, 2 * PI, 1));
            float i = sqrt(1 - u.z), j = sqrt(u.z);
            return new quaternion(i * sin(u.x), i * cos(u.x), j * sin(u.y), j * cos(u.y));
        }
    }
}
