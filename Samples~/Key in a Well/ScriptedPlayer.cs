using UnityEngine;

namespace Rill.Samples
{
    /// <summary>Plays by itself: moves the tap to where it aims, pours while the game goes on, and starts again when it is over.</summary>
    public sealed class ScriptedPlayer : MonoBehaviour
    {
        const float Near = 0.02f;       // m

        [Tooltip("The game that it plays.")]
        [SerializeField] WellGame game;

        [Tooltip("Where it pours, m from the center of the well. -0.7 to 0.7.")]
        [Range(-0.7f, 0.7f)]
        [SerializeField] float aim;

        [Tooltip("Time until it plays again, s. 0 for one game.")]
        [Min(0f)]
        [SerializeField] float restartsAfter = 6f;

        [System.NonSerialized] float over;

        /// <summary>Position where it pours, m from the center of the well.</summary>
        public float Aim { get => aim; set => aim = value; }

        /// <summary>Time until it plays again, s; 0 for one game.</summary>
        public float RestartsAfter { get => restartsAfter; set => restartsAfter = value; }

        void OnDisable()
        {
            game.MoveTap(0f);
            game.Pour(false);
        }

        void Update()
        {
            bool isPlaying = game.State == WellState.Playing;
            float away = aim - game.TapX;
            game.MoveTap(isPlaying ? Mathf.Clamp(away / 0.1f, -1f, 1f) : 0f);       // slower as it comes near
            game.Pour(isPlaying && Mathf.Abs(away) < Near);
            over = isPlaying ? 0f : over + Time.deltaTime;
            if (restartsAfter > 0f && over >= restartsAfter)
                game.Restart();
        }
    }
}
