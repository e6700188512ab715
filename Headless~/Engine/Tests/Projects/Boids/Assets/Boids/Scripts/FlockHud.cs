using UnityEngine;
#if FLOCKING_UGUI
using UnityEngine.UI;
#endif

namespace Flocking
{
    [RequireComponent(typeof(Canvas))]
    public class FlockHud : MonoBehaviour
    {
#if FLOCKING_UGUI
        public Text countText;
        public Slider speedSlider;
#endif
        GUIStyle style;
        float smoothed;

        void Start()
        {
            var manager = FlockManager.Instance;
#if FLOCKING_UGUI
            countText.text = string.Format("{0} boids", manager.Count);
            speedSlider.onValueChanged.AddListener(value => manager.speed = value);
            speedSlider.value = manager.speed;
            Debug.Log("HUD says: " + countText.text);
#endif
        }

        void Update()
        {
            smoothed = Mathf.Lerp(smoothed, Time.unscaledDeltaTime, 0.1f);
        }

        void OnGUI()
        {
            if (style == null)
                style = new GUIStyle(GUI.skin.label) { fontSize = 20 };
            GUILayout.Label((1f / Mathf.Max(smoothed, 1e-5f)).ToString("F0") + " fps", style);
            if (GUILayout.Button(FlockManager.Instance.Paused ? "Play" : "Pause"))
                FlockManager.Instance.Paused = !FlockManager.Instance.Paused;
        }
    }
}
