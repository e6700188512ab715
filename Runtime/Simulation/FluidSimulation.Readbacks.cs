using UnityEngine;

namespace Rill
{
    // What the graphics device gave an error for instead of the data: each kind is logged once.
    public sealed partial class FluidSimulation
    {
        void CheckReadbacks()
        {
            LogLost();
            pbf?.RequestLost();
        }

        void LogLost()
        {
            if (pbf == null)
                return;
            for (ReadbackKinds fresh = pbf.ReadbackErrors.TakeNew(); ReadbackErrors.TryTake(ref fresh, out ReadbackKinds kind);)
                Debug.LogError($"Rill: FluidSimulation '{name}' {ReadbackErrors.Problem(kind)}", this);
        }
    }
}
