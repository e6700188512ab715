using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Work that the device was given: how often, for the test runner, and which.</summary>
    internal static class GpuWork
    {
        /// <summary>Compute dispatches handed to the device, direct and indirect.</summary>
        public static long Dispatches;

        /// <summary>While not null, gets the name of each kernel dispatched and each pass drawn with.</summary>
        public static List<string> Log;

        public static void Dispatched(string kernel)
        {
            Dispatches++;
            Log?.Add(kernel);
        }

        public static void Drawn(string pass) => Log?.Add(pass);
    }
}
