using System;
using Unity.Collections;

namespace Unity.Jobs
{
    public interface IJob { void Execute(); }
    public interface IJobFor { void Execute(int index); }
    public interface IJobParallelFor { void Execute(int index); }

    /// <summary>Jobs run where they are scheduled, to their end, one index after the other: that is one of the orders that Unity may
    /// choose.</summary>
    public struct JobHandle : IEquatable<JobHandle>
    {
        public bool IsCompleted => true;
        public void Complete() { }
        public static void CompleteAll(ref JobHandle job0, ref JobHandle job1) { }
        public static void CompleteAll(ref JobHandle job0, ref JobHandle job1, ref JobHandle job2) { }
        public static void CompleteAll(NativeArray<JobHandle> jobs) { }
        public static void ScheduleBatchedJobs() { }
        public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1) => default;
        public static JobHandle CombineDependencies(JobHandle job0, JobHandle job1, JobHandle job2) => default;
        public static JobHandle CombineDependencies(NativeArray<JobHandle> jobs) => default;
        public static bool CheckFenceIsDependencyOrDidSyncFence(JobHandle jobHandle, JobHandle dependsOn) => true;
        public bool Equals(JobHandle other) => true;
        public override bool Equals(object obj) => obj is JobHandle;
        public override int GetHashCode() => 0;
        public static bool operator ==(JobHandle a, JobHandle b) => true;
        public static bool operator !=(JobHandle a, JobHandle b) => false;
    }

    public static class IJobExtensions
    {
        public static void EarlyJobInit<T>() where T : struct, IJob { }
        public static void Run<T>(this T jobData) where T : struct, IJob => jobData.Execute();
        public static void RunByRef<T>(ref this T jobData) where T : struct, IJob => jobData.Execute();

        public static JobHandle Schedule<T>(this T jobData, JobHandle dependsOn = new JobHandle()) where T : struct, IJob
        {
            jobData.Execute();
            return default;
        }

        public static JobHandle ScheduleByRef<T>(ref this T jobData, JobHandle dependsOn = new JobHandle()) where T : struct, IJob
        {
            // The scheduled job is a copy: what it leaves in its own fields does not come back.
            T copy = jobData;
            copy.Execute();
            return default;
        }
    }

    public static class IJobForExtensions
    {
        public static void EarlyJobInit<T>() where T : struct, IJobFor { }
        public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobFor => Loop(jobData, arrayLength);
        public static void RunByRef<T>(ref this T jobData, int arrayLength) where T : struct, IJobFor => Loop(jobData, arrayLength);
        public static JobHandle Schedule<T>(this T jobData, int arrayLength, JobHandle dependency) where T : struct, IJobFor
            => Loop(jobData, arrayLength);
        public static JobHandle ScheduleByRef<T>(ref this T jobData, int arrayLength, JobHandle dependency) where T : struct, IJobFor
            => Loop(jobData, arrayLength);
        public static JobHandle ScheduleParallel<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependency) where T
            : struct, IJobFor => Loop(jobData, arrayLength);
        public static JobHandle ScheduleParallelByRef<T>(ref this T jobData, int arrayLength, int innerloopBatchCount,
            JobHandle dependency) where T : struct, IJobFor => Loop(jobData, arrayLength);

        static JobHandle Loop<T>(T job, int count) where T : struct, IJobFor
        {
            for (int i = 0; i < count; i++)
                job.Execute(i);
            return default;
        }
    }

    public static class IJobParallelForExtensions
    {
        public static void EarlyJobInit<T>() where T : struct, IJobParallelFor { }
        public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobParallelFor => Loop(jobData, arrayLength);
        public static void RunByRef<T>(ref this T jobData, int arrayLength) where T : struct, IJobParallelFor => Loop(jobData, arrayLength);
        public static JobHandle Schedule<T>(this T jobData, int arrayLength, int innerloopBatchCount,
            JobHandle dependsOn = new JobHandle()) where T : struct, IJobParallelFor => Loop(jobData, arrayLength);
        public static JobHandle ScheduleByRef<T>(ref this T jobData, int arrayLength, int innerloopBatchCount,
            JobHandle dependsOn = new JobHandle()) where T : struct, IJobParallelFor => Loop(jobData, arrayLength);

        static JobHandle Loop<T>(T job, int count) where T : struct, IJobParallelFor
        {
            for (int i = 0; i < count; i++)
                job.Execute(i);
            return default;
        }
    }
}
