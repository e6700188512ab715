using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Grains in whole steps: columns that collapse or stand, slopes, silos, and what friction keeps.</summary>
    public class GrainFrictionTests
    {
        const float Spacing = 0.01f;

        static SolverSettings Settings
        {
            get
            {
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = 2;
                settings.sleepSpeed = 0f;
                return settings;
            }
        }

        static FluidMaterial Sand(float friction, float cohesion = 0f)
        {
            FluidMaterial sand = FluidMaterial.Water;
            (sand.frictionAngle, sand.cohesion) = (math.degrees(math.atan(friction)), cohesion);
            return sand;
        }

        /// <summary>Heap that a cylinder of grains became. Lengths in d.</summary>
        readonly struct Heap
        {
            public readonly float RunOut;       // of the radius, where more than half of a layer lies
            public readonly float Crest;
            public readonly float Slope;        // degrees, a line through the heights of all rings
            public readonly float Speed;        // rms, m/s

            public Heap(TestFluid fluid, float radius)
            {
                ParticleState state = fluid.Read();
                float3 center = 0.5f * state.box;
                int[] rings = state.positions.Select(p => (int)math.length((p.xyz - center).xz)).ToArray();
                var heights = new float[rings.Max() + 1];
                for (int i = 0; i < state.Count; i++)
                    heights[rings[i]] = math.max(heights[rings[i]], state.positions[i].y + 0.5f);
                int last = Enumerable.Range(0, heights.Length).Last(r => rings.Count(ring => ring == r) > 0.5 * Math.PI * (2 * r + 1)) + 1;
                double n = last - 2, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
                for (int r = 1; r < last - 1; r++)
                    (x, y, xx, xy) = (x + r, y + heights[r], xx + r * r, xy + r * heights[r]);
                RunOut = (last - radius) / radius;
                Crest = heights[0];
                Slope = (float)(Math.Atan((x * y - n * xy) / (n * xx - x * x)) * 180.0 / Math.PI);
                Speed = (float)Math.Sqrt(state.velocities.Average(v => math.lengthsq(v.xyz))) * fluid.Spacing;
            }

            public override string ToString() => $"run-out {RunOut:0.00}, crest {Crest:0.0} d, slope {Slope:0.0}°, {Speed:0.0000} m/s";
        }

        static TestFluid Column(FluidMaterial material, int radius, float aspect, float spacing = Spacing, float stepRate = 60f, float room = 3f)
        {
            int side = (int)(2f * room * radius) / 4 * 4, height = (int)math.round(aspect * radius);
            var box = new float3(side, 2 * height + 8, side);
            ParticleState block = ParticleState.Lattice(0f, 0.5f, new int3(side, height, side), 0.1f);
            float3[] points = block.positions.Select(p => p.xyz).Where(p => math.length((p - 0.5f * box).xz) < radius).Select(p => p * spacing)
                .ToArray();
            var fluid = new TestFluid(box * spacing, spacing, points.Length, Settings);
            fluid.Input.timeStep = 1f / stepRate;
            fluid.Input.material = material;
            return fluid.Add(points);
        }

        static Heap Collapsed(float friction, int radius, float aspect, float seconds, float spacing = Spacing, float stepRate = 60f,
            float room = 3f)
        {
            using (TestFluid fluid = Column(Sand(friction), radius, aspect, spacing, stepRate, room))
            {
                fluid.Step((int)math.round(seconds * stepRate));
                var heap = new Heap(fluid, radius);
                TestContext.Out.WriteLine($"friction {friction}, {radius} d x {aspect}, d {spacing} m, {stepRate} Hz: {heap}");
                fluid.MeasureWhole();
                return heap;
            }
        }

        // Lube, Huppert, Sparks and Hallworth 2004, for columns of up to 1.7 radii and above: run-out and crest, of the radius.
        static float LubeRunOut(float aspect) => aspect < 1.7f ? 1.24f * aspect : 1.6f * math.sqrt(aspect);
        static float LubeCrest(float aspect) => 0.88f * math.pow(aspect, 1f / 6f);

        [Test, Category("LongRun")]
        public void More_friction_leaves_a_steeper_heap_and_none_leaves_a_puddle()
        {
            const int radius = 10;
            Heap water = Collapsed(0f, radius, 1f, 0.75f), weak = Collapsed(0.3f, radius, 1f, 0.75f), strong = Collapsed(1f, radius, 1f, 0.75f);
            Assert.That(water.Crest, Is.LessThan(4f));
            Assert.That(weak.Crest, Is.InRange(water.Crest + 2f, strong.Crest - 1f));
            Assert.That(strong.RunOut, Is.LessThan(weak.RunOut));
            Assert.That(weak.Slope, Is.InRange(9f, 18f));
            Assert.That(strong.Slope, Is.InRange(18f, 30f));
        }

        // Everything that acts as a pressure has to be one in Pa.
        [Category("LongRun")]
        [TestCase(Spacing, 120f, Category = "GpuOnly")]
        [TestCase(0.05f, 60f)]
        public void A_heap_has_the_same_slope_at_every_spacing_and_step(float spacing, float stepRate)
        {
            const int radius = 10;
            float seconds = 0.75f * math.sqrt(spacing / Spacing);
            Assert.That(Collapsed(0.6f, radius, 1f, seconds, spacing, stepRate).Slope,
                Is.EqualTo(Collapsed(0.6f, radius, 1f, 0.75f).Slope).Within(5f));
        }

        [Category("GpuOnly")]
        [TestCase(32, 1f, Spacing, 60f)]
        [TestCase(32, 1f, Spacing, 120f)]
        [TestCase(32, 1f, Spacing, 240f)]
        [TestCase(32, 1f, 0.05f, 60f)]
        [TestCase(24, 2f, Spacing, 60f)]
        public void Columns_collapse_as_measured(int radius, float aspect, float spacing, float stepRate)
        {
            Heap heap = Collapsed(0.6f, radius, aspect, 2f * math.sqrt(spacing / Spacing), spacing, stepRate);
            TestContext.Out.WriteLine($"Lube: run-out {LubeRunOut(aspect):0.00}, crest {LubeCrest(aspect) * radius:0.0} d");
            Assert.That(heap.RunOut / LubeRunOut(aspect), Is.InRange(0.6f, 1.3f));
            Assert.That(heap.Crest / (LubeCrest(aspect) * radius), Is.InRange(0.75f, 1.25f));
        }

        [Test, Category("LongRun")]
        public void A_heap_sleeps_within_three_seconds_and_stays_as_it_is()
        {
            const int radius = 8;
            using (TestFluid fluid = Column(Sand(0.6f), radius, 1f, room: 2f))
            {
                fluid.Input.settings.sleepSpeed = 0.03f;
                fluid.Step(180);
                ParticleState asleep = fluid.Read();
                var heap = new Heap(fluid, radius);
                TestContext.Out.WriteLine(heap);
                Assert.That(heap.Crest, Is.GreaterThan(0.75f * LubeCrest(1f) * radius), "d, not a puddle");
                Assert.That(asleep.velocities.Select(v => math.length(v.xyz)).Max(), Is.Zero);
                fluid.Step(60);
                TestFluid.AssertSame(fluid.Read(), asleep);
            }
        }

        // A column without confinement stands on a cohesion of ρ g h (1 − sin φ) / (2 cos φ) (Terzaghi 1943, by Rankine's states); one that is as
        // wide as high on a rough floor on less.
        [TestCase(1f, true)]
        [TestCase(0f, false)]
        [Category("LongRun")]
        public void Damp_sand_stands_as_high_as_its_cohesion_allows(float part, bool stands)
        {
            const int radius = 10;
            const float friction = 0.6f;
            float angle = math.atan(friction), height = radius * Spacing;
            float needed = 1000f * 9.81f * height * (1f - math.sin(angle)) / (2f * math.cos(angle));
            using (TestFluid fluid = Column(Sand(friction, part * needed), radius, 1f, room: 2f))
            {
                float crest = new Heap(fluid.Step(45), radius).Crest;
                TestContext.Out.WriteLine($"cohesion {part * needed:0} Pa: crest {crest:0.0} of {radius} d");
                Assert.That(crest, stands ? Is.GreaterThan(0.95f * radius) : Is.LessThan(0.9f * radius));
            }
        }

        // Walls carry part of what lies between them (Janssen 1895): less than theirs could, since grains that do not move need no friction where
        // the pressure alone holds them.
        [Test, Category("LongRun")]
        public void Walls_carry_part_of_what_a_silo_holds()
        {
            float rough = FloorPressure(1f), smooth = FloorPressure(0f);
            TestContext.Out.WriteLine($"pressure at the floor, of the weight above: {rough:0.00} with rough walls, {smooth:0.00} with smooth ones");
            Assert.That(smooth, Is.InRange(0.85f, 1.1f));
            Assert.That(rough, Is.LessThan(0.88f * smooth));
        }

        // Pressure at the floor over the weight above it.
        static float FloorPressure(float wallFriction)
        {
            const int side = 8, layers = 40;
            using (var fluid = new TestFluid(new float3(side, layers + 12, side) * Spacing, Spacing, side * layers * side, Settings))
            {
                fluid.Input.material = Sand(0.6f);
                fluid.Input.material.wallFriction = wallFriction;
                fluid.AddBlock(0f, new float3(side, layers, side) * Spacing).Step(60);
                float[] potential = GpuTest.Read<float>(fluid.Solver.Coarse.Cells.flowPotential, fluid.Solver.Coarse.Grid.Total);
                float cell = fluid.Solver.Coarse.Grid.CellSize.y;
                return potential.Max() / (9.81f * fluid.Input.timeStep * fluid.Input.timeStep / Spacing * (layers - 0.5f * cell));
            }
        }

        [Test]
        public void What_falls_freely_is_not_braked()
        {
            using (var fluid = new TestFluid(new float3(24, 100, 24) * Spacing, Spacing, 8 * 8 * 8, Settings))
            {
                fluid.Input.material = Sand(0.6f, 1000f);
                fluid.AddBlock(new float3(8, 90, 8) * Spacing, 8f * Spacing).Step(20);
                float3 mean = fluid.Read().velocities.Select(v => v.xyz).Aggregate((a, b) => a + b) / (8 * 8 * 8) * Spacing;
                Assert.That(mean.y, Is.EqualTo(-9.81f * 20f / 60f).Within(0.005f * 9.81f));
                Assert.That(math.length(mean.xz), Is.LessThan(1e-3f));
            }
        }

        [Test]
        public void Friction_within_a_block_ends_its_shear_and_keeps_its_momentum()
        {
            using (var fluid = new TestFluid(new float3(48, 24, 24) * Spacing, Spacing, 12 * 12 * 12, Settings))
            {
                fluid.Input.gravity = 0f;
                fluid.Input.material = Sand(0.6f, 5000f);
                ParticleState block = ParticleState.Lattice(0f, new float3(16.5f, 6.5f, 6.5f), 12, 0.02f);
                fluid.Add(block.positions.Select(p => p.xyz * Spacing).ToArray(), p => new float3(p.y > 12f * Spacing ? 0.3f : 0.1f, 0f, 0f));
                float Shear() => fluid.Read().velocities.Zip(fluid.Read().positions, (v, p) => p.y > 12f ? v.x : -v.x).Average() * Spacing;
                float before = Shear();
                fluid.Step(10);
                float mean = fluid.Read().velocities.Average(v => v.x) * Spacing, after = Shear();
                TestContext.Out.WriteLine($"difference {2f * before:0.000} to {2f * after:0.000} m/s, mean 0.200 to {mean:0.0000} m/s");
                Assert.That(math.abs(after), Is.LessThan(0.25f * before));
                Assert.That(mean, Is.EqualTo(0.2f).Within(0.004f));
            }
        }

        // A plate that leans by 20 degrees, below the friction angle, under a block.
        [TestCase(1f, true)]
        [TestCase(0f, false)]
        [Category("LongRun")]
        public void Sand_rests_on_a_collider_by_its_friction(float friction, bool rests)
        {
            var box = new float3(64f, 40f, 16f);
            quaternion turn = quaternion.RotateZ(math.radians(20f));
            float3 foot = new float3(0f, 2f, 8f), normal = math.mul(turn, math.up());
            using (var fluid = new TestFluid(box * Spacing, Spacing, 4000, Settings))
            {
                fluid.Input.material = Sand(0.6f);
                fluid.Input.material.wallFriction = 0f;
                ColliderMotion plate = ColliderTests.Still(ColliderShape.Plane, 0f, foot, turn);
                plate.friction = friction;
                ColliderTests.Use(fluid, plate);
                fluid.Add(ParticleState.Lattice(0f, 1f, new int3(63, 39, 15), 0.02f).positions.Select(p => p.xyz)
                    .Where(p => p.x > 24f && p.x < 44f && math.dot(p - foot, normal) > 0.5f && math.dot(p - foot, normal) < 7f)
                    .Select(p => p * Spacing).ToArray());
                float before = fluid.Read().positions.Average(p => p.x);
                float moved = before - fluid.Step(40).Read().positions.Average(p => p.x);
                TestContext.Out.WriteLine($"{fluid.Added} grains moved {moved:0.00} d down");
                Assert.That(moved, rests ? Is.LessThan(2f) : Is.GreaterThan(6f));
            }
        }

        // Two columns stand side by side; water runs out.
        [Test]
        public void Among_several_materials_grains_alone_have_friction()
        {
            var box = new float3(64f, 24f, 16f);
            using (var fluid = new TestFluid(box * Spacing, Spacing, 6000, Settings))
            {
                fluid.Input.material.wallFriction = 0f;
                fluid.Input.phases.Set(1, 1600f, 0f, friction: 31f, cohesion: 2000f);
                foreach (int phase in new[] { 0, 1 })
                    fluid.AddPhase(phase, ParticleState.Lattice(0f, new float3(phase * 52f + 0.5f, 0.5f, 0.5f), new int3(12, 12, 16), 0.02f)
                        .positions.Select(p => p.xyz));
                fluid.Step(14);
                ParticleState state = fluid.Read();
                uint[] phases = fluid.Phases();
                float Height(int phase) => state.positions.Where((p, i) => phases[i] == phase).Average(p => p.y);
                TestContext.Out.WriteLine($"mean heights of 6 d: water {Height(0):0.0} d, sand {Height(1):0.0} d");
                Assert.That(Height(0), Is.LessThan(4.5f));
                Assert.That(Height(1), Is.GreaterThan(5.7f));
            }
        }

        // Without friction, a column stands by its cohesion alone.
        [Test]
        public void Grains_among_as_much_water_have_no_cohesion([Values] bool isMixed)
        {
            using (var fluid = new TestFluid(new float3(40f, 24f, 12f) * Spacing, Spacing, 2000, Settings))
            {
                fluid.Input.material.wallFriction = 0f;
                fluid.Input.phases.Set(1, 1000f, 0f, cohesion: 3000f);
                bool IsSand(float3 p) => !isMixed || math.csum((int3)p) % 2 != 0;
                foreach (IGrouping<bool, float3> group in ParticleState.Lattice(0f, 0.5f, 12, 0.02f).positions.Select(p => p.xyz).GroupBy(IsSand)
                    .OrderBy(group => group.Key))
                    fluid.AddPhase(group.Key ? 1 : 0, group);
                float height = fluid.Step(14).Read().positions.Average(p => p.y);
                TestContext.Out.WriteLine($"mean height {height:0.0} d of 6");
                Assert.That(height, isMixed ? Is.LessThan(3.2f) : Is.GreaterThan(5.7f), "water comes to 2.6 d");
            }
        }

        // Friction gives them 0.2 m/s in 0.03 s.
        [TestCase(1f, 0.2f)]
        [TestCase(0f, 0f)]
        public void Sand_on_a_plate_that_moves_goes_along_by_its_friction(float friction, float expected)
        {
            const float speed = 0.2f;
            using (var fluid = new TestFluid(new float3(64f, 20f, 16f) * Spacing, Spacing, 3000, Settings))
            {
                fluid.Input.material = Sand(0.6f);
                fluid.Input.material.wallFriction = 0f;
                ColliderMotion plate = ColliderTests.Still(ColliderShape.Plane, 0f, new float3(10f, 4f, 8f), quaternion.identity);
                plate.friction = friction;
                fluid.Add(ParticleState.Lattice(0f, 1f, new int3(63, 10, 15), 0.02f).positions.Select(p => p.xyz)
                    .Where(p => p.x > 20f && p.x < 40f && p.y > 4.4f).Select(p => p * Spacing).ToArray());
                for (int i = 0; i < 20; i++)
                {
                    plate.start = plate.end;
                    plate.end.position.x += speed / 60f / Spacing;
                    ColliderTests.Use(fluid, plate);
                    fluid.Step();
                }
                ParticleState state = fluid.Read();
                float mean = state.velocities.Average(v => v.x) * Spacing;
                TestContext.Out.WriteLine($"{state.Count} grains at {mean:0.000} m/s");
                Assert.That(mean, Is.EqualTo(expected).Within(0.25f * speed));
            }
        }
    }
}
