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
