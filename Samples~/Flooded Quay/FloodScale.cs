using UnityEngine;

namespace Rill.Samples
{
    /// <summary>
    /// Makes the same volume of water of however many particles are asked for: sets the particle spacing and the capacity of the
    /// fluid on this object before it begins.
    /// </summary>
    [DefaultExecutionOrder(-100)]
    [RequireComponent(typeof(FluidSimulation))]
    public sealed class FloodScale : MonoBehaviour
    {
        [Tooltip("Particles of the whole flood. 1,000 to 4,000,000.")]
        [Range(1000, 4000000)]
        [SerializeField] int particles = 200000;

        [Tooltip("Volume of all the water, m³, above 0: what the harbor holds at the start, and the sum of the sluices' rates times " +
            "their durations.")]
        [Min(1f)]
        [SerializeField] float volume = 540f;

        /// <summary>Particles of the whole flood. When it is set, the flood begins again.</summary>
        public int Particles
        {
            get => particles;
            set
            {
                particles = Mathf.Clamp(value, 1000, 4000000);
                Apply();
            }
        }

        void Awake() => Apply();

        void Apply()
        {
            var simulation = GetComponent<FluidSimulation>();
            float spacing = Mathf.Pow(volume / particles, 1f / 3f);
            // Two in a hundred more, for what each sluice rounds up.
            simulation.Configure(simulation.DomainSize, spacing, particles + particles / 50);
        }
    }
}
