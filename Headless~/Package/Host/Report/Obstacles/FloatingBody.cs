using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Report.Obstacles
{
    /// <summary>
    /// A ball or cube of half the water's density that FluidBuoyancy carries: it is let go above its place at rest, bobs without
    /// FluidBuoyancy's own damping, and comes to rest with it. Draft against Archimedes, the period of heave against T = 2π √((m + m_a) /
    /// (ρ g A)), A the area that it cuts out of the surface.
    /// </summary>
    /// <remarks>
    /// The added mass m_a is that of water whose surface does not answer, which is exact for fast heave: half of what the body and
    /// its mirror image have in endless water. Of a ball that is half of the water displaced (Lamb, Hydrodynamics, §92), of a cube 0.68 of
    /// it (DNV-RP-C205, appendix D). At the period found waves are made, by which the ball's is a fifth lower (Havelock 1955, "Waves due to
    /// a floating sphere making periodic heaving oscillations"), which shortens the period by 3 %; the walls and the floor of the tank make
    /// it longer.
    /// </remarks>
    sealed class FloatingBody
    {
        public const float Spacing = 0.05f, Density = 1000f, Ratio = 0.5f, Frame = 1f / 60f;
        public const float Lift = 0.15f;                        // of the body's height: where it is let go above rest
        const float HoldSeconds = 0.7f;                         // s in which the water makes room for it
        /// <summary>Width of the tank in widths of the body: the waves that it makes come back from the walls after the fitted swings.</summary>
        public const int WidthsAcross = 7;
        const double FittedSwings = 2.2;                        // of the theory's
        const float CalmSeconds = 2f;                           // s after them, with FluidBuoyancy's damping; the last is measured

        /// <summary>Since it was let go, s; its center over the floor, m.</summary>
        public readonly List<(double Time, double Value)> Heights = new();
        /// <summary>By Archimedes, m; how deep the body lies under the level measured, m; both in the last second.</summary>
        public double TheoryDraft { get; private set; }
        public double Draft { get; private set; }
        /// <summary>Level of the water around the body in the last second over that of water that keeps its volume, m.</summary>
        public double LevelError { get; private set; }
        public double TheoryPeriod { get; private set; }
        /// <summary>Fit of the first swings.</summary>
        public DampedCosine Fit { get; private set; }
        /// <summary>Without its damping: 2π / √(ω² + δ²) of the fitted cosine. Of a body that hardly swings it says nothing.</summary>
        public double Period => 2 * Math.PI / OwnFrequency;
        /// <summary>Fraction of the critical damping, which leaves no swing at 1.</summary>
        public double DampingRatio => Fit.Damping / OwnFrequency;
        double OwnFrequency => Math.Sqrt(Fit.Frequency * Fit.Frequency + Fit.Damping * Fit.Damping);

        /// <summary>Time that is fitted, s.</summary>
        /// <param name="period">By theory, s.</param>
        public static double FittedTime(double period) => FittedSwings * period;

        /// <summary>When waves of that period are back at a body from the walls of a tank, s: by the group velocity in deep water, g / 2ω.</summary>
        /// <param name="size">Of the body, m.</param>
        /// <param name="width">Of the tank, m.</param>
        /// <param name="period">s.</param>
        public static double WavesReturn(double size, double width, double period) => (width - size) / (FluidRun.Gravity * period / (4 * Math.PI));

        /// <summary>By theory, s.</summary>
        /// <param name="size">Of the body, m.</param>
        public static double PeriodOf(ColliderShape shape, double size)
        {
            bool isBall = shape == ColliderShape.Sphere;
            double volume = isBall ? Math.PI / 6 * size * size * size : size * size * size, area = isBall ? Math.PI / 4 * size * size : size * size;
            return 2 * Math.PI * Math.Sqrt(volume * Ratio * (1 + (isBall ? 0.5 : 0.68)) / (FluidRun.Gravity * area));
        }

        /// <param name="across">Of the body, d; as high as wide.</param>
        /// <param name="side">Of the tank, d.</param>
        public static FloatingBody Run(ColliderShape shape, int across, int layers, int side, in SolverSettings settings)
        {
            bool isBall = shape == ColliderShape.Sphere;
            float size = across * Spacing, width = side * Spacing;
            float volume = isBall ? math.PI / 6f * size * size * size : size * size * size;
            float level = layers * Spacing + volume * Ratio / (width * width), displaced = Density * volume * Ratio;
            var floating = new FloatingBody
            {
                TheoryDraft = size / 2f,        // half the density: half of a ball or of a cube
                TheoryPeriod = PeriodOf(shape, size),
            };

            float swings = (float)FittedTime(floating.TheoryPeriod), seconds = swings + CalmSeconds;
            var made = new List<GameObject>();
            try
            {
                FluidSimulation fluid = Tank(made, layers, side, settings);
                Rigidbody body = Body(made, shape, size, displaced, level + Lift * size);
                made.ForEach(thing => thing.SetActive(true));
                Play(HoldSeconds, null);
                body.isKinematic = false;
                var buoyancy = body.GetComponent<FluidBuoyancy>();
                float damping = buoyancy.Damping;
                buoyancy.Damping = 0f;
                double levels = 0;
                int samples = 0;
                Play(seconds, time =>
                {
                    floating.Heights.Add((time, body.position.y));
                    if (time > swings)
                        buoyancy.Damping = damping;
                    if (time <= seconds - 1 || floating.Heights.Count % 6 != 0)
                        return;
                    levels += LevelAround(fluid, body.position, size);
                    samples++;
                });
                double measured = levels / samples;
                floating.Draft = measured + size / 2f - floating.Heights.Where(h => h.Time > seconds - 1).Average(h => h.Value);
                floating.LevelError = measured - level;
            }
            finally
            {
                made.ForEach(Object.DestroyImmediate);
            }
            floating.Fit = DampedCosine.Fit(floating.Heights.Where(h => h.Time <= swings).ToList());
            return floating;
        }

        static FluidSimulation Tank(List<GameObject> made, int layers, int side, in SolverSettings settings)
        {
            Vector3 size = new Vector3(side, 2 * layers + 8, side) * Spacing;
            GameObject tank = Make(made, "Water");
            tank.transform.position = new Vector3(0f, size.y / 2f, 0f);
            var fluid = tank.AddComponent<FluidSimulation>();
            fluid.Configure(size, Spacing, side * side * layers);
            fluid.Settings = settings;
            fluid.StatisticsInterval = 0;
            var volume = new GameObject("Volume");
            volume.transform.SetParent(tank.transform, false);
            volume.transform.localPosition = new Vector3(0f, (layers * Spacing - size.y) / 2f, 0f);
            volume.AddComponent<FluidVolume>().Size = new Vector3(size.x, layers * Spacing, size.z);
            return fluid;
        }

        // It heaves alone: a cube of this density would turn to float on an edge.
        static Rigidbody Body(List<GameObject> made, ColliderShape shape, float size, float mass, float height)
        {
            GameObject thing = Make(made, "Body");
            thing.transform.position = new Vector3(0f, height, 0f);
            var obstacle = thing.AddComponent<FluidCollider>();
            obstacle.Shape = shape;
            obstacle.Size = size * Vector3.one;
            obstacle.Radius = size / 2f;
            var body = thing.AddComponent<Rigidbody>();
            body.mass = mass;
            body.isKinematic = true;
            body.constraints = RigidbodyConstraints.FreezeRotation | RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezePositionZ;
            thing.AddComponent<FluidBuoyancy>();
            return body;
        }

        static GameObject Make(List<GameObject> made, string name)
        {
            var thing = new GameObject(name);
            thing.SetActive(false);
            made.Add(thing);
            return thing;
        }

        // Samples after every step of the physics.
        static void Play(float seconds, Action<double> sample)
        {
            float start = Time.fixedTime, last = start;
            for (int frame = 0; frame < Mathf.RoundToInt(seconds / Frame); frame++)
            {
                PlayerLoop.Frame(Frame);
                if (Time.fixedTime > last)
                    sample?.Invoke(Time.fixedTime - start);
                last = Time.fixedTime;
            }
        }

        // Twice the mean height of the water that is at least two spacings beside the body, m.
        static double LevelAround(FluidSimulation fluid, Vector3 body, float size)
        {
            PbfSolver solver = fluid.Solver;
            int alive = (int)FluidRun.Read<uint>(solver.Counters, solver.Counters.count)[(int)ParticleCounter.Alive];
            float2 center = solver.Layout.DomainSize.xz / 2f + new float2(body.x, body.z) / Spacing;
            float beside = size / (2f * Spacing) + 2f;
            return 2 * Spacing * FluidRun.Read<float4>(solver.Positions, alive).Where(p => math.cmax(math.abs(p.xz - center)) > beside)
                .Average(p => p.y);
        }
    }
}
