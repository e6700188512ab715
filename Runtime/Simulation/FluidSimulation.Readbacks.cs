using UnityEngine;

namespace Rill
{
    // What the graphics device gave an error for instead of the data: each kind is logged once.
    public sealed partial class FluidSimulation
    {
        void CheckReadbacks()
        {
            if (pbf == null || pbf.ReadbackErrors.Lost == ReadbackKinds.None && !pbf.ReadbackErrors.HasNew)
                return;
            var fresh = (uint)pbf.ReadbackErrors.TakeNew();
            for (uint kind = 1; kind <= fresh; kind <<= 1)
                if ((fresh & kind) != 0)
                    Debug.LogError($"Rill: FluidSimulation '{name}' {ReadbackErrors.Problem((ReadbackKinds)kind)}", this);
            pbf.RequestLost();
        }
    }
}
