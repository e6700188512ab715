using System;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Looks at each frame after the fluid has stepped.</summary>
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 1)]
    sealed class LateWitness : MonoBehaviour
    {
        public Action Look { get; set; }

        void LateUpdate() => Look?.Invoke();
    }
}
