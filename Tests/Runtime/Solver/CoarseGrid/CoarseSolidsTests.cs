using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The projection beside solids, of water that fills all that they leave: its equation and its displacements follow cell by cell
    /// from what is open, from the mean flow of the particles and from the potential. Lengths in d; in double precision.</summary>
    public class CoarseSolidsTests
    {
        const int Roomy = 6, Solid = 7;     // links of a cell
        const double MinPassage = 0.25, MinApart = 0.25;

        static readonly float3 Gravity = new float3(1.5f, -9.81f, 0.8f);        // m/s²
        static readonly double3 GravityStep = (double3)Gravity / SolverStages.Spacing * CoarseStages.TimeStep * CoarseStages.TimeStep;

        static ColliderMotion Moving(ColliderShape shape, float3 size, float3 center, float3 shift, float turn)
        {
            ColliderMotion solid = ColliderTests.Still(shape, size, center, quaternion.Euler(0.3f, 0.5f, 0.2f));
            solid.start = new RigidPose(center - shift, math.mul(quaternion.RotateY(-turn), solid.end.rotation));
            return solid;
        }

        // Cells of 4 d, and of 4.1 x 3.9 x 3.8 d: a ball, a box, a plate thinner than a cell, and a slab that leaves little of the lowest cells.
        [Test]
        public void The_equation_and_the_displacements_follow_from_what_is_open([Values] bool isCube)
        {
            float3 box = isCube ? 28f : new float3(29f, 27f, 26.5f);
            ColliderMotion[] solids =
            {
                Moving(ColliderShape.Sphere, 4.3f, new float3(9f, 9.5f, 10f), new float3(0.3f, -0.2f, 0.25f), 0f),
                Moving(ColliderShape.Box, new float3(4f, 5f, 3.5f), new float3(22f, 20f, 21f), new float3(-0.2f, 0.15f, 0.1f), 0.03f),
                Moving(ColliderShape.Box, new float3(0.8f, 6f, 5f), new float3(19f, 8f, 9f), 0f, 0f),
                ColliderTests.Still(ColliderShape.Box, new float3(7f, 3f, 6f), new float3(7f, 0.3f, 20f), quaternion.identity),
            };
            Follow(box, solids, (cells, beside) =>
            {
                int linked = beside.Count(cell => cells.Link(cell) != Roomy), roomy = beside.Count(cell => cells.Volume(cell) >= 0.25);
                TestContext.Out.WriteLine($"{beside.Length} of {cells.total} cells beside solids, {linked} without room of their own, " +
                    $"{beside.Count(cells.HasSurface)} with a surface");
                Assert.That(new[] { linked, beside.Count(cells.HasSurface), roomy - beside.Count(cells.HasSurface) }, Is.All.GreaterThan(5));
            });
        }

        // A slot of one cell between two plates, and a cell with two stones at a slab, which has a side that is open but no one surface: its
        // center of what is open is off its own, and the distances of its eighths cancel.
        [Test]
        public void Beside_solids_without_one_surface_water_is_stopped_side_by_side()
        {
            ColliderMotion[] solids =
            {
                ColliderTests.Still(ColliderShape.Box, new float3(0.8f, 8f, 8f), new float3(4f, 10f, 10f), quaternion.identity),
                ColliderTests.Still(ColliderShape.Box, new float3(0.8f, 8f, 8f), new float3(8f, 10f, 10f), quaternion.identity),
                ColliderTests.Still(ColliderShape.Box, new float3(4f, 20f, 20f), new float3(19.5f, 10f, 10f), quaternion.identity),
                ColliderTests.Still(ColliderShape.Sphere, 0.5f, new float3(13f, 11f, 9f), quaternion.identity),
                ColliderTests.Still(ColliderShape.Sphere, 0.5f, new float3(13f, 9f, 11f), quaternion.identity),
            };
            Follow(20f, solids, (cells, beside) =>
            {
                int[] bare = beside.Where(cell => cells.Volume(cell) >= 0.25 && !cells.HasSurface(cell) && cells.potential[cell] > 0.0).ToArray();
                int slots = bare.Count(cell => cells.Face(cell, 0, false) == 0.0 && cells.Face(cell, 0, true) == 0.0);
                int stones = bare.Count(cell => math.length(cells.CenterOf(cell)) > 0.015);
                TestContext.Out.WriteLine($"under pressure without a surface: {bare.Length} cells, {slots} of the slot, {stones} with stones");
                Assert.That((slots > 3, stones > 0), Is.EqualTo((true, true)));
            });
        }

        static void Follow(float3 box, ColliderMotion[] solids, Action<Cells, int[]> check)
        {
            ParticleState state = Water(box, solids);
            using (var stages = new CoarseStages(state, Gravity, solids: solids))
            {
                stages.ProjectBesideSolids();
                var cells = new Cells(stages, state);
                int[] beside = Enumerable.Range(0, cells.total)
                    .Where(cell => cells.active[cell] && !cells.IsClear(cell) && cells.IsKnown(cell)).ToArray();
                check(cells, beside);

                float[] source = stages.Source;
                Compare.Scalars("source", beside.Length, k => source[beside[k]], k => -cells.Divergence(beside[k]), k => 1e-3);
                int[] water = beside.Where(cell => cells.Volume(cell) >= 0.25).ToArray();
                float4[] displacements = stages.Displacements;
                double largest = cells.potential.Max() / math.cmin(cells.size);
                Compare.Vectors("displacements", water.Length, k => displacements[water[k]].xyz, k => cells.Displacement(water[k]),
                    k => 1e-3 + 1e-5 * largest);
            }
        }

        // As dense as at rest but for a twentieth, so that it is under no pressure of its own; with a flow that varies.
        static ParticleState Water(float3 box, ColliderMotion[] solids)
        {
            float3 cell = box / (float3)new CoarseGrid(box, 4f).Counts;
            var random = new Unity.Mathematics.Random(41u);
            float3 Velocity(float3 p)
                => 30f * new float3(math.sin(0.4f * p.y + 0.3f * p.x), math.cos(0.3f * p.x) - 0.5f, math.sin(0.5f * p.x + 0.2f * p.z));
            bool IsClear(float3 p)
            {
                float3 inCell = math.frac(p / cell);
                return math.all(inCell > 1e-3f) && math.all(inCell < 1f - 1e-3f);
            }
            float3[] points = Enumerable.Range(0, (int)(0.95f * box.x * box.y * box.z)).Select(_ => random.NextFloat3(0.5f, box - 0.5f))
                .Where(p => solids.All(solid => Reference.Shapes.Distance(solid, p) > 0.4)
                    && IsClear(p) && IsClear((float3)CoarseStages.AlongFlowOf(p, Velocity(p), box, Gravity))).ToArray();
            return new ParticleState(box, points).With(Velocity);
        }

        /// <summary>The coarse grid's cells as the device has what is open of them.</summary>
        sealed class Cells
        {
            public readonly int total;
            public readonly double3 size;
            public readonly bool[] active;
            public readonly double[] potential;

            readonly int3 counts;
            readonly uint2[] open;
            readonly uint4[] centers;
            readonly float4[] solidFlow;
            readonly double3[] flow;

            public Cells(CoarseStages stages, ParticleState state)
            {
                CoarseColliders colliders = stages.Correction.Colliders;
                (counts, total, size) = (stages.Grid.Counts, stages.Grid.Total, stages.Grid.CellSize);
                open = GpuTest.Read<uint2>(colliders.Open, total);
                centers = GpuTest.Read<uint4>(colliders.Centers, total);
                solidFlow = GpuTest.Read<float4>(colliders.Flow, total);
                active = stages.Fill.Select(fill => fill > 0f).ToArray();
                potential = stages.FlowPotential.Select(p => (double)p).ToArray();
                // A particle's flow counts in the cell where it leads; where a solid fills that, in the one where it is.
                var sums = new double3[total];
                var numbers = new int[total];
                double3[] along = stages.AlongFlow;
                for (int i = 0; i < state.Count; i++)
                {
                    int cell = CellOf(along[i]);
                    cell = RoomOf(Link(cell) == Solid ? CellOf((double3)state.positions[i].xyz) : cell);
                    sums[cell] += (double3)state.velocities[i].xyz * CoarseStages.TimeStep;
                    numbers[cell]++;
                }
                flow = sums.Select((sum, cell) => sum / Math.Max(numbers[cell], 1) + GravityStep).ToArray();
            }

            public bool IsClear(int cell) => (open[cell].y >> 24 & 1u) != 0;

            public bool HasSurface(int cell) => open[cell].y >> 25 != 0;

            public int Link(int cell) => (int)(open[cell].y >> 21 & 7u);

            public double Volume(int cell) => (open[cell].y & 4095u) / 4095.0;

            /// <summary>Whether each side is closed or leads to water: no free surface is near.</summary>
            public bool IsKnown(int cell)
            {
                for (int axis = 0; axis < 3; axis++)
                    foreach (bool isNext in new[] { false, true })
                        if (Beside(cell, axis, isNext) is int beyond && beyond >= 0 && !active[beyond] && Face(cell, axis, isNext) > 0.0)
                            return false;
                return true;
            }

            int CellOf(double3 p)
            {
                int3 at = math.clamp((int3)math.floor(p / size), 0, counts - 1);
                return (at.z * counts.y + at.y) * counts.x + at.x;
            }

            int Stride(int axis) => axis == 0 ? 1 : axis == 1 ? counts.x : counts.x * counts.y;

            int Beside(int cell, int axis, bool isNext)
            {
                int at = cell / Stride(axis) % counts[axis] + (isNext ? 1 : -1);
                return at < 0 || at >= counts[axis] ? -1 : cell + (isNext ? Stride(axis) : -Stride(axis));
            }

            /// <summary>Open fraction of a cell's side; 0 at the domain's wall.</summary>
            public double Face(int cell, int axis, bool isNext)
            {
                int beyond = Beside(cell, axis, isNext);
                return beyond < 0 ? 0.0 : (open[isNext ? beyond : cell].x >> 10 * axis & 1023u) / 1023.0;
            }

            // From the center of a cell or face, in sides of the cell.
            static double3 Center(uint packed) => (new double3(packed & 1023u, packed >> 10 & 1023u, packed >> 20 & 1023u) - 511.0) / 1022.0;

            /// <summary>Center of what is open of a cell, from the cell's own, in its sides.</summary>
            public double3 CenterOf(int cell) => Center(centers[cell].x);

            // The cell whose water fills one: itself, or where it has no room the one that it is linked to.
            int RoomOf(int cell) => Link(cell) >= Roomy ? cell : Beside(cell, Link(cell) / 2, Link(cell) % 2 != 0);

            bool IsNeighborWater(int beyond, double face) => beyond >= 0 && face > 0.0 && Link(beyond) == Roomy && active[beyond];

            // By which a component of the flow grows over a side of the cell, between the centers of what is open of its neighbors.
            double Slope(int cell, int axis, int across)
            {
                int next = Beside(cell, across, true), before = Beside(cell, across, false);
                next = IsNeighborWater(next, Face(cell, across, true)) ? next : cell;
                before = IsNeighborWater(before, Face(cell, across, false)) ? before : cell;
                double at = Center(centers[next].x)[across] + (next != cell ? 1.0 : 0.0);
                double from = Center(centers[before].x)[across] - (before != cell ? 1.0 : 0.0);
                return (flow[next][axis] - flow[before][axis]) / Math.Max(at - from, MinApart);
            }

            // Flow along an axis at a point across it, linear from the center of the water's open part.
            double FlowAt(int cell, int axis, double3 point)
            {
                int room = RoomOf(cell);
                if (room != cell)
                    point[Link(cell) / 2] -= Link(cell) % 2 != 0 ? 1.0 : -1.0;
                double3 away = point - Center(centers[room].x);
                return flow[room][axis]
                    + Enumerable.Range(0, 3).Where(across => across != axis).Sum(across => away[across] * Slope(room, axis, across));
            }

            /// <summary>Divergence of the flow: through the open part of each side as the water of both cells, through the rest as the
            /// solid.</summary>
            public double Divergence(int cell)
            {
                double sum = 0.0;
                for (int axis = 0; axis < 3; axis++)
                    foreach (bool isNext in new[] { false, true })
                    {
                        int beyond = Beside(cell, axis, isNext);
                        if (beyond < 0)
                            continue;
                        int upper = isNext ? beyond : cell;
                        double sign = isNext ? 1.0 : -1.0, face = Face(cell, axis, isNext);
                        double3 point = Center(axis == 0 ? centers[upper].y : axis == 1 ? centers[upper].z : centers[upper].w), step = default;
                        step[axis] = sign;
                        double through = FlowAt(cell, axis, point + 0.5 * step);
                        if (active[beyond])
                            through = 0.5 * (through + FlowAt(beyond, axis, point - 0.5 * step));
                        sum += sign * (face * through + (1.0 - face) * solidFlow[upper][axis]) / size[axis];
                    }
                return sum;
            }

            // By which the flow of a cell is stopped at a side that is closed: what goes into a wall, or off it where nothing holds it there.
            double Stop(int cell, int axis, bool isNext, double openOpposite)
            {
                int beyond = Beside(cell, axis, isNext), opposite = Beside(cell, axis, !isNext);
                double outward = isNext ? 1.0 : -1.0;
                double wall = beyond < 0 ? 0.0 : solidFlow[isNext ? beyond : cell][axis];
                double own = outward * (flow[cell][axis] - wall);       // into it
                double change = opposite >= 0 && active[opposite] ? 0.5 * openOpposite * outward * (flow[cell][axis] - flow[opposite][axis]) : 0.0;
                // At a solid's surface the divergence has stopped what goes into it; there gravity's part is taken.
                double into = HasSurface(cell) ? outward * GravityStep[axis]
                    : Math.Min(Math.Max(own + change, Math.Min(own, 0.0)), Math.Max(own, 0.0));
                // What is under pressure comes off no solid, nor does gravity pull it off the domain's wall.
                double hold = potential[cell] <= 0.0 ? 0.0 : beyond >= 0 ? 100.0 : Math.Max(-outward * GravityStep[axis], 0.0);
                return outward * Math.Min(-into, hold);
            }

            /// <summary>Displacement at a cell's center by the potential and what solids stop.</summary>
            public double3 Displacement(int cell)
            {
                double3 result = default, whole = default;
                for (int axis = 0; axis < 3; axis++)
                {
                    double low = Face(cell, axis, false), high = Face(cell, axis, true), widest = Math.Max(Math.Max(low, high), MinPassage);
                    (low, high) = (low / widest, high / widest);
                    int before = Beside(cell, axis, false), next = Beside(cell, axis, true);
                    double fromLow = before < 0 ? 0.0 : (potential[before] - potential[cell]) / size[axis];
                    double fromHigh = next < 0 ? 0.0 : (potential[cell] - potential[next]) / size[axis];
                    double stopLow = Stop(cell, axis, false, high), stopHigh = Stop(cell, axis, true, low);
                    result[axis] = 0.5 * (stopLow + low * (fromLow - stopLow) + stopHigh + high * (fromHigh - stopHigh));
                    double lowAll = high > 0.0 ? fromHigh : stopLow, highAll = low > 0.0 ? fromLow : stopHigh;
                    whole[axis] = 0.5 * (lowAll + low * (fromLow - lowAll) + highAll + high * (fromHigh - highAll));
                }
                // Along the way out of the solid all of the water gets what the open faces do.
                double3 normal = Center(centers[cell].x);
                if (HasSurface(cell) && math.dot(normal, normal) > 1e-4)
                    result += normal * (math.dot(normal, whole - result) / math.dot(normal, normal));
                return result;
            }
        }
    }
}
