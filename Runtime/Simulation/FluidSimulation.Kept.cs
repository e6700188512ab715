using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // Particles that stay in the world as the box moves away.
    public sealed partial class FluidSimulation
    {
        const int DefaultKeptCapacity = 50000;

        [Tooltip("Most particles that Recenter keeps outside the box where it is told to, 1 to 16,777,216. Memory is taken for all of them " +
            "then: 80 bytes each, and 8 more with phases or lifetimes.")]
        [SerializeField] int keptCapacity = DefaultKeptCapacity;

        [NonSerialized] bool saidKeptFull, saidKeptSnapshot;

        /// <summary>Most particles that <see cref="Recenter"/> keeps outside the box where it is told to, 1 to 16,777,216. Acts when it first
        /// keeps some, and after a <see cref="Restart"/>. Out-of-range values are clamped with a warning.</summary>
        public int KeptCapacity { get => keptCapacity; set { keptCapacity = value; Changed(); } }

        /// <summary>Particles that are kept outside the box, as far as the GPU has told: two or three frames ago.</summary>
        public int KeptParticleCount => pbf != null ? pbf.KeptCount : 0;

        RigidPose CornerAt(Vector3 place, Quaternion rotation) => new RigidPose(place - rotation * (domainSize * 0.5f), rotation);

        void ValidateKept(ref string problem)
            => Limit.Clamp("kept capacity", ref keptCapacity, 1, SolverLayout.MaxCapacity, ref problem);

        // After the steps of a frame.
        void ReadKept()
        {
            if (!pbf.KeepsParticles)
                return;
            if (pbf.RefusedToKeep > 0 && !saidKeptFull)
            {
                saidKeptFull = true;
                Debug.LogWarning($"Rill: FluidSimulation '{name}' {KeptFullProblem}", this);
            }
            pbf.RequestTransferred();
        }

        string KeptFullProblem => Invariant($"removed {pbf.RefusedToKeep:N0} particles that its box left behind: its kept capacity of ") +
            Invariant($"{keptCapacity:N0} is full. Raise it, or let the box move within a smaller place.");

        void SayKeptIsLeftOut()
        {
            if (!pbf.KeepsParticles || saidKeptSnapshot)
                return;
            saidKeptSnapshot = true;
            Debug.LogWarning($"Rill: FluidSimulation '{name}' takes a snapshot without the particles that are kept outside its box. Put the " +
                $"box where they are first, or fill their place after you restore it.", this);
        }
    }
}
