using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Samples
{
    /// <summary>
    /// A ball that sucks up the water below it and lets it fall once it is full. A pass of its own changes the particles before each step;
    /// a readback tells how much water the ball holds.
    /// </summary>
    public sealed class Waterspout : MonoBehaviour
    {
        [Tooltip("The fluid below the ball.")]
        [SerializeField] FluidSimulation fluid;

        [Tooltip("The pass, Waterspout.compute.")]
        [SerializeField] ComputeShader shader;

        [Tooltip("Radius of the empty ball, m.")]
        [Range(0.02f, 0.2f)]
        [SerializeField] float emptyRadius = 0.07f;

        [Tooltip("Radius at which it is full, m.")]
        [Range(0.05f, 0.4f)]
        [SerializeField] float fullRadius = 0.2f;

        [Tooltip("How far it swings to each side, m.")]
        [Range(0f, 1f)]
        [SerializeField] float swing = 0.25f;

        [Tooltip("Height of the pool's surface, world space, m.")]
        [SerializeField] float surface = 0.25f;

        [Tooltip("Radius of the spout at the ball, of the spout at the pool, and of the whirl in the pool, m.")]
        [SerializeField] Vector3 radii = new Vector3(0.06f, 0.085f, 0.35f);

        [Tooltip("Speed around the axis, upwards at the pool and inwards, m/s.")]
        [SerializeField] Vector3 speed = new Vector3(0.9f, 2.2f, 1.2f);

        [Tooltip("How fast water takes these speeds on, 1/s.")]
        [Range(1f, 60f)]
        [SerializeField] float grip = 25f;

        [Tooltip("Time between two spouts, s.")]
        [Range(0f, 10f)]
        [SerializeField] float pause = 2f;

        ParticleReadback readback;
        [NonSerialized] Vector3 home;
        [NonSerialized] int kernel, total, held;
        [NonSerialized] int countsFrom;         // readbacks of earlier steps do not know of the water that fell
        [NonSerialized] float restsUntil;

        /// <summary>Particles in the ball, as far as it is known.</summary>
        public int Held => held;

        bool IsLifting => fluid.FluidTime >= restsUntil;

        float Radius
        {
            get
            {
                float d = fluid.ParticleSpacing;
                return Mathf.Pow(emptyRadius * emptyRadius * emptyRadius + held * d * d * d * (3f / (4f * Mathf.PI)), 1f / 3f);
            }
        }

        void OnEnable()
        {
            if (fluid == null || shader == null)
            {
                Debug.LogError($"Waterspout '{name}' has no fluid or no shader: assign both.", this);
                enabled = false;
                return;
            }
            kernel = shader.FindKernel("Lift");
            home = transform.position;
            readback = new ParticleReadback();
            fluid.TrackPhases = true;
            fluid.BeforeStep += Record;
        }

        void OnDisable()
        {
            if (fluid != null)
                fluid.BeforeStep -= Record;
            readback?.Dispose();
            readback = null;
        }

        void Update()
        {
            if (!fluid.IsRunning)
                return;
            transform.position = home + swing * Mathf.Sin((float)fluid.FrameTime) * Vector3.right;
            CountHeld();
            if (Radius >= fullRadius)
                Fall();
            transform.localScale = 2f * Radius * Vector3.one;
        }

        // Before each step, for the particles of that step.
        void Record(CommandBuffer commands, FluidParticles particles)
        {
            Vector3 at = transform.position;
            commands.SetComputeVectorParam(shader, "_Ball", new Vector4(at.x, at.y, at.z, Radius));
            commands.SetComputeVectorParam(shader, "_Spout", new Vector4(radii.x, radii.y, radii.z, surface));
            commands.SetComputeVectorParam(shader, "_Speed", new Vector4(speed.x, speed.y, speed.z, IsLifting ? grip : 0f));
            particles.Dispatch(commands, shader, kernel);
        }

        // Dead particles count as held in the ball.
        void CountHeld()
        {
            if (readback.HasData && readback.Step >= countsFrom)
            {
                total = Mathf.Max(total, readback.Count);
                held = total - readback.Count;
            }
            fluid.RequestParticles(readback, ParticleFields.Ids);       // false while one is pending
        }

        // Drops as many particles as it holds, a spacing apart.
        void Fall()
        {
            float d = fluid.ParticleSpacing;
            int side = Mathf.CeilToInt(2f * fullRadius / d) + 2;
            using (var positions = new NativeArray<float3>(held, Allocator.Temp))
            using (var velocities = new NativeArray<float3>(held, Allocator.Temp))
            {
                NativeArray<float3> to = positions;
                float3 center = transform.position;
                int placed = 0;
                for (float radius = 0.5f * d; placed < held && radius < side * d; radius += 0.5f * d)      // shell by shell
                    for (int i = 0; i < side * side * side && placed < held; i++)
                    {
                        float3 offset = d * (new float3(i % side, i / side % side, i / (side * side)) - 0.5f * (side - 1));
                        float distance = math.length(offset);
                        if (distance < radius && distance >= radius - 0.5f * d)
                            to[placed++] = center + offset;
                    }
                fluid.AddParticles(positions, velocities);
            }
            held = 0;
            countsFrom = fluid.StepCount + 1;
            restsUntil = (float)fluid.FluidTime + pause;
        }
    }
}
