using System;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>A script of the default order that moves its object after all animation.</summary>
    sealed class LateMover : MonoBehaviour
    {
        [field: NonSerialized] public int Frames { get; private set; }

        [field: NonSerialized] public Vector3 Position { get; private set; }

        void LateUpdate()
        {
            Frames++;
            Position = new Vector3(0.5f * Mathf.Sin(Frames), 0.1f, 0f);
            transform.position = Position;
        }
    }
}
