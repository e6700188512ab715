using System;
using System.IO;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// The state of a fluid between two steps: all that its next step depends on. A fluid that is restored from it goes on bit for bit as
    /// one that never stopped. Taken by <see cref="FluidSimulation.RequestSnapshot"/>; does not change.
    /// </summary>
    /// <remarks>
    /// Bodies that the fluid carries are part of it. The scene's other objects are not: transforms, settings and what scripts know are for the
    /// game to keep. Foam is not either.
    /// </remarks>
    public sealed class FluidSnapshot
    {
        /// <summary>Version of the bytes that <see cref="ToBytes"/> writes, and the newest that <see cref="FromBytes"/> reads.</summary>
        public const int CurrentVersion = 5;

        internal FluidSnapshot(SnapshotContents contents)
        {
            Contents = contents;
            SolverRecord solver = contents.Get<SolverRecord>(SnapshotSection.Solver);
            TimeRecord time = contents.Get<TimeRecord>(SnapshotSection.Time);
            ParticleCount = (int)solver.particles;
            ParticleSpacing = solver.spacing;
            DomainSize = solver.domainSize * solver.spacing;
            StepCount = time.stepCount;
            FluidTime = time.fluidTime;
        }

        /// <summary>Particles in it.</summary>
        public int ParticleCount { get; }

        /// <summary>Particle spacing of its fluid, m: that of the fluid it is restored into has to be the same.</summary>
        public float ParticleSpacing { get; }

        /// <summary>Inner size of its fluid's box, m: that of the fluid it is restored into has to be the same.</summary>
        public Vector3 DomainSize { get; }

        /// <summary>Fixed steps that the fluid had taken.</summary>
        public int StepCount { get; }

        /// <summary>Fluid time, s.</summary>
        public double FluidTime { get; }

        internal SnapshotContents Contents { get; }

        /// <summary>All of it in an array, for a file: versioned, little endian, with a checksum. The same snapshot gives the same bytes.</summary>
        /// <exception cref="InvalidOperationException">It is larger than an array can be, 2 GB.</exception>
        public byte[] ToBytes() => SnapshotFormat.Write(Contents);

        /// <summary>A snapshot from what <see cref="ToBytes"/> wrote. Bytes from anywhere are safe to give: anything that is not a snapshot is
        /// refused before memory is taken for it.</summary>
        /// <param name="bytes">All of them.</param>
        /// <exception cref="ArgumentNullException">There are none.</exception>
        /// <exception cref="InvalidDataException">They are not a snapshot, incomplete, damaged or of a newer version; the message says which,
        /// and what to do.</exception>
        public static FluidSnapshot FromBytes(byte[] bytes)
        {
            if (bytes == null)
                throw new ArgumentNullException(nameof(bytes));
            SnapshotContents contents = SnapshotFormat.Read(bytes);
            SnapshotCheck.Check(contents);
            return new FluidSnapshot(contents);
        }
    }
}
