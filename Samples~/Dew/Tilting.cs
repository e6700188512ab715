using System;
using UnityEngine;

namespace Rill.Samples
{
    /// <summary>Tilts its object once and softly, as a leaf that bends.</summary>
    public sealed class Tilting : MonoBehaviour
    {
        [Tooltip("Turn about the object's own z axis, degrees. -90 to 90.")]
        [Range(-90f, 90f)]
        [SerializeField] float angle = -20f;

        [Tooltip("Time before it, s. 0 or more.")]
        [Min(0f)]
        [SerializeField] float delay = 1f;

        [Tooltip("How long it takes, s. 0.01 or more.")]
        [Min(0.01f)]
        [SerializeField] float duration = 2f;

        [NonSerialized] float time;
        [NonSerialized] Quaternion start;

        void Start() => start = transform.localRotation;

        void Update()
        {
            time += Time.deltaTime;
            float part = Mathf.SmoothStep(0f, 1f, (time - delay) / duration);
            transform.localRotation = start * Quaternion.AngleAxis(angle * part, Vector3.forward);
        }
    }
}
