using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The kernels that answer questions about the state that a step left, and what is bound to them. Whoever asks brings the
    /// buffers.</summary>
    sealed class QueryShader
    {
        /// <summary>particles that a thread of the detectors visits</summary>
        [GenerateHlsl("Queries")] const int ParticlesPerThread = 4;

        /// <summary>threads of a probe's groups</summary>
        [GenerateHlsl("Queries")] const int ProbeGroup = 256;

        /// <summary>densities along a line that a group finds</summary>
        [GenerateHlsl("Queries")] const int Samples = 32;

        /// <summary>columns around a point of the surface in which it is found too</summary>
        [GenerateHlsl("Queries")] public const int Columns = 16;

        /// <summary>columns of a group</summary>
        [GenerateHlsl("Queries")] const int GroupColumns = 4;

        /// <summary>Phases of what points and rays ask. What several ask is recorded phase by phase: dispatches of one phase wait for none of its
        /// others.</summary>
        public const int Phases = 4;

        const string Name = "Queries";
        const float ChunkLength = 0.5f * (Samples - 1);        // as in SurfaceLines.hlsl, d

        readonly ComputeShader shader = StageShader.LoadCompute(Name);
        readonly Kernel findSurface, findSurroundings, fitNormal, detect, detectMesh, searchLines, findHits, findRayColumns, fitRayNormal;
        readonly LocalKeyword withTags;

        public QueryShader()
        {
            findSurface = new Kernel(shader, "FindSurface");
            findSurroundings = new Kernel(shader, "FindSurroundings");
            fitNormal = new Kernel(shader, "FitNormal");
            detect = new Kernel(shader, "Detect");
            detectMesh = new Kernel(shader, "DetectMesh");
            searchLines = new Kernel(shader, "SearchLines");
            findHits = new Kernel(shader, "FindHits");
            findRayColumns = new Kernel(shader, "FindRayColumns");
            fitRayNormal = new Kernel(shader, "FitRayNormal");
            withTags = new LocalKeyword(shader, ParticleTags.Keyword);
        }

        /// <summary>Whether particles were removed since the last step: positions that are not finite are looked for only then.</summary>
        public bool HasRemoved { get; set; }

        /// <summary>Records what is at points: density, velocity, phase, and the surface along gravity.</summary>
        /// <param name="up">Against gravity, length 1; 0 without gravity.</param>
        /// <param name="points">float4, xyz within the domain, d.</param>
        /// <param name="ringHeights">float, <see cref="Columns"/> for each point.</param>
        /// <param name="results">uint, <see cref="Queries.ProbeWords"/> for each point, 0 at entry.</param>
        /// <param name="count">1 to <see cref="ThreadGroups.MaxGroups"/>.</param>
        public void RecordPoints(in StepContext step, ParticleTags tags, float3 up, GraphicsBuffer points, GraphicsBuffer ringHeights,
            GraphicsBuffer results, int count)
        {
            Begin(step, tags);
            for (int phase = 0; phase < Phases; phase++)
                DispatchPoints(step, tags, up, points, ringHeights, results, count, phase);
        }

        /// <summary>Records one of the <see cref="Phases"/> of it.</summary>
        public void RecordPoints(in StepContext step, ParticleTags tags, float3 up, GraphicsBuffer points, GraphicsBuffer ringHeights,
            GraphicsBuffer results, int count, int phase)
        {
            Begin(step, tags);
            DispatchPoints(step, tags, up, points, ringHeights, results, count, phase);
        }

        void DispatchPoints(in StepContext step, ParticleTags tags, float3 up, GraphicsBuffer points, GraphicsBuffer ringHeights,
            GraphicsBuffer results, int count, int phase)
        {
            CommandBuffer cmd = step.Commands;
            cmd.SetComputeVectorParam(shader, Ids.Up, (Vector3)up);
            switch (phase)
            {
                case 0 when math.any(up != 0f):
                    BindPoints(step, findSurface, tags, points, ringHeights, results);
                    cmd.DispatchCompute(shader, findSurface, count, Chunks(math.dot(math.abs(up), step.Layout.DomainSize)), 1);
                    break;
                case 1:
                    BindPoints(step, findSurroundings, tags, points, ringHeights, results);
                    cmd.DispatchCompute(shader, findSurroundings, count, Columns / GroupColumns + 2, 1);
                    break;
                case 2:
                    BindPoints(step, fitNormal, tags, points, ringHeights, results);
                    cmd.DispatchCompute(shader, fitNormal, count, 1, 1);
                    break;
            }
        }

        /// <summary>Records one of the <see cref="Phases"/> of where rays and balls cross the surface, and density, velocity and phase at that
        /// point.</summary>
        /// <param name="up">Against gravity, length 1; 0 without gravity.</param>
        /// <param name="length">At least that of each ray in the box, d.</param>
        /// <param name="firstWord">Of the results, from which on there are <see cref="RayQuery.RayWords"/> for each ray.</param>
        public void RecordRays(in StepContext step, ParticleTags tags, float3 up, in RayBuffers buffers, float length, GraphicsBuffer ringHeights,
            GraphicsBuffer results, int firstWord, int phase)
        {
            CommandBuffer cmd = step.Commands;
            Begin(step, tags);
            cmd.SetComputeVectorParam(shader, Ids.Up, (Vector3)up);
            cmd.SetComputeIntParam(shader, Ids.FirstRayWord, firstWord);
            cmd.SetComputeIntParam(shader, Ids.LineCount, buffers.lineCount);
            switch (phase)
            {
                case 0:
                    int perRow = math.min(buffers.lineCount, ThreadGroups.MaxGroups);
                    BindRays(step, searchLines, tags, buffers, null, results);
                    cmd.SetComputeBufferParam(shader, searchLines, Ids.Lines, buffers.lines);
                    // One sample more than the length: it tells where the water ends at a wall.
                    cmd.DispatchCompute(shader, searchLines, perRow, Chunks(length + 1f), (buffers.lineCount + perRow - 1) / perRow);
                    break;
                case 1:
                    BindRays(step, findHits, tags, buffers, null, results);
                    cmd.DispatchCompute(shader, findHits, buffers.rayCount, 1, 1);
                    break;
                case 2:
                    BindRays(step, findRayColumns, tags, buffers, ringHeights, results);
                    cmd.DispatchCompute(shader, findRayColumns, buffers.rayCount, Columns / GroupColumns, 1);
                    break;
                case 3:
                    BindRays(step, fitRayNormal, tags, buffers, ringHeights, results);
                    cmd.DispatchCompute(shader, fitRayNormal, buffers.rayCount, 1, 1);
                    break;
            }
        }

        /// <summary>Records what is in shapes: all that need no field at once, then each mesh, since a kernel cannot choose among
        /// textures.</summary>
        /// <param name="detectors"><see cref="DetectorRegion"/>, those that are meshes last.</param>
        /// <param name="results">uint, from a word on <see cref="Queries.DetectorWords"/> for each shape, 0 at entry.</param>
        /// <param name="fields">Of the meshes, at their indices among all.</param>
        public void RecordDetectors(in StepContext step, ParticleTags tags, GraphicsBuffer detectors, GraphicsBuffer results, int firstWord,
            int simpleCount, Texture3D[] fields, int meshCount)
        {
            Begin(step, tags);
            if (simpleCount > 0)
                Detect(step, detect, tags, detectors, results, 0, simpleCount, firstWord);
            for (int i = simpleCount; i < simpleCount + meshCount; i++)
            {
                step.Commands.SetComputeTextureParam(shader, detectMesh, Ids.Field, fields[i]);
                Detect(step, detectMesh, tags, detectors, results, i, 1, firstWord);
            }
        }

        public void DescribePoints(StageDescription description, ParticleTags tags)
        {
            description.Kernel(findSurface, 0, Variant(tags));
            description.Kernel(findSurroundings, 0, Variant(tags));
            description.Kernel(fitNormal, 0, Variant(tags));
        }

        public void DescribeRays(StageDescription description, ParticleTags tags)
        {
            description.Kernel(searchLines, 0, Variant(tags));
            description.Kernel(findHits, 0, Variant(tags));
            description.Kernel(findRayColumns, 0, Variant(tags));
            description.Kernel(fitRayNormal, 0, Variant(tags));
        }

        public void DescribeDetectors(StageDescription description, ParticleTags tags, int simpleCount, int meshCount)
        {
            if (simpleCount > 0)
                description.Kernel(detect, 0, Variant(tags));
            if (meshCount > 0)
                description.Kernel(detectMesh, 0, Variant(tags));
        }

        static string Variant(ParticleTags tags) => tags != null ? ParticleTags.Keyword : null;

        // Groups along a line of this length, d. A line through the box is never longer than its sides together.
        static int Chunks(float length) => math.max((int)math.ceil(length / ChunkLength), 1);

        void Begin(in StepContext step, ParticleTags tags)
        {
            step.BindConstants(shader);
            step.Commands.SetKeyword(shader, withTags, tags != null);
            step.Commands.SetComputeIntParam(shader, Ids.IsSorted, step.Search.IsSorted ? 1 : 0);
            step.Commands.SetComputeIntParam(shader, Ids.HasRemoved, HasRemoved ? 1 : 0);
        }

        void Detect(in StepContext step, int kernel, ParticleTags tags, GraphicsBuffer detectors, GraphicsBuffer results, int first, int count,
            int firstWord)
        {
            const int PerGroup = ParticleBuffers.Group * ParticlesPerThread;
            CommandBuffer cmd = step.Commands;
            cmd.SetComputeIntParam(shader, Ids.FirstDetector, first);
            cmd.SetComputeIntParam(shader, Ids.FirstDetectorWord, firstWord + first * Queries.DetectorWords);
            cmd.SetComputeIntParam(shader, Ids.DetectorCount, count);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Detectors, detectors);
            Bind(step, kernel, tags, results);
            cmd.DispatchCompute(shader, kernel, (step.Layout.Capacity + PerGroup - 1) / PerGroup, 1, 1);
        }

        void BindPoints(in StepContext step, int kernel, ParticleTags tags, GraphicsBuffer points, GraphicsBuffer ringHeights,
            GraphicsBuffer results)
        {
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.CellStarts, step.Search.CellStarts);
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.Points, points);
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.RingHeights, ringHeights);
            Bind(step, kernel, tags, results);
        }

        void BindRays(in StepContext step, int kernel, ParticleTags tags, in RayBuffers buffers, GraphicsBuffer ringHeights, GraphicsBuffer results)
        {
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.CellStarts, step.Search.CellStarts);
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.Rays, buffers.rays);
            if (ringHeights != null)
                step.Commands.SetComputeBufferParam(shader, kernel, Ids.RingHeights, ringHeights);
            Bind(step, kernel, tags, results);
        }

        void Bind(in StepContext step, int kernel, ParticleTags tags, GraphicsBuffer results)
        {
            CommandBuffer cmd = step.Commands;
            cmd.SetComputeBufferParam(shader, kernel, Ids.Positions, step.Particles.Positions);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Velocities, step.Particles.Velocities);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Counters, step.Particles.Counters);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Results, results);
            if (tags != null)
                cmd.SetComputeBufferParam(shader, kernel, ParticleTags.Ids.Tags, tags.Current);
        }

        static class Ids
        {
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int CellStarts = Shader.PropertyToID("_CellStarts");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
            public static readonly int Points = Shader.PropertyToID("_Points");
            public static readonly int Detectors = Shader.PropertyToID("_Detectors");
            public static readonly int Results = Shader.PropertyToID("_Results");
            public static readonly int IsSorted = Shader.PropertyToID("_IsSorted");
            public static readonly int Up = Shader.PropertyToID("_Up");
            public static readonly int RingHeights = Shader.PropertyToID("_RingHeights");
            public static readonly int HasRemoved = Shader.PropertyToID("_HasRemoved");
            public static readonly int FirstDetectorWord = Shader.PropertyToID("_FirstDetectorWord");
            public static readonly int Rays = Shader.PropertyToID("_Rays");
            public static readonly int Lines = Shader.PropertyToID("_Lines");
            public static readonly int LineCount = Shader.PropertyToID("_LineCount");
            public static readonly int FirstRayWord = Shader.PropertyToID("_FirstRayWord");
            public static readonly int FirstDetector = Shader.PropertyToID("_FirstDetector");
            public static readonly int Field = Shader.PropertyToID("_Field");
            public static readonly int DetectorCount = Shader.PropertyToID("_DetectorCount");
        }
    }

    /// <summary>Rays of a batch, and the lines that stand for them.</summary>
    struct RayBuffers
    {
        /// <summary><see cref="RayQuery"/></summary>
        public GraphicsBuffer rays;
        /// <summary>uint, the ray and the number of each line</summary>
        public GraphicsBuffer lines;
        public int rayCount, lineCount;
    }
}
