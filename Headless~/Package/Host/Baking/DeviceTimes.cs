using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Baking
{
    /// <summary>Has the player's device time its dispatches for as long as this lives; what it timed before is forgotten.</summary>
    sealed class DeviceTimes : IDisposable
    {
        readonly IGraphicsDevice device = Player.Device;
        readonly bool before;

        public DeviceTimes()
        {
            before = device.Timing;
            device.WaitIdle();
            device.CollectSamples();
            device.Timing = true;
        }

        /// <summary>Returns the samples that ended since the last call.</summary>
        public IEnumerable<DeviceSample> Collect() => device.CollectSamples();

        public void Dispose() => device.Timing = before;
    }
}
