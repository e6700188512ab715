using System;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Fluids in a row along x whose boxes overlap by eight spacings.</summary>
    public abstract class ConnectedFluidFixture : PlayedFluidFixture
    {
        protected const float Spacing = 0.1f, Overlap = 8f * Spacing;

        protected static readonly Vector3 Box = new Vector3(2f, 1.2f, 0.5f);

        /// <summary>One box on each side of x = 0; water from the outer end of each.</summary>
        protected (FluidSimulation left, FluidSimulation right) Pair(Vector3 waterLeft, Vector3 waterRight, DeepWater deepWater = DeepWater.Off,
            Action<FluidSimulation> setUp = null, int capacity = 4000)
        {
            float x = 0.5f * (Box.x - Overlap);
            return (Make("Left", -x, -1f, waterLeft, deepWater, setUp, capacity), Make("Right", x, 1f, waterRight, deepWater, setUp, capacity));
        }

        /// <summary>A box with its center at x, and water from its lower (-1) or upper end.</summary>
        protected FluidSimulation Make(string name, float x, float end, Vector3 water, DeepWater deepWater = DeepWater.Off,
            Action<FluidSimulation> setUp = null, int capacity = 4000)
        {
            return Fluid(name, Box, Spacing, capacity, Vector3.zero, fluid =>
            {
                fluid.StatisticsInterval = 0;
                SolverSettings settings = fluid.Settings;
                settings.deepWater = deepWater;
                fluid.Settings = settings;
                fluid.transform.position = new Vector3(x, 0f, 0f);
                if (water != Vector3.zero)
                    AddWater(fluid, water, new Vector3(end * 0.5f * (Box.x - water.x), 0.5f * (water.y - Box.y), 0.5f * (water.z - Box.z)));
                setUp?.Invoke(fluid);
            });
        }

        protected FluidConnection Connect(FluidSimulation first, FluidSimulation second)
        {
            var gameObject = new GameObject("Opening");
            made.Add(gameObject);
            gameObject.SetActive(false);
            var connection = gameObject.AddComponent<FluidConnection>();
            connection.First = first;
            connection.Second = second;
            gameObject.SetActive(true);
            return connection;
        }

        protected static void Weightless(FluidSimulation fluid) => fluid.Gravity = Vector3.zero;

        /// <summary>Positions in world space of the particles that are a fluid's own.</summary>
        protected static Vector3[] Own(FluidSimulation fluid)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            Matrix4x4 toWorld = fluid.DomainToWorld;
            return state.positions.Where(p => math.all(math.isfinite(p.xyz))).Select(p => toWorld.MultiplyPoint3x4(p.xyz)).ToArray();
        }

        /// <summary>Mean over several frames of the speed of the water so far from x = 0, m.</summary>
        protected sealed class SpeedMean
        {
            readonly float from, to;
            double squares;
            int count;

            public SpeedMean(float from, float to)
            {
                this.from = from;
                this.to = to;
            }

            /// <summary>m/s.</summary>
            public double Rms => Math.Sqrt(squares / Math.Max(count, 1));

            public void Add(params FluidSimulation[] fluids)
            {
                foreach (FluidSimulation fluid in fluids)
                {
                    ParticleState state = TestFluid.Read(fluid.Solver);
                    Matrix4x4 toWorld = fluid.DomainToWorld;
                    for (int i = 0; i < state.Count; i++)
                    {
                        float distance = Mathf.Abs(toWorld.MultiplyPoint3x4(state.positions[i].xyz).x);
                        if (!(distance >= from && distance < to))
                            continue;
                        squares += math.lengthsq(state.velocities[i].xyz * fluid.ParticleSpacing);
                        count++;
                    }
                }
            }
        }

        /// <summary>Height of the water's surface over the floor between two places along x: twice that of its center of mass.</summary>
        protected static float Level(FluidSimulation fluid, float from, float to)
        {
            float[] heights = Own(fluid).Where(p => p.x >= from && p.x < to).Select(p => p.y + 0.5f * Box.y).ToArray();
            return heights.Length == 0 ? 0f : 2f * heights.Average();
        }
    }
}
