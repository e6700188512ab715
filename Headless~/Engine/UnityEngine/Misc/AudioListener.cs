namespace UnityEngine
{
    public class AudioBehaviour : Behaviour { }

    /// <summary>Cameras carry one; there is nothing to hear.</summary>
    public sealed class AudioListener : AudioBehaviour
    {
        public static float volume { get; set; } = 1;
        public static bool pause { get; set; }
    }
}
