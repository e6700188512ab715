using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>Resource that the device frees once the stream has passed its last use.</summary>
    internal interface IRetirable
    {
        /// <summary>The submission that used it last; 0 = none.</summary>
        ulong LastSubmission { get; }
        /// <summary>Frees the GPU objects, which nothing uses any more.</summary>
        void Free();
    }

    /// <summary>The stream: recording, submission, waiting, and the freeing of what the stream has passed.</summary>
    /// <remarks>Submissions are numbered from 1 and one timeline semaphore counts those that are done.</remarks>
    sealed unsafe partial class VulkanDevice
    {
        const int MaxInFlight = 8;
        /// <summary>Long recordings start early, so that the GPU does not idle while the CPU records.</summary>
        const int OperationsPerSubmission = 1024;
        const int RetiredPerSubmission = 1024;

        sealed class Recording
        {
            public VkCommandPool Pool;
            public VkCommandBuffer Commands;
            public ulong Submission;
        }

        VkSemaphore timeline;
        readonly Queue<Recording> inFlight = new();
        readonly Stack<Recording> spare = new();
        Recording recording;                // null: nothing recorded since the last flush
        VkCommandBuffer commands;           // recording's
        ulong nextSubmission = 1, completed;
        int operationsRecorded;
        bool hostWillRead;
        VkPipeline boundCompute, boundGraphics;
        readonly Queue<(ulong Submission, IRetirable Resource)> retired = new();
        ulong lastRetired;
        string lastProgram = "none";        // named when the device is lost

        void CreateStream()
        {
            var type = new VkSemaphoreTypeCreateInfo { semaphoreType = VkSemaphoreType.TIMELINE };
            var info = new VkSemaphoreCreateInfo { pNext = &type };
            VkSemaphore made;
            Check(vk.CreateSemaphore(device, &info, null, &made), "vkCreateSemaphore");
            timeline = made;
        }

        /// <summary>Every operation begins here: the stream is open for commands afterwards.</summary>
        void BeginOperation()
        {
            if (disposed) throw new ObjectDisposedException(Info.Name, "The Vulkan device was disposed.");
            if (operationsRecorded >= OperationsPerSubmission || uploadBytesRecorded >= UploadsPerSubmission) Flush();
            Open();
            operationsRecorded++;
            operation++;
            ForgetTouched();
        }

        void Open()
        {
            if (recording != null) return;
            if (inFlight.Count >= MaxInFlight) WaitFor(inFlight.Peek().Submission);
            Recycle();
            if (!spare.TryPop(out recording)) recording = CreateRecording();
            commands = recording.Commands;
            var info = new VkCommandBufferBeginInfo { flags = VkCommandBufferUsageFlags.ONE_TIME_SUBMIT };
            Check(vk.BeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
            boundCompute = boundGraphics = VkPipeline.Null;
        }

        Recording CreateRecording()
        {
            var poolInfo = new VkCommandPoolCreateInfo { flags = VkCommandPoolCreateFlags.TRANSIENT, queueFamilyIndex = queueFamily };
            VkCommandPool pool;
            Check(vk.CreateCommandPool(device, &poolInfo, null, &pool), "vkCreateCommandPool");
            var info = new VkCommandBufferAllocateInfo { commandPool = pool, level = VkCommandBufferLevel.PRIMARY, commandBufferCount = 1 };
            VkCommandBuffer made;
            Check(vk.AllocateCommandBuffers(device, &info, &made), "vkAllocateCommandBuffers");
            return new Recording { Pool = pool, Commands = made };
        }

        public void Flush()
        {
            if (recording == null) return;
            SuspendPass();
            if (hostWillRead) BarrierForHost();
            Check(vk.EndCommandBuffer(commands), "vkEndCommandBuffer");
            var buffer = new VkCommandBufferSubmitInfo { commandBuffer = commands };
            var signal = new VkSemaphoreSubmitInfo { semaphore = timeline, value = nextSubmission, stageMask = VkPipelineStageFlags2.ALL_COMMANDS };
            var submit = new VkSubmitInfo2 { commandBufferInfoCount = 1, pCommandBufferInfos = &buffer, signalSemaphoreInfoCount = 1,
                pSignalSemaphoreInfos = &signal };
            CheckLost(vk.QueueSubmit2(queue, 1, &submit, VkFence.Null), "vkQueueSubmit2");
            recording.Submission = nextSubmission++;
            inFlight.Enqueue(recording);
            recording = null;
            operationsRecorded = 0;
            uploadBytesRecorded = 0;
            Recycle();
        }

        public void WaitIdle()
        {
            Flush();
            WaitFor(nextSubmission - 1);
            Recycle();
        }

        internal void WaitFor(ulong submission)
        {
            if (submission >= nextSubmission) Flush();
            if (submission <= completed || SpinFor(submission)) return;
            VkSemaphore semaphore = timeline;
            var info = new VkSemaphoreWaitInfo { semaphoreCount = 1, pSemaphores = &semaphore, pValues = &submission };
            CheckLost(vk.WaitSemaphores(device, &info, ulong.MaxValue), "vkWaitSemaphores");
            completed = Math.Max(completed, submission);
        }

        /// <summary>Sleeping and waking costs more than a short step: a hardware device is watched for a moment first.</summary>
        bool SpinFor(ulong submission)
        {
            if (Info.IsSoftware) return false;      // its work runs on the very cores that would spin
            for (long end = Stopwatch.GetTimestamp() + Stopwatch.Frequency / 2000; Stopwatch.GetTimestamp() < end; Thread.SpinWait(20))
                if (HasCompleted(submission)) return true;
            return false;
        }

        internal bool HasCompleted(ulong submission)
        {
            if (submission <= completed) return true;
            ulong value;
            CheckLost(vk.GetSemaphoreCounterValue(device, timeline, &value), "vkGetSemaphoreCounterValue");
            completed = value;
            return submission <= completed;
        }

        /// <summary>The submission that will carry what is recorded now.</summary>
        internal ulong CurrentSubmission => nextSubmission;

        /// <summary>Takes back what finished submissions held.</summary>
        void Recycle()
        {
            while (inFlight.TryPeek(out var oldest) && HasCompleted(oldest.Submission))
            {
                inFlight.Dequeue();
                Check(vk.ResetCommandPool(device, oldest.Pool, 0), "vkResetCommandPool");
                spare.Push(oldest);
            }
            while (retired.TryPeek(out var item) && item.Submission <= completed)
            {
                retired.Dequeue();
                Destroy(item.Resource);
            }
        }

        // ---- life of resources

        void Register(IRetirable resource) => live.Add(resource);

        /// <summary>Frees the resource now if the stream is past it, otherwise as soon as it is.</summary>
        internal void Retire(IRetirable resource)
        {
            if (!live.Contains(resource)) return;       // freed with its device
            if (resource.LastSubmission <= completed) { Destroy(resource); return; }
            lastRetired = Math.Max(lastRetired, resource.LastSubmission);
            retired.Enqueue((lastRetired, resource));
            if (retired.Count >= RetiredPerSubmission) { Flush(); if (inFlight.TryPeek(out var oldest)) WaitFor(oldest.Submission); Recycle(); }
        }

        void Destroy(IRetirable resource)
        {
            if (live.Remove(resource)) resource.Free();
        }

        void CheckLost(VkResult result, string what)
        {
            if (result != VkResult.ERROR_DEVICE_LOST) { Check(result, what); return; }
            throw new InvalidOperationException(
                $"The GPU was lost in {what}: a shader ran too long or read memory that is not its own. Recorded last: {lastProgram}.");
        }

        void DestroyStream()
        {
            foreach (var r in spare) vk.DestroyCommandPool(device, r.Pool, null);
            vk.DestroySemaphore(device, timeline, null);
        }
    }
}
