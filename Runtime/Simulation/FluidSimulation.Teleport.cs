using System;
using UnityEngine;

namespace Rill
{
    // A box that is put elsewhere and takes all that it holds along, as where a floating origin shifts the scene.
    public sealed partial class FluidSimulation
    {
        DomainFrame collectedFrame;                     // where the box was in the last steps
        [NonSerialized] bool isTeleported;              // since the last steps

        /// <summary>Sum of the displacements of all teleports, m: a position that was measured before one is now this much further on.</summary>
        [field: NonSerialized] internal Vector3 WorldShift { get; private set; }

        /// <summary>
        /// Call after putting this object elsewhere: neither the box nor its water has moved through the world between. The water goes on as it
        /// is, in the box, and so do colliders, emitters, drains and floating bodies that went along. Those that stayed where they were in the
        /// world have not moved through the water either. For a fluid that is put elsewhere, and for a floating origin, which shifts the whole
        /// scene: shift it, then call this of each fluid, in the same frame.
        /// </summary>
        /// <remarks>
        /// Positions that were measured before are given where they are now: those of probes, detectors, points and rays, and what carries
        /// floating bodies. Particles kept outside the box go along too. What a moving box pushes is in the manual under <c>Inertial</c>;
        /// <see cref="Recenter"/> moves the box and leaves the water.
        /// </remarks>
        public void Teleport()
        {
            RigidPose before = LastCorner;
            if (!FollowTransform())
                return;         // nowhere, or from nowhere, which is no way
            WorldShift += (Vector3)(LastCorner.position - before.position);
            positionIsKnown = false;
            isTeleported = true;
            pbf?.TeleportKept(before, LastCorner);
        }

        /// <summary>Whether what was at one pose in the box after the last steps, and is at another now, went along with the box: always, unless
        /// the box was teleported and it stayed where it was in the world.</summary>
        internal bool WentAlong(in RigidPose last, in RigidPose now)
        {
            if (!isTeleported)
                return true;
            RigidPose world = collectedFrame.World(last);
            RigidPose stayed = Frame.Pose(world.position, world.rotation);
            float reach = 0.5f * ((Vector3)pbf.Layout.DomainSize).magnitude;
            return RigidPose.Distance(now, last, reach) <= RigidPose.Distance(now, stayed, reach);
        }

        /// <summary>A pose in world space, m, that went along with the box, after the last steps: where it is now.</summary>
        internal RigidPose Teleported(in RigidPose world)
            => isTeleported ? Frame.World(collectedFrame.Pose(world.position, world.rotation)) : world;

        RigidPose LastCorner => CornerAt(lastPlace, lastTurn);
    }
}
