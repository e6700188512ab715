using System;

namespace UnityEngine.Headless
{
    /// <summary>A use of the graphics API that Unity leaves undefined, or logs and skips, and that strict mode does not let pass.</summary>
    internal sealed class GpuUsageException : InvalidOperationException
    {
        public GpuUsageException(string message) : base(message) { }
    }

    internal static class GpuError
    {
        /// <summary>Strict: throws with all that is known. Otherwise logs as Unity does, and the caller skips the call.</summary>
        public static void Report(string strictMessage, string unityMessage)
        {
            if (Player.Strict)
                throw new GpuUsageException(strictMessage);
            Debug.LogError(unityMessage);
        }

        /// <summary>For what Unity does without a word: only strict mode objects.</summary>
        public static void Strictly(string message)
        {
            if (Player.Strict)
                throw new GpuUsageException(message);
        }
    }
}
