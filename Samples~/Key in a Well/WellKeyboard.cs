using UnityEngine;

namespace Rill.Samples
{
    /// <summary>Lets a person play: A and D move the tap, Space pours, R starts again. The first key ends the demonstration.</summary>
    /// <remarks>It reads Unity's Input Manager. With the Input System alone it does nothing: call the game from there.</remarks>
    public sealed class WellKeyboard : MonoBehaviour
    {
        [Tooltip("The game that is played.")]
        [SerializeField] WellGame game;

        [Tooltip("Who plays until a key is pressed.")]
        [SerializeField] ScriptedPlayer demonstration;

        void Update()
        {
            ReadKeys(out float move, out bool pours, out bool restarts, out bool isPressed);
            if (demonstration.enabled && !isPressed)
                return;
            restarts |= demonstration.enabled;
            demonstration.enabled = false;
            game.MoveTap(move);
            game.Pour(pours);
            if (restarts)
                game.Restart();
        }

        static void ReadKeys(out float move, out bool pours, out bool restarts, out bool isPressed)
        {
#if ENABLE_LEGACY_INPUT_MANAGER
            move = Input.GetAxisRaw("Horizontal");
            pours = Input.GetKey(KeyCode.Space);
            restarts = Input.GetKeyDown(KeyCode.R);
            isPressed = Input.anyKeyDown;
#else
            move = 0f;
            pours = restarts = isPressed = false;
#endif
        }
    }
}
