using System;
using Unity.Mathematics;

namespace Rill.Tests.Reference
{
    /// <summary>Particles that a particle of the fluid spawns, from the seed, its id and the step.</summary>
    static class FoamSpawn
    {
        /// <summary>Fraction of the fluid's speed by which foam leaves it to all sides, for each d away from its particle.</summary>
        const double Spread = 0.075;

        public static uint Hash(uint seed, uint id, uint step) => Mix(seed ^ Mix(id ^ Mix(step + 0x9E3779B9u)));

        /// <summary>0 to below 1.</summary>
        public static double Unit(uint hash) => (hash >> 8) / 16777216.0;

        /// <summary>Foam particles of a step, where so many are to be expected.</summary>
        public static int Count(double expected, uint hash) => expected > 0.0 ? (int)Math.Min(expected + Unit(hash), 255.0) : 0;

        /// <summary>The position of one of them, in a box, and its velocity.</summary>
        /// <param name="number">Of those of its particle.</param>
        public static double3 Position(double3 center, double3 flow, double step, double3 box, uint hash, int number, out double3 velocity)
        {
            uint state = hash + (uint)(number + 1) * 0x85EBCA77u;
            double z = Next() * 2.0 - 1.0, angle = Next() * 2.0 * Math.PI;
            double ring = Math.Sqrt(Math.Max(1.0 - z * z, 0.0));
            double reach = Math.Pow(Math.Max(Next(), 1e-6), 1.0 / 3.0), back = Next();
            var direction = new double3(ring * Math.Cos(angle), ring * Math.Sin(angle), z);
            velocity = flow + direction * (Spread * reach * math.length(flow));
            return math.clamp(center + direction * reach - flow * (step * back), 0.0, box);

            double Next()
            {
                state = Mix(state + 0x9E3779B9u);
                return Unit(state);
            }
        }

        static uint Mix(uint x)
        {
            x ^= x >> 16;
            x *= 0x7feb352du;
            x ^= x >> 15;
            x *= 0x846ca68bu;
            return x ^ x >> 16;
        }
    }
}
