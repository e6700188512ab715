using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Rill.Editor.Tests
{
    /// <summary>Slices and traced surfaces as pixels, of a field that is made up: a ball of radius 0.3 m away from the center.</summary>
    public class SdfPictureTests
    {
        static readonly float3 Center = new float3(0.1f, -0.1f, 0.05f);
        const float Radius = 0.3f;

        static SdfVolume Ball(out SdfBake bake)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.voxelSize = 0.05f;
            var grid = new SdfGrid(new Bounds(Vector3.zero, new Vector3(1f, 1.2f, 0.8f)), settings, false);
            var distances = new float[grid.VoxelCount];
            for (int i = 0; i < distances.Length; i++)
                distances[i] = math.distance(grid.Min
                    + grid.VoxelSize * (new float3(i % grid.Resolution.x, i / grid.Resolution.x % grid.Resolution.y,
                    i / grid.Resolution.x / grid.Resolution.y) + 0.5f), Center) - Radius;
            bake = new SdfBake("Ball", grid, distances, settings, MeshSdfSign.WindingNumber, 0);
            return SdfVolume.Of(bake);
        }

        static bool IsBlue(Color32 c) => c.b > c.r + 20;
        static bool IsOrange(Color32 c) => c.r > c.b + 15;

        [Test]
        public void Colors_tell_the_sign_of_the_smallest_distance_and_darken_to_the_ends()
        {
            Assert.That(IsBlue(DistanceColors.At(-1e-6f)) && IsOrange(DistanceColors.At(0f)));
            Assert.That(DistanceColors.At(-5f), Is.EqualTo(DistanceColors.At(-1f)));
            for (int sign = -1; sign <= 1; sign += 2)
                for (float fraction = 0.05f; fraction < 1f; fraction += 0.05f)
                    Assert.That(Brightness(DistanceColors.At(sign * (fraction + 0.05f))),
                        Is.LessThan(Brightness(DistanceColors.At(sign * fraction))), $"{sign * fraction}");
            foreach ((float fraction, Color32 color) in DistanceColors.Stops.Where(stop => stop.Fraction != 0f))
                Assert.That(DistanceColors.At(fraction), Is.EqualTo(color));
        }

        static int Brightness(Color32 c) => c.r + c.g + c.b;

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void A_slice_is_blue_inside_orange_outside_and_black_between(int axis)
        {
            SdfVolume volume = Ball(out _);
            SdfSlice view = SdfSlice.Across(axis);
            int layer = volume.Resolution[axis] / 2;
            Vector2Int size = view.SizeOf(volume, 120);
            Assert.That(Mathf.Max(size.x, size.y), Is.EqualTo(120));
            var pixels = new Color32[size.x * size.y];
            view.Paint(volume, layer, view.MaxDistance(volume, layer), size, pixels);

            int black = 0;
            Vector3 at = default;
            at[axis] = view.PositionOf(volume, layer);
            for (int i = 0; i < pixels.Length; i++)
            {
                at[view.Right] = volume.Bounds.min[view.Right] + (i % size.x + 0.5f) / size.x * volume.Bounds.size[view.Right];
                at[view.Up] = volume.Bounds.min[view.Up] + (i / size.x + 0.5f) / size.y * volume.Bounds.size[view.Up];
                float distance = math.distance(at, Center) - Radius;
                bool isBlack = pixels[i].Equals(DistanceColors.Zero);
                black += isBlack ? 1 : 0;
                if (math.abs(distance) > 0.03f)
                    Assert.That(!isBlack && (distance < 0f ? IsBlue(pixels[i]) : IsOrange(pixels[i])), $"pixel {i}, {distance} m: {pixels[i]}");
            }
            Assert.That(black, Is.GreaterThan(100), "the line");
        }

        [Test]
        public void Samples_are_those_of_the_asset_in_either_format()
        {
            SdfVolume volume = Ball(out SdfBake bake);
            SignedDistanceField field = SignedDistanceField.Create(bake);
            Assert.That(field.Texture.format, Is.EqualTo(TextureFormat.RHalf));
            SdfVolume stored = SdfVolume.Of(field, out string problem);
            Assert.That(problem, Is.Null);
            var random = new Random(4);
            for (int i = 0; i < 200; i++)
            {
                float3 at = random.NextFloat3(field.Bounds.min, field.Bounds.max);
                Assert.That(field.TrySample(at, out float expected));
                Assert.That(stored.Sample(at), Is.EqualTo(expected).Within(1e-6f));
                Assert.That(volume.Sample(at), Is.EqualTo(expected).Within(2f * bake.StorageError));
            }
            UnityEngine.Object.DestroyImmediate(field.Texture);
            Assert.That(SdfVolume.Of(field, out problem), Is.Null);
            Assert.That(problem, Does.Contain("has no distances"));
            UnityEngine.Object.DestroyImmediate(field);
        }

        [Test]
        public void Rays_stop_where_they_meet_the_ball_and_only_those_that_do()
        {
            SdfVolume volume = Ball(out _);
            var random = new Random(9);
            int hits = 0, misses = 0;
            for (int i = 0; i < 400; i++)
            {
                float3 along = random.NextFloat3Direction(), side = math.normalize(math.cross(along, random.NextFloat3Direction()));
                float off = random.NextFloat(0f, 0.45f);
                float3 from = Center + off * side - 3f * along;
                bool hit = SdfTrace.TryHit(volume, from, along, out float3 at);
                // A ray that only grazes may hit or miss, and blended voxels are a little off the ball.
                if (math.abs(off - Radius) < 0.02f)
                    continue;
                Assert.That(hit, Is.EqualTo(off < Radius), $"{off} m off the center");
                hits += hit ? 1 : 0;
                misses += hit ? 0 : 1;
                if (hit)
                    Assert.That(math.distance(at, from + (3f - math.sqrt(Radius * Radius - off * off)) * along), Is.LessThan(0.04f),
                        $"{off} m off the center");
            }
            Assert.That(hits > 100 && misses > 50);
        }

        [Test]
        public void A_traced_picture_shows_the_balls_disc_lit_from_above()
        {
            SdfVolume volume = Ball(out _);
            var size = new Vector2Int(80, 60);
            var pixels = new Color32[size.x * size.y];
            SdfTrace.Paint(volume, 0f, 0f, size, pixels);
            float pixel = volume.Bounds.size.magnitude / 60f;
            int shown = pixels.Count(p => !p.Equals(SdfTrace.Background));
            Assert.That(shown * pixel * pixel, Is.EqualTo(Math.PI * Radius * Radius).Within(0.05 * Math.PI * Radius * Radius), "its area");
            float3 center = (Center - (float3)volume.Bounds.center) / pixel + new float3(40f, 30f, 0f);
            int At(float up) => (int)(center.y + up * Radius / pixel) * size.x + (int)center.x;
            Assert.That(Brightness(pixels[At(0.7f)]), Is.GreaterThan(Brightness(pixels[At(-0.7f)]) + 100));

            SdfTrace.Paint(volume, 0f, 90f, size, pixels);
            Assert.That(pixels[(int)((Center.z - volume.Bounds.center.z) / pixel + 30f) * size.x + (int)center.x],
                Is.Not.EqualTo(SdfTrace.Background), "from above it lies at its x and z");
            Assert.Throws<ArgumentException>(() => SdfTrace.Paint(volume, 0f, 0f, size, new Color32[3]));
        }
    }
}
