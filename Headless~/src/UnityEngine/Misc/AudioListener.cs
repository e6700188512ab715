namespace UnityEngine
{
    public class AudioBehaviour : Behaviour { }

    /// <summary>Cameras carry one; there is nothing to hear.</summary>
    public sealed class AudioListener : AudioBehaviour { }
}
