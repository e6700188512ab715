using UnityEngine;

namespace Rill
{
    /// <summary>Force of water at rest at the level around a body, beside the measured one.</summary>
    struct StillWater
    {
        /// <summary>Whether it is to stand for what was measured, and is not known yet.</summary>
        public bool isPending;
        /// <summary>Pressure on the faces that other solids cover, so that no particle presses there: N, and N m about the center of mass.</summary>
        public Vector3 coveredPush, coveredMoment;
        /// <summary>Most that water can lift the body by its lower faces, N.</summary>
        public float maxLift;
        /// <summary>Pressure on its upper faces, N.</summary>
        public float load;
        /// <summary>Pressure on all of the surface, N and N m.</summary>
        public Vector3 push, moment;
        /// <summary>How far it stands for what was measured, 0 to 1.</summary>
        public float weight;
        /// <summary>Height of the water's surface upwards, m; where <see cref="weight"/> is above 0.</summary>
        public float level;
        /// <summary>Velocity of the water's surface, world space, m/s.</summary>
        public Vector3 velocity;
        /// <summary>Fraction of the body in the water: 1 where it touches and less up to half a spacing above.</summary>
        public float contact;
    }
}
