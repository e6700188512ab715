using System.Collections.Generic;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>Points in time of the stream that are read later, without waiting.</summary>
    sealed unsafe partial class VulkanDevice
    {
        const uint MarksPerPool = 256;

        readonly List<VkQueryPool> markPools = new();
        readonly Queue<VulkanTimeMark> freeMarks = new();
        int marksMade;

        public DeviceTimeMark MarkTime()
        {
            BeginOperation();
            VulkanTimeMark mark = RentMark();
            vk.ResetQueryPool(device, mark.Pool, mark.Query, 1);
            vk.CmdWriteTimestamp2(commands, VkPipelineStageFlags2.ALL_COMMANDS, mark.Pool, mark.Query);
            mark.Begin(CurrentSubmission);
            return mark;
        }

        VulkanTimeMark RentMark()
        {
            // A query must not be reset while a submission still writes it.
            if (freeMarks.TryPeek(out VulkanTimeMark oldest) && HasCompleted(oldest.Submission))
                return freeMarks.Dequeue();
            uint query = (uint)marksMade++ % MarksPerPool;
            if (query == 0)
                markPools.Add(CreateStampPool(MarksPerPool));
            return new VulkanTimeMark(this, markPools[^1], query);
        }

        internal void GiveBack(VulkanTimeMark mark) => freeMarks.Enqueue(mark);

        internal double ReadMark(VulkanTimeMark mark)
        {
            ulong stamp;
            CheckLost(vk.GetQueryPoolResults(device, mark.Pool, mark.Query, 1, sizeof(ulong), &stamp, sizeof(ulong),
                VkQueryResultFlags._64 | VkQueryResultFlags.WAIT), "vkGetQueryPoolResults");
            return (stamp & timestampMask) * (double)timestampPeriod * 1e-6;
        }

        void DestroyMarks()
        {
            foreach (VkQueryPool pool in markPools)
                vk.DestroyQueryPool(device, pool, null);
        }
    }

    internal sealed class VulkanTimeMark : DeviceTimeMark
    {
        readonly VulkanDevice device;
        public readonly VkQueryPool Pool;
        public readonly uint Query;
        bool isRead, isOpen;
        double milliseconds;

        public VulkanTimeMark(VulkanDevice device, VkQueryPool pool, uint query) => (this.device, Pool, Query) = (device, pool, query);

        public ulong Submission { get; private set; }

        public void Begin(ulong submission)
        {
            Submission = submission;
            isRead = false;
            isOpen = true;
        }

        public override bool TryRead(out double value)
        {
            if (!isRead && device.HasCompleted(Submission))
            {
                milliseconds = device.ReadMark(this);
                isRead = true;
            }
            value = milliseconds;
            return isRead;
        }

        public override void Dispose()
        {
            if (!isOpen)
                return;
            isOpen = false;
            device.GiveBack(this);
        }
    }
}
