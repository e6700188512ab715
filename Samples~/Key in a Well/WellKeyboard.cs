using UnityEngine;

namespace Rill.Samples
{
    /// <summary>Lets a person play: A and D move the tap, Space pours, R starts again. The first key ends the demonstration.</summary>
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
#elif RILL_INPUT_SYSTEM
            var keys = UnityEngine.InputSystem.Keyboard.current;        // null where there is none
            move = keys?.dKey.ReadValue() + keys?.rightArrowKey.ReadValue() - keys?.aKey.ReadValue() - keys?.leftArrowKey.ReadValue() ?? 0f;
            pours = keys?.spaceKey.isPressed ?? false;
            restarts = keys?.rKey.wasPressedThisFrame ?? false;
            isPressed = keys?.anyKey.wasPressedThisFrame ?? false;
#else
            (move, pours, restarts, isPressed) = (0f, false, false, false);
#endif
        }
    }
}
