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

        /// <summary>densities of a line that a group finds at once</summary>
        [GenerateHlsl("Queries")] const int Samples = 64;

        const string Name = "Queries";
        const float ChunkLength = 0.5f * (Samples - 1);        // as in SurfaceLines.hlsl, d
        const int SearchGroups = 1024;      // that search lines at once, if there are not more lines: about what a large GPU holds

        readonly ComputeShader shader = StageShader.LoadCompute(Name);
        readonly Kernel findSurface, answerPoints, searchLines, answerRays, detect, detectMesh;
        readonly LocalKeyword withTags;

        public QueryShader()
        {
            findSurface = new Kernel(shader, "FindSurface");
            answerPoints = new Kernel(shader, "AnswerPoints");
            searchLines = new Kernel(shader, "SearchLines");
            answerRays = new Kernel(shader, "AnswerRays");
            detect = new Kernel(shader, "Detect");
            detectMesh = new Kernel(shader, "DetectMesh");
            withTags = new LocalKeyword(shader, ParticleTags.Keyword);
        }

        /// <summary>Whether particles were removed since the last step: positions that are not finite are looked for only then.</summary>
        public bool HasRemoved { get; set; }

        /// <summary>Records the search for the surface along gravity at points. <see cref="AnswerPoints"/> needs it.</summary>
        public void SearchPoints(in StepContext step, ParticleTags tags, in PointBuffers buffers)
        {
            if (math.all(buffers.up == 0f))
                return;
            BeginPoints(step, findSurface, tags, buffers);
            Search(step.Commands, findSurface, buffers.count, Chunks(math.dot(math.abs(buffers.up), step.Layout.DomainSize)));
        }

        /// <summary>Records what is at points: density, velocity, phase, and the surface along gravity.</summary>
        /// <param name="results">uint, <see cref="Queries.ProbeWords"/> for each point.</param>
        public void AnswerPoints(in StepContext step, ParticleTags tags, in PointBuffers buffers, GraphicsBuffer results)
        {
            BeginPoints(step, answerPoints, tags, buffers);
            BindAnswers(step, answerPoints, tags, results);
            step.Commands.DispatchCompute(shader, answerPoints, buffers.count, 1, 1);
        }

        /// <summary>Records the search for where rays and balls cross the surface. <see cref="AnswerRays"/> needs it.</summary>
        public void SearchRays(in StepContext step, ParticleTags tags, in RayBuffers buffers)
        {
            BeginRays(step, searchLines, tags, buffers);
            Ids.LinesOfRays.Bind(step.Commands, shader, searchLines, buffers.lineCount, buffers.lines);
            // One sample more than the length: it tells where the water ends at a wall.
            Search(step.Commands, searchLines, buffers.lineCount, Chunks(buffers.length + 1f));
        }

        /// <summary>Records where rays and balls cross the surface, and density, velocity and phase at that point.</summary>
        /// <param name="firstWord">First word of the results, from which on there are <see cref="RayQuery.RayWords"/> for each ray.</param>
        public void AnswerRays(in StepContext step, ParticleTags tags, in RayBuffers buffers, GraphicsBuffer results, int firstWord)
        {
            BeginRays(step, answerRays, tags, buffers);
            step.Commands.SetComputeIntParam(shader, Ids.FirstRayWord, firstWord);
            BindAnswers(step, answerRays, tags, results);
            step.Commands.DispatchCompute(shader, answerRays, buffers.rayCount, 1, 1);
        }

        /// <summary>Records what is in shapes: all that need no field at once, then each mesh, since a kernel cannot choose among
        /// textures.</summary>
        /// <param name="detectors"><see cref="DetectorRegion"/>, those that are meshes last.</param>
        /// <param name="results">uint, from a word on <see cref="Queries.DetectorWords"/> for each shape, 0 at entry.</param>
        /// <param name="fields">Fields of the meshes, at their indices among all.</param>
        public void RecordDetectors(in StepContext step, ParticleTags tags, GraphicsBuffer detectors, GraphicsBuffer results, int firstWord,
            int simpleCount, Texture3D[] fields, int meshCount)
        {
            if (simpleCount > 0)
                Detect(step, detect, tags, detectors, results, 0, simpleCount, firstWord);
            for (int i = simpleCount; i < simpleCount + meshCount; i++)
                Detect(step, detectMesh, tags, detectors, results, i, 1, firstWord, fields[i]);
        }

        public void DescribePoints(StageDescription description, ParticleTags tags)
        {
            description.Kernel(findSurface, 0, Variant(tags));
            description.Kernel(answerPoints, 0, Variant(tags));
        }

        public void DescribeRays(StageDescription description, ParticleTags tags)
        {
            description.Kernel(searchLines, 0, Variant(tags));
            description.Kernel(answerRays, 0, Variant(tags));
        }

        public void DescribeDetectors(StageDescription description, ParticleTags tags, int simpleCount, int meshCount)
        {
            if (simpleCount > 0)
                description.Kernel(detect, 0, Variant(tags));
            if (meshCount > 0)
                description.Kernel(detectMesh, 0, Variant(tags));
        }

        static string Variant(ParticleTags tags) => tags != null ? ParticleTags.Keyword : null;

        // Chunks of a line of this length, d. A line through the box is never longer than its sides together.
        static int Chunks(float length) => math.max((int)math.ceil(length / ChunkLength), 1);

        void Begin(in StepContext step, int kernel, ParticleTags tags)
        {
            step.BindConstants(shader);
            step.Commands.SetKeyword(shader, withTags, tags != null);
            Ids.State.Bind(step.Commands, shader, kernel, step.Search.IsSorted, HasRemoved);
            step.Particles.Bind(step.Commands, shader, kernel);
        }

        void Detect(in StepContext step, int kernel, ParticleTags tags, GraphicsBuffer detectors, GraphicsBuffer results, int first, int count,
            int firstWord, Texture3D field = null)
        {
            const int PerGroup = ParticleBuffers.Group * ParticlesPerThread;
            CommandBuffer cmd = step.Commands;
            Begin(step, kernel, tags);
            Ids.Detect.Bind(cmd, shader, kernel, first, count, firstWord + first * Queries.DetectorWords, detectors, field);
            BindAnswers(step, kernel, tags, results);
            cmd.DispatchCompute(shader, kernel, (step.Layout.Capacity + PerGroup - 1) / PerGroup, 1, 1);
        }

        // A group for each chunk of few lines; of many a group takes several chunks of a line in turn, and leaves out what is beyond the surface.
        void Search(CommandBuffer cmd, int kernel, int lines, int chunks)
        {
            int perLine = math.clamp(SearchGroups / lines, 1, chunks), perRow = math.min(lines, ThreadGroups.MaxGroups);
            Ids.Search.Bind(cmd, shader, kernel, perLine, (chunks + perLine - 1) / perLine);
            cmd.DispatchCompute(shader, kernel, perRow, perLine, (lines + perRow - 1) / perRow);
        }

        void BeginPoints(in StepContext step, int kernel, ParticleTags tags, in PointBuffers buffers)
        {
            Begin(step, kernel, tags);
            Ids.Points.Bind(step.Commands, shader, kernel, buffers.up, buffers.points, buffers.found, step.Search.CellStarts);
        }

        void BeginRays(in StepContext step, int kernel, ParticleTags tags, in RayBuffers buffers)
        {
            Begin(step, kernel, tags);
            Ids.Rays.Bind(step.Commands, shader, kernel, buffers.up, buffers.rays, buffers.found, step.Search.CellStarts);
        }

        void BindAnswers(in StepContext step, int kernel, ParticleTags tags, GraphicsBuffer results)
            => Ids.Answers.Bind(step.Commands, shader, kernel, results, tags?.Current);

        static class Ids
        {
            public static readonly ShaderParameters State = new ShaderParameters("_IsSorted", "_HasRemoved");
            public static readonly ShaderParameters Points = new ShaderParameters("_Up", "_Points", "_Found", "_CellStarts");
            public static readonly ShaderParameters Rays = new ShaderParameters("_Up", "_Rays", "_Found", "_CellStarts");
            public static readonly ShaderParameters LinesOfRays = new ShaderParameters("_LineCount", "_Lines");
            public static readonly ShaderParameters Search = new ShaderParameters("_GroupsPerLine", "_ChunksPerGroup");
            public static readonly ShaderParameters Detect = new ShaderParameters(
                "_FirstDetector", "_DetectorCount", "_FirstDetectorWord", "_Detectors", "_Field");
            public static readonly ShaderParameters Answers = new ShaderParameters("_Results", "_Tags");
            public static readonly int FirstRayWord = Shader.PropertyToID("_FirstRayWord");
        }
    }

    /// <summary>Points that are asked, and what is found for them.</summary>
    struct PointBuffers
    {
        /// <summary>float4, xyz within the domain, d</summary>
        public GraphicsBuffer points;
        /// <summary>uint for each point; 0 before the search and after the answer</summary>
        public GraphicsBuffer found;
        /// <summary>1 to <see cref="ThreadGroups.MaxGroups"/></summary>
        public int count;
        /// <summary>against gravity, length 1; 0 without gravity</summary>
        public float3 up;
    }

    /// <summary>Rays of a batch, the lines that stand for them, and what is found for them.</summary>
    struct RayBuffers
    {
        /// <summary><see cref="RayQuery"/></summary>
        public GraphicsBuffer rays;
        /// <summary>uint, the ray and the number of each line</summary>
        public GraphicsBuffer lines;
        /// <summary>uint for each ray; 0 before the search and after the answer</summary>
        public GraphicsBuffer found;
        public int rayCount, lineCount;
        /// <summary>at least that of each ray in the box, d</summary>
        public float length;
        /// <summary>against gravity, length 1; 0 without gravity</summary>
        public float3 up;
    }
}
