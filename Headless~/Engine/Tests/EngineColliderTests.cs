using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Colliders are found by queries, where the physics knows them to be.</summary>
    public class EngineColliderTests : EngineFixture
    {
        readonly Collider[] found = new Collider[8];

        [Test]
        public void A_turned_box_meets_what_its_corner_reaches_and_no_more()
        {
            BoxCollider box = At<BoxCollider>(new Vector3(1.15f, 0f, 0f));
            Assert.That(Count(), Is.Zero, "0.5 and 0.5 do not reach over 1.15");
            box.transform.rotation = Quaternion.Euler(0f, 45f, 0f);
            Physics.SyncTransforms();
            Assert.That(Count(), Is.EqualTo(1), "half its diagonal does");
            Assert.That(Count(Quaternion.Euler(0f, 45f, 0f), 0.3f), Is.Zero);
        }

        // By 0.15 along x and y each: 0.21 from the box's edge.
        [Test]
        public void A_ball_and_a_capsule_are_round()
        {
            At<SphereCollider>(new Vector3(0.65f, 0.65f, 0f)).radius = 0.2f;
            CapsuleCollider capsule = At<CapsuleCollider>(new Vector3(-0.65f, 0.65f, 0f));
            capsule.radius = 0.2f;
            capsule.direction = 2;
            Assert.That(Count(), Is.Zero);
            capsule.radius = 0.22f;
            Assert.That(Count(), Is.EqualTo(1));
            capsule.transform.localScale = new Vector3(0.5f, 0.8f, 5f);
            Physics.SyncTransforms();
            Assert.That(Count(), Is.Zero, "its radius goes by the larger scale across");
        }

        [Test]
        public void Layers_triggers_and_what_is_off_are_told_apart()
        {
            BoxCollider box = At<BoxCollider>(Vector3.zero);
            box.gameObject.layer = 5;
            Assert.That(Count(mask: 1 << 5), Is.EqualTo(1));
            Assert.That(Count(mask: 1 << 4), Is.Zero);
            box.isTrigger = true;
            Assert.That(Count(mask: 1 << 5), Is.Zero);
            Assert.That(Physics.OverlapBoxNonAlloc(Vector3.zero, Vector3.one, found, Quaternion.identity, ~0,
                QueryTriggerInteraction.UseGlobal), Is.EqualTo(1));
            box.isTrigger = false;
            box.enabled = false;
            Assert.That(Count(), Is.Zero);
            box.enabled = true;
            box.gameObject.SetActive(false);
            Assert.That(Count(), Is.Zero);
            Object.DestroyImmediate(box.gameObject);
            Assert.That(Count(), Is.Zero);
        }

        [Test]
        public void What_was_moved_is_found_there_after_the_next_step_of_the_physics()
        {
            BoxCollider box = At<BoxCollider>(Vector3.zero);
            box.transform.position = new Vector3(10f, 0f, 0f);
            Assert.That(Count(), Is.EqualTo(1), "transforms are not looked at between");
            PlayerLoop.Frame(0.02f);
            Assert.That(Count(), Is.Zero);
        }

        [Test]
        public void What_does_not_fit_into_the_results_is_left_out()
        {
            for (int i = 0; i < 10; i++)
                At<SphereCollider>(Vector3.zero);
            Assert.That(Count(), Is.EqualTo(8));
        }

        [Test]
        public void The_body_of_a_collider_is_on_it_or_above()
        {
            Rigidbody body = new GameObject("Body").AddComponent<Rigidbody>();
            BoxCollider box = At<BoxCollider>(Vector3.zero);
            Assert.That(box.attachedRigidbody == null);
            box.transform.SetParent(body.transform);
            Assert.That(box.attachedRigidbody, Is.SameAs(body));
        }

        [Test]
        public void A_terrain_is_met_at_its_ground_and_not_below_it()
        {
            var data = new TerrainData { heightmapResolution = 33 };
            data.size = new Vector3(4f, 1f, 4f);
            var heights = new float[33, 33];
            for (int z = 0; z < 33; z++)
                for (int x = 0; x < 33; x++)
                    heights[z, x] = x < 16 ? 0f : 0.5f;
            data.SetHeights(0, 0, heights);
            var terrain = At<TerrainCollider>(new Vector3(-3f, -0.2f, -2f));
            Assert.That(Count(), Is.Zero, "without data");
            terrain.terrainData = data;
            Assert.That(Count(), Is.EqualTo(1), "0.3 m up");
            Move(terrain, new Vector3(-3f, -1.2f, -2f));
            Assert.That(Count(), Is.Zero, "the ground is below");
            Move(terrain, new Vector3(-3f, 0.2f, -2f));
            Assert.That(Count(), Is.Zero, "the ground is above");
            Move(terrain, new Vector3(-1f, 0.2f, -2f));
            Assert.That(Count(), Is.EqualTo(1), "over its lower half");
            Move(terrain, new Vector3(-4.6f, -0.2f, -2f));
            Assert.That(Count(), Is.Zero, "beside it");
            Object.DestroyImmediate(data);
        }

        static void Move(Collider collider, Vector3 position)
        {
            collider.transform.position = position;
            Physics.SyncTransforms();
        }

        [Test]
        public void Changed_holes_of_a_terrain_are_told()
        {
            var data = new TerrainData { heightmapResolution = 33 };
            var told = new System.Collections.Generic.List<string>();
            new GameObject("Hill").AddComponent<Terrain>().terrainData = data;
            TerrainCallbacks.TextureChangedCallback listen = (terrain, texture, region, synched) =>
                told.Add($"{terrain.name} {texture} {region.x} {region.y} {region.width} {region.height} {synched}");
            TerrainCallbacks.textureChanged += listen;
            data.SetHoles(3, 5, new bool[2, 1]);
            TerrainCallbacks.textureChanged -= listen;
            data.SetHoles(3, 5, new bool[2, 1]);
            Assert.That(told, Is.EqualTo(new[] { $"Hill {TerrainData.HolesTextureName} 3 5 1 2 True" }));
            Object.DestroyImmediate(data);
        }

        int Count(Quaternion? rotation = null, float half = 0.5f, int mask = ~0) =>
            Physics.OverlapBoxNonAlloc(Vector3.zero, Vector3.one * half, found, rotation ?? Quaternion.identity, mask,
            QueryTriggerInteraction.Ignore);

        static T At<T>(Vector3 position) where T : Collider
        {
            var thing = new GameObject(typeof(T).Name);
            thing.transform.position = position;
            return thing.AddComponent<T>();
        }
    }
}
