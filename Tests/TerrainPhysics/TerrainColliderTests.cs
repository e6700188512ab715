using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Terrain Colliders that a fluid takes by layer.</summary>
    public class TerrainColliderTests : PlayedFluidFixture
    {
        const int Layer = 8;

        readonly List<FluidPhysicsColliders> sources = new List<FluidPhysicsColliders>();
        GameObject hill;
        TerrainData data;
        TerrainCollider ground;

        // 128 x 20 x 64 m, rising along x.
        [SetUp]
        public void MakeHill()
        {
            data = new TerrainData { heightmapResolution = 65 };
            data.size = new Vector3(128f, 20f, 64f);
            var heights = new float[65, 65];
            for (int z = 0; z < 65; z++)
                for (int x = 0; x < 65; x++)
                    heights[z, x] = x / 64f;
            data.SetHeights(0, 0, heights);
            hill = new GameObject("Hill") { layer = Layer };
            made.Add(hill);
            hill.transform.position = new Vector3(5f, 1f, -3f);
            hill.AddComponent<Terrain>().terrainData = data;
            ground = hill.AddComponent<TerrainCollider>();
            ground.terrainData = data;
            UnityEngine.Physics.SyncTransforms();
        }

        [TearDown]
        public void DestroyData()
        {
            foreach (FluidPhysicsColliders source in sources)
            {
                source.ColliderLayers = 0;
                Gather(source);     // gives back what it had
            }
            sources.Clear();
            Object.DestroyImmediate(data);
        }

        [Test]
        public void A_Terrain_Collider_is_taken_as_the_ground_that_a_Fluid_Terrain_gives()
        {
            hill.transform.rotation = Quaternion.Euler(0f, 30f, 0f);
            hill.transform.localScale = 2f * Vector3.one;
            FluidPhysicsColliders colliders = Source("Pool");
            ColliderMotion byLayer = TheOnly(colliders);
            Assert.That(byLayer.shape, Is.EqualTo(ColliderShape.HeightField));
            Assert.That((Vector3)byLayer.end.position, Is.EqualTo(new Vector3(69f, 11f, 29f)));
            hill.AddComponent<FluidCollider>();
            hill.AddComponent<FluidTerrain>();
            Assert.That(hill.GetComponent<FluidCollider>().TryDescribe(out ColliderMotion own), Is.True);
            Assert.That(byLayer.end, Is.EqualTo(own.end));
            Assert.That((byLayer.size, byLayer.fieldUnit, byLayer.minFraction), Is.EqualTo((own.size, own.fieldUnit, own.minFraction)));
        }

        [Test]
        public void Beside_an_enabled_Fluid_Terrain_it_is_left_to_that()
        {
            FluidPhysicsColliders colliders = Source("Pool");
            var own = hill.AddComponent<FluidCollider>();
            var terrain = hill.AddComponent<FluidTerrain>();
            Assert.That(Gather(colliders), Is.Empty);
            terrain.enabled = own.enabled = false;
            Assert.That(TheOnly(colliders).shape, Is.EqualTo(ColliderShape.HeightField));
        }

        [Test]
        public void Edited_heights_and_a_change_of_size_or_data_count_at_once()
        {
            FluidPhysicsColliders colliders = Source("Pool");
            Texture before = TheOnly(colliders).field;
            Assert.That(TheOnly(colliders).field, Is.SameAs(before));
            data.SetHeights(3, 3, new float[8, 8]);
            ColliderMotion edited = TheOnly(colliders);
            Assert.That(edited.field, Is.Not.SameAs(before));
            data.size = new Vector3(128f, 10f, 64f);
            Assert.That(TheOnly(colliders).size.y, Is.EqualTo(5f));
            var other = new TerrainData { heightmapResolution = 33 };
            other.size = new Vector3(128f, 20f, 64f);
            ground.terrainData = other;
            hill.GetComponent<Terrain>().terrainData = other;
            Assert.That(TheOnly(colliders).size.y, Is.Zero, "flat");
            Assert.That(TerrainHeightsCache.Count, Is.EqualTo(1), "of the old data nothing is kept");
            Object.DestroyImmediate(other);
        }

        [Test]
        public void Holes_are_said_once_also_those_that_come_later()
        {
            FluidPhysicsColliders colliders = Source("Pool");
            TheOnly(colliders);
            data.SetHoles(60, 60, new bool[1, 1]);
            LogAssert.Expect(LogType.Warning, new Regex("FluidPhysicsColliders 'Pool', collider 'Hill': its Terrain has holes, which are closed"));
            for (int i = 0; i < 2; i++)
                TheOnly(colliders);
            var problems = new List<string>();
            ((IHasProblems)colliders).ListProblems(problems);
            Assert.That(problems.Count, Is.EqualTo(1));
            Assert.That(problems[0], Does.StartWith("The collider 'Hill': its Terrain has holes"));
            data.SetHoles(60, 60, new[,] { { true } });
            TheOnly(colliders);
            problems.Clear();
            ((IHasProblems)colliders).ListProblems(problems);
            Assert.That(problems, Is.Empty);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Fluids_share_the_heights_of_a_terrain_and_the_last_gives_them_back()
        {
            FluidPhysicsColliders first = Source("First"), second = Source("Second");
            Assert.That(TheOnly(first).field, Is.SameAs(TheOnly(second).field));
            Assert.That(TerrainHeightsCache.Count, Is.EqualTo(1));
            first.ColliderLayers = 0;
            Gather(first);
            Assert.That(TheOnly(second).field != null, "not destroyed");
            Texture field = TheOnly(second).field;
            hill.SetActive(false);
            Assert.That(Gather(second), Is.Empty);
            Assert.That(TerrainHeightsCache.Count, Is.Zero);
            Assert.That(field == null, "destroyed");
        }

        [Test]
        public void What_is_no_ground_is_said_by_name()
        {
            FluidPhysicsColliders colliders = Source("Pool");
            var large = new TerrainData { heightmapResolution = 4097 };
            large.size = data.size;
            ground.terrainData = large;
            LogAssert.Expect(LogType.Error, new Regex("FluidPhysicsColliders 'Pool' leaves out the collider 'Hill': it has 4097 x 4097 " +
                "heights, and 2048 along a side can be taken. Set Part of a Fluid Terrain on it"));
            List<IFluidCollider> taken = Gather(colliders);
            Assert.That(taken.Count, Is.EqualTo(1));
            Assert.That(taken[0].TryDescribe(out _), Is.False);
            ground.terrainData = null;
            Assert.That(taken[0].Describe(out _), Is.EqualTo("its Terrain Collider has no terrain data. Assign some."));
            Object.DestroyImmediate(large);
        }

        [UnityTest]
        public IEnumerator Water_lies_on_the_ground_and_follows_it_down()
        {
            hill.transform.position = new Vector3(-1f, -0.6f, -1f);
            data.size = new Vector3(2f, 1f, 2f);
            Level(0.5f);        // 0.1 m below the center of the box
            FluidDetector below = null;
            FluidSimulation fluid = Fluid("Pool", 0.6f * Vector3.one, 0.05f, 1000, Vector3.zero, pool =>
            {
                AddWater(pool, new Vector3(0.6f, 0.25f, 0.6f), new Vector3(0f, 0.05f, 0f));
                pool.gameObject.AddComponent<FluidPhysicsColliders>().ColliderLayers = 1 << Layer;
                below = new GameObject("Below").AddComponent<FluidDetector>();
                below.transform.SetParent(pool.transform, false);
                below.transform.localPosition = new Vector3(0f, -0.225f, 0f);
                below.Size = new Vector3(0.6f, 0.15f, 0.6f);
            });
            yield return Frames(30);
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(1));
            Assert.That(below.TryGetSample(out FluidDetectorSample sample), Is.True);
            Assert.That(sample.volume, Is.Zero, "below the ground");
            Level(0f);
            yield return Frames(30);
            Assert.That(below.TryGetSample(out sample), Is.True);
            Assert.That(sample.volume, Is.GreaterThan(0.02f), "m³ of 0.09");
        }

        void Level(float fraction)
        {
            var heights = new float[65, 65];
            for (int z = 0; z < 65; z++)
                for (int x = 0; x < 65; x++)
                    heights[z, x] = fraction;
            data.SetHeights(0, 0, heights);
        }

        // Inactive: no fluid runs, and the test asks instead.
        FluidPhysicsColliders Source(string name)
        {
            var pool = new GameObject(name);
            pool.SetActive(false);
            made.Add(pool);
            var colliders = pool.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = 1 << Layer;
            sources.Add(colliders);
            return colliders;
        }

        static List<IFluidCollider> Gather(FluidPhysicsColliders colliders)
            => ((IColliderSource)colliders).Gather(new Vector3(69f, 11f, 29f), Quaternion.identity, 40f * Vector3.one, 0.05f);

        static ColliderMotion TheOnly(FluidPhysicsColliders colliders)
        {
            List<IFluidCollider> taken = Gather(colliders);
            Assert.That(taken.Count, Is.EqualTo(1));
            Assert.That(taken[0].TryDescribe(out ColliderMotion motion), Is.True);
            return motion;
        }
    }
}
