using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Terrains as colliders.</summary>
    public class FluidTerrainTests
    {
        GameObject thing;
        TerrainData data;

        [SetUp]
        public void MakeTerrain()
        {
            data = new TerrainData { heightmapResolution = 65 };
            data.size = new Vector3(128f, 20f, 64f);
            var heights = new float[65, 65];
            for (int z = 0; z < 65; z++)
                for (int x = 0; x < 65; x++)
                    heights[z, x] = x / 64f;
            data.SetHeights(0, 0, heights);
            thing = new GameObject("Hill");
            thing.SetActive(false);
            thing.transform.position = new Vector3(5f, 1f, -3f);
            thing.AddComponent<Terrain>().terrainData = data;
        }

        [TearDown]
        public void Destroy()
        {
            Object.DestroyImmediate(thing);
            Object.DestroyImmediate(data);
        }

        [Test]
        public void A_terrain_gives_its_heights_to_the_collider_beside_it()
        {
            FluidTerrain terrain = Add();
            var collider = thing.GetComponent<FluidCollider>();
            Assert.That(collider.Shape, Is.EqualTo(ColliderShape.HeightField));
            Assert.That(collider.TryDescribe(out ColliderMotion motion), Is.True);
            Assert.That((Vector3)motion.end.position, Is.EqualTo(new Vector3(69f, 11f, 29f)));
            Assert.That((Vector3)motion.size, Is.EqualTo(new Vector3(64f, 10f, 32f)));
            Assert.That(motion.minFraction, Is.EqualTo(1f / Mathf.Sqrt(1f + 20f / 128f * (20f / 128f))).Within(1e-3f));

            terrain.Part = Rect.MinMaxRect(0.5f, 0f, 1f, 0.25f);
            terrain.Refresh();
            Assert.That(collider.TryDescribe(out motion), Is.True);
            Assert.That((Vector3)motion.end.position, Is.EqualTo(new Vector3(5f + 96f, 1f + 15f, -3f + 8f)));
            Assert.That((Vector3)motion.size, Is.EqualTo(new Vector3(32f, 5f, 8f)));

            terrain.enabled = false;
            Assert.That(collider.Heights, Is.Null);
        }

        [Test]
        public void A_terrain_without_data_is_no_solid_of_another_shape()
        {
            thing.GetComponent<Terrain>().terrainData = null;
            LogAssert.Expect(LogType.Error, new Regex("FluidTerrain 'Hill' is not a collider: its Terrain has no terrain data"));
            thing.AddComponent<FluidTerrain>();
            thing.SetActive(true);
            Assert.That(thing.GetComponent<FluidCollider>().Describe(out _), Is.Not.Null, "no box of 1 m that was not chosen");
        }

        [Test]
        public void Changed_heights_count_after_a_refresh()
        {
            FluidTerrain terrain = Add();
            var collider = thing.GetComponent<FluidCollider>();
            HeightField before = collider.Heights;
            data.SetHeights(0, 0, new float[65, 65]);
            terrain.Refresh();
            Assert.That(collider.Heights, Is.Not.SameAs(before));
            Assert.That(collider.TryDescribe(out ColliderMotion motion), Is.True);
            Assert.That(motion.size.y, Is.Zero);
        }

        [Test]
        public void What_is_no_ground_is_said_by_name()
        {
            thing.GetComponent<Terrain>().terrainData = null;
            LogAssert.Expect(LogType.Error, new Regex("FluidTerrain 'Hill' is not a collider: its Terrain has no terrain data"));
            FluidTerrain terrain = Add();
            LogAssert.Expect(LogType.Warning, new Regex("FluidTerrain 'Hill': part .* does not lie within 0 to 1"));
            terrain.Part = new Rect(0f, 0f, 2f, 1f);
            Assert.That(terrain.Part, Is.EqualTo(new Rect(0f, 0f, 1f, 1f)));

            var large = new TerrainData { heightmapResolution = 4097 };
            thing.GetComponent<Terrain>().terrainData = large;
            LogAssert.Expect(LogType.Error, new Regex("it has 4097 x 4097 heights, and 2048 along a side can be taken. Set Part"));
            terrain.Refresh();
            terrain.Part = Rect.MinMaxRect(0.5f, 0.5f, 0.75f, 0.75f);
            terrain.Refresh();
            Assert.That(thing.GetComponent<FluidCollider>().Heights, Is.Not.Null);
            Object.DestroyImmediate(large);
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator Edited_heights_count_in_the_same_frame_where_they_are_of_the_part()
        {
            FluidTerrain terrain = Add();
            var collider = thing.GetComponent<FluidCollider>();
            terrain.Part = Rect.MinMaxRect(0f, 0f, 0.5f, 0.5f);
            terrain.Refresh();
            HeightField before = collider.Heights;
            data.SetHeights(40, 40, new float[8, 8]);
            yield return null;
            Assert.That(collider.Heights, Is.SameAs(before), "beside the part");
            data.SetHeights(30, 30, new float[8, 8]);
            data.SetHeights(0, 0, new float[33, 33]);
            yield return null;
            Assert.That(collider.Heights, Is.Not.SameAs(before));
            Assert.That(collider.TryDescribe(out ColliderMotion motion), Is.True);
            Assert.That(motion.size.y, Is.Zero);
            before = collider.Heights;
            terrain.enabled = false;
            data.SetHeights(0, 0, new float[33, 33]);
            yield return null;
            terrain.Refresh();
            Assert.That(collider.Heights, Is.Null, "none listens");
            terrain.enabled = true;
            data.SetHoles(3, 3, new bool[1, 1]);
            LogAssert.Expect(LogType.Warning, new Regex("FluidTerrain 'Hill': its Terrain has holes"));
            yield return null;
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Holes_are_said_once()
        {
            data.SetHoles(60, 60, new bool[1, 1]);
            LogAssert.Expect(LogType.Warning,
                new Regex("FluidTerrain 'Hill': its Terrain has holes, which are closed to water. Lower the ground there"));
            int said = 0;
            Application.LogCallback count = (text, trace, type) => said += text.Contains("holes") ? 1 : 0;
            Application.logMessageReceived += count;
            FluidTerrain terrain = Add();
            data.SetHoles(3, 3, new bool[1, 1]);
            terrain.Refresh();
            terrain.Refresh();
            Application.logMessageReceived -= count;
            Assert.That(said, Is.EqualTo(1));
        }

        FluidTerrain Add()
        {
            thing.AddComponent<FluidCollider>();
            var terrain = thing.AddComponent<FluidTerrain>();
            thing.SetActive(true);
            return terrain;
        }
    }
}
