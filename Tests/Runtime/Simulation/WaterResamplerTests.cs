using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Where the particles of another spacing lie and what they carry. Lengths in new spacings unless said otherwise.</summary>
    public class WaterResamplerTests
    {
        const float Jitter = 0.021f;

        static readonly float3[] Directions =
        {
            new float3(1f, 0f, 0f), new float3(-1f, 0f, 0f), new float3(0f, 1f, 0f), new float3(0f, -1f, 0f), new float3(0f, 0f, 1f),
            new float3(0f, 0f, -1f)
        };

        // A lattice of old particles in part of a box, old spacings.
        static float4[] Block(float3 low, float3 high)
        {
            var positions = new List<float4>();
            for (float z = low.z + 0.5f; z < high.z; z++)
                for (float y = low.y + 0.5f; y < high.y; y++)
                    for (float x = low.x + 0.5f; x < high.x; x++)
                        positions.Add(new float4(x, y, z, 0f));
            return positions.ToArray();
        }

        static WaterResampler Resampler(float4[] positions, float4[] velocities, uint[] tags, float ratio, float3 size, float3 down,
            ColliderSet colliders = null)
            => new WaterResampler(positions, velocities ?? new float4[positions.Length], tags, ratio, size, down, colliders ?? new ColliderSet());

        // Across gravity a box of 8.4 has 8 layers, 1.05 apart. Along it they lie 1/1.05² apart, so that each site stands for a cube of 1.
        [Test]
        public void Layers_begin_half_a_layer_from_the_floor_wherever_gravity_points([ValueSource(nameof(Directions))] float3 down)
        {
            const float Side = 8.4f, Layer = 0.90703f;
            int axis = down.x != 0f ? 0 : down.y != 0f ? 1 : 2;
            bool isAbove = math.csum(down) > 0f;
            float3 low = 0f, high = Side / 0.7f;        // old spacings: a box of 12, half full
            low[axis] = isAbove ? 6f : 0f;
            high[axis] = isAbove ? 12f : 6f;
            Resampler(Block(low, high), null, null, 0.7f, Side, down).Resample(out float4[] found, out _, out _);
            Assert.That(found, Has.Length.EqualTo((int)math.round(864 * 0.343f)));
            float[] heights = found.Select(p => isAbove ? Side - p[axis] : p[axis]).ToArray();
            int[] layers = heights.GroupBy(height => (int)(height / Layer)).OrderBy(layer => layer.Key).Select(layer => layer.Count()).ToArray();
            Assert.That(heights.Select(height => math.abs(height / Layer - 0.5f - (int)(height / Layer))).Max(), Is.LessThan(1.2f * Jitter));
            Assert.That(layers.Take(4), Is.All.EqualTo(64), "whole layers from wall to wall, to the edges and corners of the floor");
            Assert.That(layers.Length, Is.EqualTo(5));
            int[] sides = { (axis + 1) % 3, (axis + 2) % 3 };
            int atWalls = found.Where((p, i) => heights[i] > 4f * Layer).Count(p => sides.Any(side => math.abs(p[side] - 0.5f * Side) > 3f * 1.05f));
            Assert.That(atWalls, Is.GreaterThan(8), "of the 40 of the last layer, in which 28 of 64 sites lie at walls: as dense there");
            foreach (int across in sides)
                Assert.That(found.Select(p => math.abs(p[across] / 1.05f - 0.5f - (int)(p[across] / 1.05f))).Max(), Is.LessThan(Jitter));
        }

        [Test]
        public void Momentum_is_kept_to_rounding_though_velocities_differ_from_particle_to_particle([Values(0.6f, 1f, 1.7f)] float ratio)
        {
            float4[] positions = Block(new float3(2f, 0f, 1f), new float3(9f, 5f, 8f));
            var random = new Random(31u);
            float4[] velocities = positions.Select(p => new float4(random.NextFloat3(-3f, 5f), 0f)).ToArray();
            WaterResampler resampler = Resampler(positions, velocities, null, ratio, 12f * ratio, new float3(0f, -1f, 0f));
            resampler.Resample(out float4[] found, out float4[] moving, out _);
            Assert.That(found.Length, Is.EqualTo(resampler.Wanted).And.EqualTo((int)math.round(positions.Length * ratio * ratio * ratio)));
            double3 before = Mean(velocities) * ratio, after = Mean(moving);        // new spacings a second
            Assert.That(math.length(before), Is.GreaterThan(0.5));
            Assert.That(math.distance(after, before), Is.LessThan(1e-5 * math.length(before)));
        }

        static double3 Mean(float4[] velocities)
        {
            double3 sum = 0.0;
            foreach (float4 velocity in velocities)
                sum += (double3)velocity.xyz / velocities.Length;
            return sum;
        }

        // At most a tenth of it, of what lies far from the front.
        [Test]
        public void A_particle_moves_and_counts_as_the_old_ones_where_it_is([Values(0.6f, 1.7f)] float ratio)
        {
            float4[] positions = Block(0f, new float3(12f, 5f, 8f));
            float4[] velocities = positions.Select(p => new float4(p.x < 6f ? -2f : 3f, p.y, 0f, 0f)).ToArray();
            uint[] tags = positions.Select(p => p.x < 6f ? 1u << ParticleTags.PhaseShift : 5u << ParticleTags.PhaseShift).ToArray();
            Resampler(positions, velocities, tags, ratio, new float3(12f, 10f, 8f) * ratio, new float3(0f, -1f, 0f))
                .Resample(out float4[] found, out float4[] moving, out uint[] kinds);
            int sure = 0;
            for (int i = 0; i < found.Length; i++)
            {
                float x = found[i].x / ratio;       // old spacings
                if (math.abs(x - 6f) < 0.6f / math.min(ratio, 1f))
                    continue;
                Assert.That(kinds[i] >> ParticleTags.PhaseShift, Is.EqualTo(x < 6f ? 1u : 5u), $"at {x}");
                if (math.abs(x - 6f) < 4f)
                    continue;
                sure++;
                Assert.That(moving[i].x, Is.EqualTo((x < 6f ? -2f : 3f) * ratio).Within(0.1f), $"at {x}");
            }
            Assert.That(sure, Is.GreaterThan(20));
        }

        [Test]
        public void No_new_particle_touches_a_collider([Values(0.7f, 1.5f)] float ratio)
        {
            float3 center = new float3(6f, 3f, 6f);
            ColliderMotion ball = ColliderTests.Still(ColliderShape.Sphere, 2f, center, quaternion.identity);       // old spacings
            var colliders = new ColliderSet { Count = 1 };
            colliders.Items[0] = ball;
            float4[] positions = Block(0f, new float3(12f, 6f, 12f)).Where(p => math.distance(p.xyz, center) > 2.5f).ToArray();
            Resampler(positions, null, null, ratio, 12f * ratio, new float3(0f, -1f, 0f), colliders).Resample(out float4[] found, out _, out _);
            Assert.That(found.Min(p => math.distance(p.xyz, center * ratio) - 2f * ratio), Is.InRange(0.5f - 2f * Jitter, 1.2f), "contact offset");
            Assert.That(found.Length, Is.EqualTo((int)math.round(positions.Length * ratio * ratio * ratio)));
        }

        [Test]
        public void Old_particles_that_are_not_finite_are_left_out([Values(float.NaN, float.PositiveInfinity)] float bad)
        {
            float4[] positions = Block(0f, 5f), velocities = new float4[positions.Length];
            uint[] tags = Enumerable.Range(0, positions.Length).Select(i => (uint)i).ToArray();
            positions[7].y = bad;
            velocities[20].z = bad;
            WaterResampler resampler = Resampler(positions, velocities, tags, 1f, 8f, new float3(0f, -1f, 0f));
            resampler.Copy(out float4[] copied, out float4[] copiedVelocities, out uint[] copiedTags);
            Assert.That((resampler.Count, resampler.Wanted), Is.EqualTo((123, 123L)));
            Assert.That(copiedTags, Is.EqualTo(tags.Where(tag => tag != 7 && tag != 20)));
            resampler.Resample(out float4[] found, out float4[] moving, out _);
            foreach (float4[] all in new[] { copied, copiedVelocities, found, moving })
                Assert.That(all.Length == 123 && all.All(v => math.all(math.isfinite(v.xyz))));
        }
    }
}
