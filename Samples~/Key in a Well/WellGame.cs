using System;
using System.Collections;
using UnityEngine;
using UnityEngine.Events;

namespace Rill.Samples
{
    /// <summary>How a game in the well stands.</summary>
    public enum WellState
    {
        /// <summary>The snapshot of the start has been asked for.</summary>
        Preparing,
        /// <summary>The tap obeys.</summary>
        Playing,
        /// <summary>The key is out.</summary>
        Won,
        /// <summary>The water is used up, and the key is still down there.</summary>
        Lost,
    }

    /// <summary>
    /// The rules of the game: pour water into the well until the key floats out. It is won when the well is full and the key above its
    /// height for a while; it is lost when all water is poured and that does not come about.
    /// </summary>
    /// <remarks>Whoever plays calls <see cref="MoveTap"/>, <see cref="Pour"/> and <see cref="Restart"/>: a keyboard, or a script.</remarks>
    public sealed class WellGame : MonoBehaviour
    {
        [Tooltip("The water.")]
        [SerializeField] FluidSimulation fluid;

        [Tooltip("The tap that moves along its beam. It is always on; the game sets its rate.")]
        [SerializeField] FluidEmitter tap;

        [Tooltip("Measures how full the well is. Its Fill Level is that of a full well.")]
        [SerializeField] FluidDetector well;

        [Tooltip("The key with its float, whose constraints let it move up and down alone.")]
        [SerializeField] Rigidbody key;

        [Tooltip("Water that there is to pour, m³. Above 0.")]
        [Min(0.001f), SerializeField] float supply = 0.3f;

        [Tooltip("Rate of the open tap, m³/s. Above 0.")]
        [Min(0.001f), SerializeField] float rate = 0.035f;

        [Tooltip("How far the tap goes to each side, m. Its speed, m/s.")]
        [SerializeField] Vector2 reachAndSpeed = new Vector2(0.7f, 0.8f);

        [Tooltip("World height from which the key is out of the well, m.")]
        [SerializeField] float keyHeight;

        [Tooltip("Time for which well and key have to hold that, s. 0 to 10.")]
        [Range(0f, 10f), SerializeField] float holdTime = 0.5f;

        [Tooltip("Time that the last of the water has to lift the key, s. 0 to 10.")]
        [Range(0f, 10f), SerializeField] float patience = 3f;

        [Tooltip("Called when a game begins.")]
        [SerializeField] UnityEvent onStarted = new UnityEvent();

        [Tooltip("Called when the key is out.")]
        [SerializeField] UnityEvent onWon = new UnityEvent();

        [Tooltip("Called when the water is used up in vain.")]
        [SerializeField] UnityEvent onLost = new UnityEvent();

        FluidSnapshot start;
        [NonSerialized] FluidBuoyancy buoyancy;
        [NonSerialized] Vector3 tapStart, keyStart;
        [NonSerialized] float direction, held, waited;
        [NonSerialized] bool isPouring, isPutBack;

        /// <summary>How the game stands.</summary>
        [field: NonSerialized] public WellState State { get; private set; }

        /// <summary>Called when a game begins.</summary>
        public event Action OnStarted;

        /// <summary>Called when the key is out.</summary>
        public event Action OnWon;

        /// <summary>Called when the water is used up in vain.</summary>
        public event Action OnLost;

        /// <summary>Position of the tap along its beam, m; 0 is above the center of the well.</summary>
        public float TapX => tap.transform.position.x;

        /// <summary>Water that there is to pour, m³, above 0.</summary>
        public float Supply { get => supply; set => supply = value; }

        /// <summary>Fraction of the water that is left to pour, 0 to 1.</summary>
        public float WaterLeft => Mathf.Clamp01(1f - (float)tap.DueVolume / supply);

        /// <summary>Whether the well is full and the key above its height, as far as the newest results say.</summary>
        public bool IsKeyOut => well.TryGetSample(out FluidDetectorSample inside) && inside.fill >= well.FillLevel
            && key.position.y >= keyHeight;

        /// <summary>Moves the tap from now on.</summary>
        /// <param name="to">-1 to the left to 1 to the right; 0 stops it.</param>
        public void MoveTap(float to) => direction = Mathf.Clamp(to, -1f, 1f);

        /// <summary>Opens or closes the tap.</summary>
        public void Pour(bool open) => isPouring = open;

        /// <summary>Puts everything back to the start of the first game.</summary>
        public void Restart()
        {
            if (State == WellState.Preparing)
                return;
            tap.transform.position = tapStart;
            buoyancy.enabled = false;                       // the water of the last game lets go of it
            key.transform.position = key.position = keyStart;
            isPutBack = true;
            buoyancy.enabled = true;
            fluid.Restore(start);                           // after all else is back in its place
            Begin(WellState.Playing, onStarted, OnStarted);
        }

        IEnumerator Start()
        {
            buoyancy = key.GetComponent<FluidBuoyancy>();
            tapStart = tap.transform.position;
            keyStart = key.position;
            tap.Rate = 0f;
            yield return null;                              // the fluid has begun
            FluidSnapshotRequest request = fluid.RequestSnapshot();
            yield return request;
            if (request.Problem != null)
            {
                Debug.LogError($"WellGame '{name}' cannot begin: {request.Problem}", this);
                yield break;
            }
            start = request.Snapshot;
            Begin(WellState.Playing, onStarted, OnStarted);
        }

        void Begin(WellState state, UnityEvent listed, Action scripts)
        {
            State = state;
            direction = held = waited = tap.Rate = 0f;
            isPouring = false;
            listed.Invoke();
            scripts?.Invoke();
        }

        void Update()
        {
            Vector3 at = tap.transform.position;
            at.x = Mathf.Clamp(at.x + direction * reachAndSpeed.y * Time.deltaTime, -reachAndSpeed.x, reachAndSpeed.x);
            tap.transform.position = at;
            tap.Rate = isPouring && State == WellState.Playing && WaterLeft > 0f ? rate : 0f;
            if (State != WellState.Playing)
                return;
            held = IsKeyOut ? held + Time.deltaTime : 0f;
            waited = WaterLeft > 0f ? 0f : waited + Time.deltaTime;
            if (held >= holdTime)
                Begin(WellState.Won, onWon, OnWon);
            else if (waited >= patience && held == 0f)
                Begin(WellState.Lost, onLost, OnLost);
        }

        // The key lies on its grate, whatever else holds it there. Its velocity has a name of its own in Unity 6, so a force stops it.
        void FixedUpdate()
        {
            if (!isPutBack && (start == null || key.position.y >= keyStart.y))
                return;
            isPutBack = false;
            key.position = keyStart;
            key.AddForce(-key.GetPointVelocity(key.worldCenterOfMass), ForceMode.VelocityChange);
        }
    }
}
