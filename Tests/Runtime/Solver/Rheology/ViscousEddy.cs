using System;
using System.Linq;
using Rill.Tests.Reference;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>An eddy z x r exp(-r²/w²) in the center of a free block, by the whole solver. Lengths in d.</summary>
    sealed class ViscousEddy
    {
        readonly int side;
        readonly float width;

        /// <param name="side">Of the block.</param>
        /// <param name="width">w: at a fifth of the side little of it is left at the surface.</param>
        public ViscousEddy(int side, float width)
        {
            this.side = side;
            this.width = width;
        }

        /// <summary>Positions of the block on a lattice.</summary>
        public float3[] Lattice => ParticleState.Lattice(0f, 0.5f, side).positions.Select(p => p.xyz).ToArray();

        /// <summary>Fraction of it that steps of the solver leave.</summary>
        /// <param name="positions">d.</param>
        /// <param name="viscosity">Kinematic, m²/s.</param>
        public double Left(float3[] positions, float viscosity, float spacing, float timeStep, int steps)
        {
            FluidMaterial material = FluidMaterial.Water;
            material.velocitySmoothing = 0f;
            material.dynamicViscosity = viscosity * material.density;
            return Left(positions, material, spacing, timeStep, steps);
        }

        public double Left(float3[] positions, in FluidMaterial material, float spacing, float timeStep, int steps)
        {
            using (var fluid = new TestFluid((side + 4f) * spacing, spacing, positions.Length))
            {
                fluid.Input.gravity = 0f;
                fluid.Input.timeStep = timeStep;
                fluid.Input.material.velocitySmoothing = 0f;
                // the first step has no lists
                fluid.Add(positions.Select(p => (p + 2f) * spacing).ToArray(), p => 2f * spacing * Velocity(p / spacing)).Step();
                double before = Along(fluid.Read());
                fluid.Input.material = material;
                return Along(fluid.Step(steps).Read()) / before;
            }
        }

        /// <summary>Fraction of it that implicit steps leave in endless fluid, by the heat equation: over the eddy's spectrum, k⁴
        /// exp(-k²w²/2).</summary>
        /// <param name="strength">ν Δt / d².</param>
        public double Expected(double strength, int steps)
        {
            double left = 0.0, all = 0.0;
            for (double k = 0.0005; k < 18.0 / width; k += 0.001)
            {
                double weight = Math.Pow(k, 4) * Math.Exp(-0.5 * k * k * width * width);
                left += weight * Math.Pow(1.0 + strength * k * k, -steps);
                all += weight;
            }
            return left / all;
        }

        /// <summary>Returns this fraction in the block with its free surface.</summary>
        public double ExpectedInBlock(double strength, int steps)
        {
            return new FreeCube(side, side / 2, p => new double3(-p.y, p.x, 0.0) * Math.Exp(-math.dot(p, p) / (width * width))).Left(strength, steps);
        }

        float3 Velocity(float3 p)
        {
            p -= 0.5f * side + 2f;
            return new float3(-p.y, p.x, 0f) * math.exp(-math.lengthsq(p) / (width * width));
        }

        double Along(ParticleState state)
        {
            double along = 0.0, all = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                float3 eddy = Velocity(state.positions[i].xyz);
                along += math.dot(eddy, state.velocities[i].xyz);
                all += math.dot(eddy, eddy);
            }
            return along / all;
        }
    }
}
