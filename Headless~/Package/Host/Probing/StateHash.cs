using System;
using System.Security.Cryptography;
using Rill;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Probing
{
    /// <summary>One number for the state of all particles of a scene: equal runs have equal hashes.</summary>
    static class StateHash
    {
        /// <summary>SHA-256 over counts, ids, positions and velocities of every simulation; scratch buffers are left out. Null when none
        /// runs.</summary>
        public static string OfScene()
        {
            FluidSimulation[] running = Array.FindAll(Object.FindObjectsOfType<FluidSimulation>(), simulation => simulation.IsRunning);
            if (running.Length == 0)
                return null;
            using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
            foreach (FluidSimulation simulation in running)
                Append(hash, simulation.Solver);
            return Convert.ToHexString(hash.GetHashAndReset()).ToLowerInvariant();
        }

        static void Append(IncrementalHash hash, PbfSolver solver)
        {
            byte[] counters = Bytes(solver.Counters, solver.Counters.count);
            hash.AppendData(counters);
            int alive = (int)BitConverter.ToUInt32(counters, sizeof(uint) * (int)ParticleCounter.Alive);
            if (alive == 0)
                return;
            hash.AppendData(Bytes(solver.ParticleIds, alive));
            hash.AppendData(Bytes(solver.Positions, alive));
            hash.AppendData(Bytes(solver.Velocities, alive));
        }

        static byte[] Bytes(GraphicsBuffer buffer, int elements)
        {
            var bytes = new byte[elements * buffer.stride];
            buffer.GetData(bytes, 0, 0, bytes.Length);
            return bytes;
        }
    }
}
