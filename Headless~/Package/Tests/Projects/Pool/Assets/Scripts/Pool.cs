using Rill;
using UnityEngine;

/// <summary>A box of water, as a script of the game would make it.</summary>
public static class Pool
{
    public static FluidSimulation Make(int capacity)
    {
        var pool = new GameObject("Pool");
        pool.SetActive(false);
        var fluid = pool.AddComponent<FluidSimulation>();
        fluid.Configure(Vector3.one, 0.1f, capacity);
        pool.AddComponent<FluidVolume>().Size = new Vector3(0.6f, 0.6f, 0.6f);
        pool.SetActive(true);
        return fluid;
    }
}
