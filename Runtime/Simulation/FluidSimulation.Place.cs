using UnityEngine;

namespace Rill
{
    // Where the box is: at this object, or where it last was while the transform is no place.
    public sealed partial class FluidSimulation
    {
        Vector3 lastPlace;
        Quaternion lastTurn = Quaternion.identity;
        bool placeIsLost;

        /// <summary>Position and rotation of this object; the last finite ones while a component of them is not finite.</summary>
        void GetPlace(out Vector3 position, out Quaternion rotation)
        {
            position = transform.position;
            rotation = transform.rotation;
            if (Limit.IsPlace(position, rotation))
                return;
            position = lastPlace;
            rotation = lastTurn;
        }

        /// <summary>Keeps the place for the time when there is none, which is said once until there is one again.</summary>
        /// <returns>Whether the box moved from where it was before, and did not come from nowhere.</returns>
        bool FollowTransform()
        {
            bool wasLost = placeIsLost;
            Vector3 position = transform.position;
            Quaternion rotation = transform.rotation;
            placeIsLost = !Limit.IsPlace(position, rotation);
            if (!placeIsLost)
            {
                lastPlace = position;
                lastTurn = rotation;
            }
            else if (!wasLost)
            {
                Debug.LogError($"Rill: FluidSimulation '{name}': {LostPlaceProblem}", this);
            }
            return !placeIsLost && !wasLost;
        }
    }
}
