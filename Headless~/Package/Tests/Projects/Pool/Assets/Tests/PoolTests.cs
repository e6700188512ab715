using System.Collections;
using NUnit.Framework;
using Rill;
using Rill.Testing;
using UnityEngine;
using UnityEngine.TestTools;

public class PoolTests
{
    FluidSimulation fluid;

    [TearDown]
    public void Drain() => Object.DestroyImmediate(fluid.gameObject);

    [UnityTest]
    public IEnumerator A_pool_keeps_its_water()
    {
        fluid = Pool.Make(capacity: 1000);
        for (int frame = 0; frame < 3; frame++)
            yield return null;
        FluidAssert.NothingLost(fluid);
        FluidAssert.NothingEscaped(fluid);
    }

    // 0.075 m³ between four walls of Unity's, in a box of water that reaches far beyond them. A crate falls onto the floor of the pool.
    [UnityTest]
    public IEnumerator Walls_of_Unitys_colliders_hold_the_water()
    {
        var pool = new GameObject("Pool");
        pool.SetActive(false);
        fluid = pool.AddComponent<FluidSimulation>();
        fluid.Configure(new Vector3(1.2f, 0.8f, 1.2f), 0.05f, 1000);
        pool.AddComponent<FluidPhysicsColliders>().ColliderLayers = 1 << 8;
        Part("Water", new Vector3(0f, -0.25f, 0f)).AddComponent<FluidVolume>().Size = new Vector3(0.5f, 0.3f, 0.5f);
        var detector = Part("Detector", Vector3.zero).AddComponent<FluidDetector>();
        detector.Size = new Vector3(0.5f, 0.8f, 0.5f);
        foreach (Vector3 side in new[] { Vector3.right, Vector3.left, Vector3.forward, Vector3.back })
            Wall(side * 0.3f, new Vector3(side.x != 0f ? 0.1f : 0.7f, 0.8f, side.x != 0f ? 0.7f : 0.1f));
        Wall(new Vector3(0f, -0.45f, 0f), new Vector3(1.2f, 0.1f, 1.2f));
        Rigidbody crate = Part("Crate", Vector3.zero).AddComponent<Rigidbody>();
        crate.gameObject.AddComponent<BoxCollider>().size = Vector3.one * 0.2f;
        pool.SetActive(true);
        for (int frame = 0; frame < 90; frame++)
            yield return null;
        Assert.That(fluid.FluidTime, Is.GreaterThan(0.5));
        FluidAssert.NothingLost(fluid);
        FluidAssert.VolumeIn(detector, 0.07f, 0.08f);
        Assert.That(crate.position.y, Is.EqualTo(-0.3f).Within(0.01f));
    }

    GameObject Part(string name, Vector3 position)
    {
        var part = new GameObject(name);
        part.transform.SetParent(fluid.transform, false);
        part.transform.localPosition = position;
        return part;
    }

    void Wall(Vector3 position, Vector3 size)
    {
        GameObject wall = Part("Wall", position);
        wall.layer = 8;
        wall.AddComponent<BoxCollider>().size = size;
    }

    [UnityTest]
    public IEnumerator A_pool_too_small_for_its_water_loses_some()
    {
        fluid = Pool.Make(capacity: 100);
        LogAssert.ignoreFailingMessages = true;
        for (int frame = 0; frame < 3; frame++)
            yield return null;
        FluidAssert.NothingLost(fluid);
    }
}
