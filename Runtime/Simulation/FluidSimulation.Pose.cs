using System;
using UnityEngine;

namespace Rill
{
    // Where the box is: at this object, or where it last was while the transform is no place.
    public sealed partial class FluidSimulation
    {
        [NonSerialized] Vector3 lastPlace;
        [NonSerialized] Quaternion lastTurn = Quaternion.identity;
        [NonSerialized] bool poseIsLost, isNowhere;      // isNowhere: it could not begin

        /// <summary>Position and rotation of this object; the last finite ones while a component of them is not finite.</summary>
        internal void GetPose(out Vector3 position, out Quaternion rotation)
        {
            position = transform.position;
            rotation = transform.rotation;
            if (Limit.IsPose(position, rotation))
                return;
            position = lastPlace;
            rotation = lastTurn;
        }

        /// <summary>Keeps the place for the time when there is none, which is logged once until there is one again.</summary>
        /// <returns>Whether the box moved from where it was before, and did not come from nowhere.</returns>
        bool FollowTransform()
        {
            bool wasLost = poseIsLost;
            Vector3 position = transform.position;
            Quaternion rotation = transform.rotation;
            poseIsLost = !Limit.IsPose(position, rotation);
            if (!poseIsLost)
            {
                lastPlace = position;
                lastTurn = rotation;
            }
            else if (!wasLost)
            {
                Debug.LogError($"Rill: FluidSimulation '{name}': {LostPoseProblem}", this);
            }
            return !poseIsLost && !wasLost;
        }
    }
}
