using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What the fluid does to colliders: summed on the GPU over steps, brought back without waiting. Made when a collider wants to
    /// know.</summary>
    sealed class ColliderReactions : IDisposable
    {
        /// <summary>words of a collider: three sums, three moments, and what was added</summary>
        [GenerateHlsl("Reactions", Prefix = "Reaction")] const int Stride = 13;

        /// <summary>steps of a summed displacement in d</summary>
        [GenerateHlsl("Reactions", Prefix = "Reaction")] const double Scale = 65536.0;

        const int Words = Stride * ColliderSet.Most;

        readonly ComputeShader shader;
        readonly Kernel take;
        readonly Readback readback = new Readback(GpuBuffer.Structured<uint>("Rill.Colliders.Taken", Words));
        GraphicsBuffer sums;
        readonly uint[] zeros = new uint[Words];
        float time, takenTime;

        /// <param name="errors">Learns of results that the device did not give; may be null.</param>
        public ColliderReactions(ComputeShader shader, ReadbackErrors errors = null)
        {
            readback.Report(errors, ReadbackKinds.Forces);
            this.shader = shader;
            take = new Kernel(shader, "TakeReactions");
            sums = GpuBuffer.Structured<uint>("Rill.Colliders.Reactions", Words);
            BufferClear.Now(sums);
            readback.Arrived = OnArrived;
        }

        /// <summary>Called with each result when it has come; read it with <see cref="Get"/>.</summary>
        public Action Arrived;

        /// <summary>Whether a result is pending; sums go on meanwhile.</summary>
        public bool IsPending => readback.IsPending;

        /// <summary>Fluid time over which the newest result was summed, s; 0 before the first.</summary>
        public float Duration { get; private set; }

        /// <summary>Records the sums as what a kernel adds to.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader reader, int kernel) => cmd.SetComputeBufferParam(reader, kernel, Ids.Reactions, sums);

        /// <summary>Tells of a step that added to the sums.</summary>
        public void AddTime(float stepTime) => time += stepTime;

        /// <summary>Records that sums begin again, as the colliders have other numbers now; what is pending is dropped.</summary>
        public void Invalidate(CommandBuffer cmd)
        {
            cmd.SetBufferData(sums, zeros);
            time = 0f;
            readback.Invalidate();
        }

        /// <summary>Records the handing over of the sums; call <see cref="Request"/> after the commands ran.</summary>
        public void RecordTake(CommandBuffer cmd)
        {
            takenTime = time;
            time = 0f;
            cmd.SetComputeIntParam(shader, Ids.ReactionWords, Words);
            cmd.SetComputeBufferParam(shader, take, Ids.Reactions, sums);
            cmd.SetComputeBufferParam(shader, take, Ids.Taken, readback.Buffer);
            CoarseGrid.Dispatch(cmd, shader, take, Words);
        }

        public void Request() => readback.Request();

        /// <summary>What collider number <paramref name="index"/> gave to the fluid: displacements of particles, d, and their moment about
        /// its place over its moment arm.</summary>
        public void Get(int index, out double3 sum, out double3 moment)
        {
            int at = index * Stride;
            sum = new double3(Signed(at), Signed(at + 2), Signed(at + 4));
            moment = new double3(Signed(at + 6), Signed(at + 8), Signed(at + 10));
        }

        public void Describe(StageDescription description)
        {
            description.Kernel(take, 0);
            description.Buffer("Rill.Colliders.Reactions", sums);
            description.Buffer("Rill.Colliders.Taken", readback.Buffer);
        }

        public void Dispose()
        {
            readback.Dispose();
            GpuBuffer.Release(ref sums);
        }

        double Signed(int at) => (long)((ulong)readback.Latest[at + 1] << 32 | readback.Latest[at]) / Scale;

        void OnArrived()
        {
            Duration = takenTime;
            Arrived?.Invoke();
        }

        static class Ids
        {
            public static readonly int Reactions = Shader.PropertyToID("_Reactions");
            public static readonly int Taken = Shader.PropertyToID("_Taken");
            public static readonly int ReactionWords = Shader.PropertyToID("_ReactionWords");
        }
    }
}
