namespace UnityEngine.Headless
{
    /// <summary>How much the device was asked to do, so that a test run can tell which tests truly reached it.</summary>
    internal static class GpuWork
    {
        /// <summary>Compute dispatches handed to the device, direct and indirect.</summary>
        public static long Dispatches;
    }
}
