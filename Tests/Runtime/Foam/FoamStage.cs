using System;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The foam stage over particles that no constraint has moved, and what it left. Lengths in d.</summary>
    sealed class FoamStage : IDisposable
    {
        public readonly SolverStages Stages;
        public readonly Foam Foam;
        public readonly StepInput Input;

        /// <summary>State of the fluid, in the order in which the stage saw it.</summary>
        public readonly double3[] Points, Velocities;
        public readonly uint[] Ids;

        /// <param name="gravity">d/s².</param>
        /// <param name="fluidStep">s, in which the fluid came to where it is; the foam's is 1/60.</param>
        public FoamStage(ParticleState state, FoamSettings settings, float3 gravity = default, int seed = 1, float fluidStep = 1f / 60f,
            long maxBinding = 0, int capacity = 0)
        {
            Input = SolverStages.Still();
            Input.timeStep = fluidStep;
            Input.material.velocitySmoothing = 0f;
            Input.foam = settings;
            Input.foamSeed = seed;
            Stages = new SolverStages(state, Input, capacity, maxBinding);
            Stages.Sort().Constrain(iterations: 0).UpdateVelocities();
            Points = Compare.Points(Stages.Predicted);
            Velocities = Compare.Points(Stages.Velocities);
            Ids = Stages.SortedIds;
            Stages.Particles.Advance();
            Input.timeStep = 1f / 60f;
            Input.gravity = gravity * SolverStages.Spacing;     // for the foam alone
            Foam = new Foam(Stages.Layout, settings.budget);
            foreach (GraphicsBuffer buffer in new[] { Foam.Particles, Foam.Potentials, Foam.Cells })
                GpuTest.FillWithGarbage(buffer);
        }

        /// <summary>Settings of a scene that is 20 d deep and whose own speed is 20 d/s.</summary>
        public static FoamSettings Settings(float amount, int budget = 100000)
        {
            FoamSettings settings = FoamSettings.Default;
            settings.amount = amount;
            settings.budget = budget;
            settings.referenceSpeed = settings.referenceDepth = 20f * SolverStages.Spacing;
            return settings;
        }

        /// <summary>Takes steps in which the fluid stands as it is.</summary>
        public FoamStage Step(int count = 1)
        {
            for (int i = 0; i < count; i++)
                GpuTest.Run(cmd => Foam.Record(Stages.Context(cmd, Input), 0f));
            return this;
        }

        /// <summary>Puts particles instead of those that are there.</summary>
        public FoamStage Plant(params (float3 position, float3 velocity, FoamKinds kind, float lifetime)[] foam)
        {
            Plant(Foam, foam);
            return this;
        }

        public static void Plant(Foam stage, params (float3 position, float3 velocity, FoamKinds kind, float lifetime)[] foam)
            => Plant(stage, foam.Select(f => Particle(f.position, f.velocity, f.kind, 0f, f.lifetime)).ToArray());

        /// <summary>Puts particles instead of those that are there.</summary>
        public static void Plant(Foam stage, params FoamParticle[] foam)
        {
            if (foam.Length > 0)
                stage.Particles.SetData(foam, 0, 0, foam.Length);
            stage.Counters.SetData(new[] { (uint)foam.Length, 0u, 0u, 0u, 0u, 0u, 0u, 0u });
            stage.Arguments.SetData(ParticleState.ArgumentsFor(foam.Length));
        }

        /// <summary>One of the largest size, as Foam.hlsl packs it.</summary>
        /// <param name="age">s.</param>
        /// <param name="random">Its own number, 0 to 255.</param>
        public static FoamParticle Particle(float3 position, float3 velocity, FoamKinds kind, float age, float lifetime, uint random = 0)
            => new FoamParticle
            {
                a = new uint4(math.asuint(position), math.asuint(age)),
                b = new uint4(math.asuint(velocity), Number(kind) | (uint)(lifetime * 64f) << 2 | 255u << 16 | random << 24),
            };

        public uint Counter(FoamCounter counter) => GpuTest.Read<uint>(Foam.Counters, Foam.CounterCount)[(int)counter];

        public FoamParticle[] Read() => GpuTest.Read<FoamParticle>(Foam.Particles, (int)Counter(FoamCounter.Alive));

        public static float3 Position(FoamParticle particle) => math.asfloat(particle.a.xyz);
        public static float3 Velocity(FoamParticle particle) => math.asfloat(particle.b.xyz);
        public static float Age(FoamParticle particle) => math.asfloat(particle.a.w);
        public static float Lifetime(FoamParticle particle) => (particle.b.w >> 2 & 16383) / 64f;
        public static FoamKinds Kind(FoamParticle particle) => (particle.b.w & 3) == 0 ? 0 : (FoamKinds)(1 << (int)(particle.b.w & 3) - 1);

        static uint Number(FoamKinds kind) => kind == FoamKinds.Spray ? 1u : kind == FoamKinds.Foam ? 2u : 3u;

        public void Dispose()
        {
            Foam.Dispose();
            Stages.Dispose();
        }
    }
}
