using UnityEngine;

namespace Rill.Samples
{
    /// <summary>Turns its object evenly, as a motor would: whatever the water does to it.</summary>
    public sealed class Turning : MonoBehaviour
    {
        [Tooltip("Axis in the object's own frame.")]
        [SerializeField] Vector3 axis = Vector3.forward;

        [Tooltip("Turns clockwise, seen along the axis from its start, degrees a second. -720 to 720.")]
        [Range(-720f, 720f)]
        [SerializeField] float speed = 60f;

        void Update() => transform.Rotate(axis, -speed * Time.deltaTime, Space.Self);
    }
}
