using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Reads the particles of a fluid back for files of other programs.</summary>
    static class ParticleExport
    {
        /// <summary>Requests the particles as they are now, in world space.</summary>
        /// <param name="done">Gets them two or three frames later, or null and what went wrong.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running.</exception>
        public static void Request(FluidSimulation fluid, Action<ParticleFrame, string> done)
        {
            if (fluid.Solver == null)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' is not running: enable it before you export particles.");
            fluid.GetPose(out _, out Quaternion rotation);
            DomainFrame frame = fluid.Box.Frame;
            float spacing = fluid.ParticleSpacing;
            var restDensities = new float[PhaseMaterials.Phases];
            for (int phase = 0; phase < restDensities.Length; phase++)
                restDensities[phase] = fluid.Phases.Density(phase, fluid.Material.density);
            double time = fluid.FluidTime;
            fluid.Solver.CaptureParticles().Request((contents, problem) => done(contents != null
                ? FrameOf(contents, frame, rotation, spacing, restDensities, time) : null, problem));
        }

        // Rest densities are by phase.
        static ParticleFrame FrameOf(SnapshotContents contents, in DomainFrame frame, Quaternion rotation, float spacing, float[] restDensities,
            double time)
        {
            ReadOnlySpan<float4> from = contents.Values<float4>(SnapshotSection.Positions),
                moving = contents.Values<float4>(SnapshotSection.Velocities);
            ReadOnlySpan<uint> tags = contents.Values<uint>(SnapshotSection.Tags);
            ReadOnlySpan<uint> named = contents.Values<uint>(SnapshotSection.Ids);
            int count = 0;
            foreach (float4 position in from)
                count += IsAlive(position) ? 1 : 0;
            var positions = new float3[count];
            var velocities = new float3[count];
            var densities = new float[count];
            var phases = new byte[count];
            var ids = new uint[count];
            for (int i = 0, to = 0; i < from.Length; i++)
            {
                if (!IsAlive(from[i]))
                    continue;
                positions[to] = frame.World(new RigidPose(from[i].xyz, quaternion.identity)).position;
                velocities[to] = rotation * (Vector3)(moving[i].xyz * spacing);
                phases[to] = tags.Length > 0 ? (byte)(tags[i] >> ParticleTags.PhaseShift) : (byte)0;
                densities[to] = moving[i].w * restDensities[phases[to]];
                ids[to++] = named[i];
            }
            return new ParticleFrame(positions, velocities, densities, phases, ids, time);
        }

        // A particle that a script has removed since the last step is marked by a position that is not finite. The next step leaves it out.
        static bool IsAlive(float4 position) => math.all(math.isfinite(position.xyz));
    }
}
