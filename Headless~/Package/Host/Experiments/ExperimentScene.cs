using System;
using System.Collections.Generic;
using System.Globalization;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Experiments
{
    /// <summary>Blocks of fluid in a closed box, on a cubic lattice with offsets of ±0.02 spacings: what figures are measured on.</summary>
    sealed class ExperimentScene
    {
        public readonly string Name;
        /// <summary>m.</summary>
        public readonly float Spacing;
        /// <summary>Inner size of the box, d.</summary>
        public readonly float3 Box;
        /// <summary>Lowest corner, d; particles along each axis; velocity, m/s.</summary>
        public readonly List<(float3 corner, int3 counts, float3 velocity)> Blocks = new();

        ExperimentScene(string name, float spacing, float3 box)
        {
            Name = name;
            Spacing = spacing;
            Box = box;
        }

        public int Particles
        {
            get
            {
                int sum = 0;
                foreach ((float3 _, int3 counts, float3 _) in Blocks)
                    sum += counts.x * counts.y * counts.z;
                return sum;
            }
        }

        /// <summary>m.</summary>
        public float3 Domain => Box * Spacing;

        /// <summary>Number of layers of the tallest block on the floor.</summary>
        public int Layers
        {
            get
            {
                int layers = 0;
                foreach ((float3 corner, int3 counts, float3 _) in Blocks)
                    if (corner.y == 0f)
                        layers = Math.Max(layers, counts.y);
                return layers;
            }
        }

        /// <summary>A block in the left half of a box twice as long and twice as tall; particles in all as near as its lattice comes.</summary>
        /// <param name="spacing">m; 0 for a block 1 m high.</param>
        public static ExperimentScene Dam(int particles, float spacing = 0f)
        {
            int3 lattice = DamLattice(particles);
            float d = spacing > 0f ? spacing : 1f / lattice.y;
            return new ExperimentScene("dam", d, new float3(2 * lattice.x, 2 * lattice.y, lattice.z)).Add(0f, lattice);
        }

        /// <summary>A block in the lowest corner of a box.</summary>
        /// <param name="box">d.</param>
        /// <param name="spacing">m.</param>
        public static ExperimentScene Block(string name, int3 counts, int3 box, float spacing)
            => new ExperimentScene(name, spacing, box).Add(0f, counts);

        /// <summary>A block anywhere in a box.</summary>
        /// <param name="corner">Its lowest, d.</param>
        public static ExperimentScene Block(string name, int3 corner, int3 counts, int3 box, float spacing)
            => new ExperimentScene(name, spacing, box).Add(corner, counts);

        /// <summary>Still water that fills the floor of a box of 24 x 24 spacings, in a box three times as tall.</summary>
        /// <param name="spacing">m.</param>
        public static ExperimentScene Column(int layers, float spacing, int side = 24) => Still("column", layers, side, spacing);

        /// <summary>Still water that fills the wide floor of a box three times as tall.</summary>
        /// <param name="side">Of the floor, d.</param>
        /// <param name="spacing">m.</param>
        public static ExperimentScene Tank(int layers, int side, float spacing) => Still("tank", layers, side, spacing);

        static ExperimentScene Still(string name, int layers, int side, float spacing) =>
            new ExperimentScene(name, spacing, new float3(side, 3 * layers, side)).Add(0f, new int3(side, layers, side));

        /// <summary>A block that falls at 25 m/s onto a pool of 4 layers, from half a meter above the floor; 540,672 particles at scale 4.</summary>
        /// <param name="scale">Of all counts but the pool's layers, in eighths.</param>
        /// <param name="spacing">m; 0: 0.05 m / scale.</param>
        public static ExperimentScene Drop(float scale, float spacing = 0f)
        {
            float d = spacing > 0f ? spacing : 0.05f / scale;
            return new ExperimentScene("drop", d, new float3(48, 160, 48) * scale)
                .Add(0f, new int3((int)(48 * scale), 4, (int)(48 * scale)))
                .Add(new float3(16 * scale, math.round(0.5f / d), 16 * scale), (int3)(new float3(16, 24, 16) * scale), new float3(0, -25, 0));
        }

        /// <summary>A cube in the lowest corner of a floor that it covers, once it has run out, as so many layers; a box twice as tall.</summary>
        /// <param name="side">Of the cube, d.</param>
        /// <param name="spacing">m.</param>
        public static ExperimentScene Spill(double layers, int side, float spacing)
        {
            float floor = math.round((float)Math.Sqrt(side * (double)side * side / layers));
            return new ExperimentScene("spill", spacing, new float3(floor, 2 * side, floor)).Add(0f, side);
        }

        /// <summary>"dam:1000000", "column:120:0.05", "tank:8:112:0.02", "drop:4", "spill:1.5:16:0.05".</summary>
        public static ExperimentScene Parse(string text)
        {
            double[] n;
            switch (text.Split(':')[0])
            {
                case "dam":
                    n = GivenNumber.Parse(text, "dam:100000",
                        new GivenNumber("particles", MinDamParticles, SolverLayout.MaxCapacity, Otherwise: 100_000), SpacingOr(0));
                    return Dam((int)n[0], (float)n[1]);
                case "column":
                    n = GivenNumber.Parse(text, "column:120:0.05", LayersOr(120), SpacingOr(0.05));
                    GivenNumber.CheckParticles(text, 24.0 * 24.0 * n[0]);
                    return Column((int)n[0], (float)n[1]);
                case "tank":
                    n = GivenNumber.Parse(text, "tank:8:112:0.02", LayersOr(8),
                        new GivenNumber("side of the floor in spacings", 2, MaxAcross, Otherwise: 112), SpacingOr(0.02));
                    GivenNumber.CheckParticles(text, n[0] * n[1] * n[1]);
                    return Tank((int)n[0], (int)n[1], (float)n[2]);
                case "drop":
                    n = GivenNumber.Parse(text, "drop:4:0.0125", new GivenNumber("scale", 0.125, MaxAcross / 160, false, 4), SpacingOr(0));
                    if (n[0] * 8 != Math.Floor(n[0] * 8))
                        throw new HostException($"scene \"{text}\": scale is {text.Split(':')[1]}; give a multiple of 0.125, as in drop:4:0.0125.");
                    GivenNumber.CheckParticles(text, 4.0 * 48.0 * 48.0 * n[0] * n[0] + 16.0 * 16.0 * 24.0 * n[0] * n[0] * n[0]);
                    if (n[1] > 0 && 0.5 / n[1] > 100 * n[0])
                        throw new HostException(string.Create(CultureInfo.InvariantCulture,
                            $"scene \"{text}\": spacing in m is {n[1]}, too fine for the box, which is {160 * n[0]} spacings tall and " +
                            $"must hold the block 0.5 m above its floor; give {0.005 / n[0]:0.#####} or more, or a larger scale."));
                    return Drop((float)n[0], (float)n[1]);
                case "spill":
                    n = GivenNumber.Parse(text, "spill:2:16:0.05", new GivenNumber("layers", 0.1, MaxAcross / 3, false, 2),
                        new GivenNumber("side of the cube in spacings", 2, MaxAcross / 2, Otherwise: 16), SpacingOr(0.05));
                    GivenNumber.CheckParticles(text, n[1] * n[1] * n[1]);
                    if (n[0] > n[1])
                        throw new HostException(string.Create(CultureInfo.InvariantCulture,
                            $"scene \"{text}\": layers is {n[0]}, more than the cube is tall; give at most {n[1]}, as in spill:2:16:0.05."));
                    double thinnest = n[1] * n[1] * n[1] / (MaxAcross * MaxAcross);
                    if (n[0] < thinnest)
                        throw new HostException(string.Create(CultureInfo.InvariantCulture,
                            $"scene \"{text}\": layers is {n[0]}, for which the floor is more than {MaxAcross:N0} spacings wide; give " +
                            $"at least {Math.Ceiling(1000 * thinnest) / 1000}, or a smaller cube."));
                    return Spill(n[0], (int)n[1], (float)n[2]);
                default:
                    throw new HostException($"scene \"{text}\": give dam:<particles>:<spacing in m>, column:<layers>:<spacing in m>, " +
                        $"tank:<layers>:<side of the floor in spacings>:<spacing in m>, drop:<scale in eighths>:<spacing in m> or " +
                        $"spill:<layers>:<side of the cube in spacings>:<spacing in m>, as in dam:1000000, column:120:0.05, " +
                        $"tank:8:112:0.02, drop:4 or spill:2:16:0.05.");
            }
        }

        /// <summary>Minimum for a dam: a box of two spacings.</summary>
        public const int MinDamParticles = 8;

        const double MaxAcross = SolverLayout.MaxSpacingsAcross;

        // In a box three times as tall.
        static GivenNumber LayersOr(double otherwise) => new("layers", 1, Math.Floor(MaxAcross / 3), Otherwise: otherwise);

        static GivenNumber SpacingOr(double otherwise) => new("spacing in m", GivenNumber.MinSpacing, GivenNumber.MaxSpacing, false, otherwise);

        /// <summary>Layout that a solver of these settings needs for the scene.</summary>
        public SolverLayout LayoutFor(in SolverSettings settings)
            => new SolverLayout(Domain, Spacing, Particles, settings.neighborCapacity, settings.listMargin);

        /// <summary>Fills a solver that was just cleared.</summary>
        public void Fill(PbfSolver solver) => Fill(solver.Add);

        /// <param name="add">Takes positions, m, and velocities, m/s.</param>
        public void Fill(Action<NativeArray<float4>, NativeArray<float4>> add)
        {
            using var positions = new NativeArray<float4>(Particles, Allocator.Persistent);
            using var velocities = new NativeArray<float4>(Particles, Allocator.Persistent);
            NativeArray<float4> to = positions, speeds = velocities;
            var random = new Random(7);
            int i = 0;
            foreach ((float3 corner, int3 counts, float3 velocity) in Blocks)
                for (int z = 0; z < counts.z; z++)
                    for (int y = 0; y < counts.y; y++)
                        for (int x = 0; x < counts.x; x++)
                        {
                            to[i] = new float4((corner + new float3(x, y, z) + 0.5f + random.NextFloat3(-0.02f, 0.02f)) * Spacing, 0f);
                            speeds[i++] = new float4(velocity, 0f);
                        }
            add(positions, velocities);
        }

        ExperimentScene Add(float3 corner, int3 counts, float3 velocity = default)
        {
            Blocks.Add((corner, counts, velocity));
            return this;
        }

        // Blocks that published figures of this project refer to; others as near a cube as they come.
        static int3 DamLattice(int particles)
        {
            switch (particles)
            {
                case 100_000: return new int3(50, 50, 40);
                case 1_000_000: return new int3(100, 100, 100);
                case 10_000_000: return new int3(216, 216, 216);
            }
            int side = Math.Max(1, (int)Math.Round(Math.Cbrt(particles)));
            return new int3(side, side, Math.Max(1, (int)Math.Round(particles / (double)(side * side))));
        }
    }
}
