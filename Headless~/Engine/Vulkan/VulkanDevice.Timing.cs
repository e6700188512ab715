using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>GPU time between two points of the stream.</summary>
    /// <remarks>
    /// Both stamps are taken when all work before them is done, so what lies between them is the time that the sampled work
    /// added to the stream: neighbors' work is not in it and the samples of a sequence add up.
    /// </remarks>
    sealed unsafe partial class VulkanDevice
    {
        const uint StampsPerPool = 1024;

        struct OpenSample { public string Name; public int Depth, Begin, End; }

        readonly List<VkQueryPool> stampPools = new();
        readonly List<OpenSample> samples = new();
        readonly Stack<int> openSamples = new();
        int stampCount;

        public bool Timing { get; set; }

        public void BeginSample(string name)
        {
            if (!Timing) { openSamples.Push(-1); return; }
            samples.Add(new OpenSample { Name = name, Depth = openSamples.Count, Begin = Stamp(), End = -1 });
            openSamples.Push(samples.Count - 1);
        }

        public void EndSample()
        {
            if (!openSamples.TryPop(out int index)) throw new InvalidOperationException("EndSample without BeginSample.");
            if (index < 0) return;
            var sample = samples[index];
            sample.End = Stamp();
            samples[index] = sample;
        }

        public List<DeviceSample> CollectSamples()
        {
            WaitIdle();
            var stamps = ReadStamps();
            var result = new List<DeviceSample>();
            double toMs = timestampPeriod * 1e-6;
            foreach (var s in samples)
            {
                if (s.End < 0) continue;
                result.Add(new DeviceSample
                {
                    Name = s.Name, Depth = s.Depth, BeginMs = (stamps[s.Begin] - stamps[samples[0].Begin] & timestampMask) * toMs,
                    Milliseconds = (stamps[s.End] - stamps[s.Begin] & timestampMask) * toMs,
                });
            }
            if (openSamples.Count == 0)
            {
                samples.Clear();
                stampCount = 0;
            }
            return result;
        }

        int Stamp()
        {
            BeginOperation();
            int stamp = stampCount++;
            int pool = stamp / (int)StampsPerPool;
            uint query = (uint)stamp % StampsPerPool;
            if (pool == stampPools.Count) stampPools.Add(CreateStampPool(StampsPerPool));
            if (query == 0) vk.ResetQueryPool(device, stampPools[pool], 0, StampsPerPool);
            vk.CmdWriteTimestamp2(commands, VkPipelineStageFlags2.ALL_COMMANDS, stampPools[pool], query);
            return stamp;
        }

        VkQueryPool CreateStampPool(uint stamps)
        {
            var info = new VkQueryPoolCreateInfo { queryType = VkQueryType.TIMESTAMP, queryCount = stamps };
            VkQueryPool made;
            Check(vk.CreateQueryPool(device, &info, null, &made), "vkCreateQueryPool");
            return made;
        }

        ulong[] ReadStamps()
        {
            var stamps = new ulong[stampCount];
            fixed (ulong* p = stamps)
                for (int first = 0; first < stampCount; first += (int)StampsPerPool)
                {
                    uint count = Math.Min(StampsPerPool, (uint)(stampCount - first));
                    CheckLost(vk.GetQueryPoolResults(device, stampPools[first / (int)StampsPerPool], 0, count, count * sizeof(ulong),
                        p + first, sizeof(ulong),
                        VkQueryResultFlags._64 | VkQueryResultFlags.WAIT), "vkGetQueryPoolResults");
                }
            return stamps;
        }

        void DestroyTiming()
        {
            foreach (var pool in stampPools) vk.DestroyQueryPool(device, pool, null);
        }
    }
}
