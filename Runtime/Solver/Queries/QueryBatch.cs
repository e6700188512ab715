using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The buffers of a batch of questions, of its own size: one upload, the kernels, one readback. It never waits.</summary>
    sealed class QueryBatch : IDisposable
    {
        /// <summary>Number of requests that may be pending, and 1 for the newest answer, which is read meanwhile.</summary>
        public const int RingSize = Queries.RingSize + 1;

        /// <summary>Around the answers to all batches of a frame.</summary>
        public static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.QueryBatch");

        readonly BufferClear clear = new BufferClear();
        readonly ReadbackRing ring;
        readonly int firstRayWord;
        GraphicsBuffer points, foundPoints, rays, lines, foundRays;
        NativeArray<uint> lineUpload;
        BatchInput input;
        GraphicsBuffer results;
        int lineCount;

        /// <param name="pointCapacity">0 or more.</param>
        /// <param name="rayCapacity">0 or more; not both are 0.</param>
        /// <param name="arrived">Called with the slot of each answer that has come.</param>
        /// <param name="lost">Called with the slot of each request that ended with an error; may be null.</param>
        public QueryBatch(int pointCapacity, int rayCapacity, Action<int> arrived, Action<int> lost = null)
        {
            firstRayWord = pointCapacity * Queries.ProbeWords;
            if (pointCapacity > 0)
            {
                points = GpuBuffer.Structured<float4>("Rill.QueryBatch.Points", pointCapacity);
                foundPoints = MakeFound("Rill.QueryBatch.FoundPoints", pointCapacity);
            }
            if (rayCapacity > 0)
            {
                rays = GpuBuffer.Structured<RayQuery>("Rill.QueryBatch.Rays", rayCapacity);
                foundRays = MakeFound("Rill.QueryBatch.FoundRays", rayCapacity);
            }
            int words = firstRayWord + rayCapacity * RayQuery.RayWords;
            ring = new ReadbackRing("Rill.QueryBatch.Results", RingSize, words, arrived, lost);
        }

        /// <summary>Slot of the next request; -1 while all are pending.</summary>
        /// <param name="newest">A slot that is still read, or -1.</param>
        public int FreeSlot(int newest) => ring.Free(newest);

        /// <summary>Prepares the queries of <see cref="PbfSolver.RecordBatches"/>, and the slot of the answers; call <see cref="Request"/> after
        /// its commands ran.</summary>
        public void Prepare(in BatchInput what, int slot)
        {
            input = what;
            results = ring.Buffer(slot);
        }

        /// <summary>Records the upload of what is asked.</summary>
        public void RecordUpload(CommandBuffer cmd)
        {
            clear.Record(cmd, results);
            if (input.pointCount > 0)
                cmd.SetBufferData(points, input.points, 0, 0, input.pointCount);
            if (input.rayCount > 0)
            {
                cmd.SetBufferData(rays, input.rays, 0, 0, input.rayCount);
                lineCount = UploadLines(cmd, input.rays, input.rayCount);
            }
        }

        /// <summary>Records the search for the surface.</summary>
        public void RecordSearch(in StepContext step, QueryShader shader, ParticleTags tags)
        {
            if (input.pointCount > 0)
                shader.SearchPoints(step, tags, Points);
            if (input.rayCount > 0)
                shader.SearchRays(step, tags, Rays);
        }

        /// <summary>Records the answers to points.</summary>
        public void RecordPoints(in StepContext step, QueryShader shader, ParticleTags tags)
        {
            if (input.pointCount > 0)
                shader.AnswerPoints(step, tags, Points, results);
        }

        /// <summary>Records the answers to rays.</summary>
        public void RecordRays(in StepContext step, QueryShader shader, ParticleTags tags)
        {
            if (input.rayCount > 0)
                shader.AnswerRays(step, tags, Rays, results, firstRayWord);
        }

        PointBuffers Points => new PointBuffers { points = points, found = foundPoints, count = input.pointCount, up = input.up };

        RayBuffers Rays => new RayBuffers
        {
            rays = rays,
            lines = lines,
            found = foundRays,
            rayCount = input.rayCount,
            lineCount = lineCount,
            length = input.rayLength,
            up = input.up,
        };

        static GraphicsBuffer MakeFound(string name, int count)
        {
            GraphicsBuffer found = GpuBuffer.Structured<uint>(name, count);
            BufferClear.Now(found);
            return found;
        }

        /// <summary>Asks for what was recorded for a slot.</summary>
        /// <param name="errors">Learns of it where the device does not give the answer; may be null.</param>
        public void Request(int slot, ReadbackErrors errors = null)
        {
            ring.Report(errors, ReadbackKinds.QueryBatches);
            ring.Request(slot);
        }

        /// <summary>Takes words that a request of before a snapshot was to bring; see <see cref="ReadbackRing.Resume"/>.</summary>
        public void Resume(int slot, ReadOnlySpan<uint> words, int frames) => ring.Resume(slot, words, frames);

        /// <summary>Follows what is pending of a slot.</summary>
        public ReadbackArrival Follow(int slot) => ring.Follow(slot);

        /// <summary>Lists the slots whose answers are pending, in the order of the requests.</summary>
        public void ListPending(List<int> pending) => ring.ListPending(pending);

        /// <summary>Returns the buffer that a slot's answers are written into.</summary>
        public GraphicsBuffer Results(int slot) => ring.Buffer(slot);

        /// <summary>Waits for the answers that are pending, and for nothing else.</summary>
        public void Complete() => ring.Complete();

        /// <summary>Answers from before this call are dropped when they come.</summary>
        public void Invalidate() => ring.Invalidate();

        /// <summary>The words that have come to a slot.</summary>
        public NativeArray<uint> Latest(int slot) => ring.Latest(slot);

        /// <summary>The first word of a point's answer.</summary>
        public int PointAt(int index) => index * Queries.ProbeWords;

        /// <summary>The first word of a ray's answer.</summary>
        public int RayAt(int index) => firstRayWord + index * RayQuery.RayWords;

        public void Describe(StageDescription description, QueryShader shader, ParticleTags tags)
        {
            if (points != null)
                shader.DescribePoints(description, tags);
            if (rays != null)
                shader.DescribeRays(description, tags);
            description.Buffer("Rill.QueryBatch.Points", points);
            description.Buffer("Rill.QueryBatch.FoundPoints", foundPoints);
            description.Buffer("Rill.QueryBatch.Rays", rays);
            description.Buffer("Rill.QueryBatch.Lines", lines);
            description.Buffer("Rill.QueryBatch.FoundRays", foundRays);
            ring.Describe(description);
        }

        public void Dispose()
        {
            ring?.Dispose();
            if (lineUpload.IsCreated)
                lineUpload.Dispose();
            GpuBuffer.Release(ref points);
            GpuBuffer.Release(ref foundPoints);
            GpuBuffer.Release(ref rays);
            GpuBuffer.Release(ref lines);
            GpuBuffer.Release(ref foundRays);
        }

        // How many there are depends on the radii: the buffer grows with the most that were needed.
        int UploadLines(CommandBuffer cmd, NativeArray<RayQuery> queries, int count)
        {
            int total = 0;
            for (int i = 0; i < count; i++)
                total += (int)queries[i].lines;
            if (lines == null || lines.count < total)
            {
                GpuBuffer.Release(ref lines);
                if (lineUpload.IsCreated)
                    lineUpload.Dispose();
                lines = GpuBuffer.Structured<uint>("Rill.QueryBatch.Lines", math.ceilpow2(total));
                lineUpload = new NativeArray<uint>(lines.count, Allocator.Persistent);
            }
            int at = 0;
            for (uint i = 0; i < count; i++)
                for (uint line = 0; line < queries[(int)i].lines; line++)
                    lineUpload[at++] = i << RayQuery.LineShift | line;
            cmd.SetBufferData(lines, lineUpload, 0, 0, total);
            return total;
        }
    }

    /// <summary>Queries of a batch for one state; lengths in d, in the domain's frame.</summary>
    struct BatchInput
    {
        /// <summary>xyz within the domain.</summary>
        public NativeArray<float4> points;
        public NativeArray<RayQuery> rays;
        public int pointCount, rayCount;
        /// <summary>At least that of each ray in the domain.</summary>
        public float rayLength;
        /// <summary>Against gravity, length 1; 0 without gravity.</summary>
        public float3 up;
    }
}
