using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The water's surface as a closed mesh, found once a frame for all cameras, from the elements of
    /// <see cref="SurfaceParticles"/>.</summary>
    sealed class SurfaceMesh : Stage
    {
        /// <summary>Entries of _MeshCounters. What is needed is more than what there is where buffers are too small.</summary>
        [GenerateHlsl("SurfaceMesh")]
        public enum Counter { BricksNeeded, Bricks, VerticesNeeded, Vertices, QuadsNeeded, Quads, MeshedBricks, Holes, Drops }

        /// <summary>nodes of a brick along an axis</summary>
        [GenerateHlsl("SurfaceMesh")] public const int Brick = 4;

        /// <summary>bytes of a vertex: float3 position, snorm16x4 normal, half4 displacement</summary>
        [GenerateHlsl("SurfaceMesh")] public const int VertexBytes = 28;

        /// <summary>bytes in _Workspace: of the sums of a node, of a vertex while it is smoothed, of a link of its six</summary>
        [GenerateHlsl("SurfaceMesh")] const int SumBytes = 8, SmoothBytes = 16, LinkBytes = 4, LinksOfVertex = 6;

        /// <summary>byte in _MeshArguments; draws first, then groups of kernels</summary>
        [GenerateHlsl("SurfaceMesh")]
        const uint DrawAt = 0, MarkArgumentsAt = 20, AddArgumentsAt = 32, BrickArgumentsAt = 44, VertexArgumentsAt = 56, DropDrawAt = 80;

        /// <summary>byte in _MeshArguments: groups of a kernel with a thread for each droplet</summary>
        [GenerateHlsl("SurfaceMesh")] public const uint DropletArgumentsAt = 112;

        /// <summary>droplets of a particle that flies by itself</summary>
        [GenerateHlsl("SurfaceMesh")] const uint Droplets = 12;

        /// <summary>GraphicsBuffer.IndirectDrawArgs in <see cref="Arguments"/> for the drops: of one eye, and of two.</summary>
        public const int MonoDropCommand = (int)DropDrawAt / GraphicsBuffer.IndirectDrawArgs.size, StereoDropCommand = MonoDropCommand + 1;

        /// <summary>bricks in the field's texture, along x and y</summary>
        [GenerateHlsl("SurfaceMesh")] const int FieldBricks = 32;

        const int ArgumentWords = 31;
        const int BrickNodes = Brick * Brick * Brick;
        const int SmoothingPairs = 2;
        const float SmoothStep = 0.5f, SpreadStep = -0.53f;     // Taubin 1995

        /// <summary>Room for as many bricks, vertices and quads as this fraction of the particles, before more is known.</summary>
        const double FirstBricks = 0.06, FirstVertices = 0.6;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Mesh");

        readonly ComputeShader shader = StageShader.LoadCompute("SurfaceMesh");
        readonly Kernel begin, listDrops, storeDrops, markBricks, markContacts, storeBricks, clearSums, addElements, countCells,
            storeCounts, makeVertices, makeQuads, smoothMesh, smoothMeshBack, finishMesh;
        readonly KernelVariants placeBricks, findField;     // with colliders
        bool withColliders;
        readonly int top;
        readonly uint[] sizes = new uint[Enum.GetValues(typeof(Counter)).Length];
        Readback readback;
        readonly PrefixSum sumMarks;
        PrefixSum sumCounts;
        RenderTexture field;
        readonly SurfaceWorkspace workspace;
        GraphicsBuffer marks, marksBefore, meshTop, brickSlots, cellMasks, brickCounts, countsBefore, meshVertices, meshIndices, arguments,
            counters;

        /// <param name="layout">Layout of the solver.</param>
        /// <param name="workspace">Workspace of the same solver; it outlives the mesh.</param>
        /// <param name="cell">Distance of the field's nodes, d, 0.25 to 2.</param>
        /// <exception cref="ArgumentOutOfRangeException">The box has more bricks than a buffer of this device holds.</exception>
        public SurfaceMesh(SolverLayout layout, SurfaceWorkspace workspace, float cell)
        {
            this.workspace = workspace;
            Cell = cell;
            float3 nodes = math.ceil(layout.DomainSize / cell + 0.5f) + 1f;
            Bricks = (int3)math.ceil(nodes / Brick);
            long all = (long)Bricks.x * Bricks.y * Bricks.z;
            if (all + 1 > Math.Min(GpuBuffer.MaxBinding / sizeof(uint), PrefixSum.MaxCapacity))
                throw Limit.OutOfRange(nameof(cell), cell, Invariant($"The box would have {all:N0} bricks of the water's mesh, more than a ") +
                    "buffer of this device holds. Lower the quality of the surface, or shrink the box.");
            top = (int)all;
            begin = new Kernel(shader, "Begin");
            listDrops = new Kernel(shader, "ListDrops");
            storeDrops = new Kernel(shader, "StoreDrops");
            markBricks = new Kernel(shader, "MarkBricks");
            markContacts = new Kernel(shader, "MarkContacts");
            placeBricks = new KernelVariants(shader, "PlaceBricks", "PlaceBricksWithColliders");
            storeBricks = new Kernel(shader, "StoreBricks");
            clearSums = new Kernel(shader, "ClearSums");
            addElements = new Kernel(shader, "AddElements");
            findField = new KernelVariants(shader, "FindField", "FindFieldWithColliders" + KernelNeed.Wide);
            countCells = new Kernel(shader, "CountCells");
            storeCounts = new Kernel(shader, "StoreCounts");
            makeVertices = new Kernel(shader, "MakeVertices");
            makeQuads = new Kernel(shader, "MakeQuads");
            smoothMesh = new Kernel(shader, "SmoothMesh");
            smoothMeshBack = new Kernel(shader, "SmoothMeshBack");
            finishMesh = new Kernel(shader, "FinishMesh");
            try
            {
                sumMarks = new PrefixSum(StageShader.LoadCompute("PrefixSum"), top + 1);
                marks = Buffers.Structured<uint>("Rill.Mesh.Marks", top + 1);
                marksBefore = Buffers.Structured<uint>("Rill.Mesh.MarksBefore", top + 1);
                meshTop = Buffers.Structured<uint>("Rill.Mesh.Top", top, "_MeshTop");
                readback = new Readback(GpuBuffer.Structured<uint>("Rill.Mesh.Counters", Enum.GetValues(typeof(Counter)).Length));
                counters = Buffers.AddShared("Rill.Mesh.Counters", readback.Buffer, "_MeshCounters");
                arguments = Buffers.Arguments("Rill.Mesh.Arguments", ArgumentWords, property: "_MeshArguments");
                workspace.Reserve(sizeof(uint) * (long)layout.Capacity);        // for the list of drops
                BufferClear.Now(marks, counters);
                int bricks = (int)Math.Min(top, 1024 + FirstBricks * layout.Capacity), room = (int)(4096 + FirstVertices * layout.Capacity);
                Reserve(bricks, room, room);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Distance of the field's nodes, d.</summary>
        public float Cell { get; }

        /// <summary>Bricks of the box along each axis.</summary>
        public int3 Bricks { get; }

        public int BrickCapacity { get; private set; }
        public int VertexCapacity { get; private set; }
        public int QuadCapacity { get; private set; }

        /// <summary><see cref="VertexBytes"/> each, of which the first [Vertices] are set.</summary>
        public GraphicsBuffer Vertices => meshVertices;

        /// <summary>uint, 6 for each quad.</summary>
        public GraphicsBuffer Indices => meshIndices;

        /// <summary>Begins with a GraphicsBuffer.IndirectDrawIndexedArgs.</summary>
        public GraphicsBuffer Arguments => arguments;

        /// <summary>Raw: uint, indices of the elements that are drops; as many as the counters say, in any order. Until the next frame's surface
        /// is recorded.</summary>
        public GraphicsBuffer Drops => workspace.Memory;

        /// <summary>uint for each brick of the box: 0 air, 1 water, n + 2 for the brick with number n.</summary>
        public GraphicsBuffer Top => meshTop;

        /// <summary>Returns why this device cannot make the mesh; null if it can.</summary>
        public static string DeviceProblem => GpuTexture.WhyNot(RenderTextureFormat.RHalf, true);

        /// <summary>Half, 5 x 5 x 5 texels for each brick, see MeshField.hlsl: the distance of a node from the surface, d, positive in water, -2 to
        /// 2.</summary>
        public RenderTexture Field => field;

        /// <summary>uint, by <see cref="Counter"/>.</summary>
        public GraphicsBuffer Counters => counters;

        /// <summary>Makes room for meshes of up to this size; what was there is lost.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is more than the device can bind.</exception>
        public void Reserve(int bricks, int newVertices, int newQuads)
        {
            if (bricks > BrickCapacity)
            {
                sumCounts?.Dispose();
                Buffers.Release(ref brickSlots);
                EngineObject.Release(ref field);
                Buffers.Release(ref cellMasks);
                Buffers.Release(ref brickCounts);
                Buffers.Release(ref countsBefore);
                workspace.Reserve((long)SumBytes * BrickNodes * bricks);
                sumCounts = new PrefixSum(StageShader.LoadCompute("PrefixSum"), 2 * bricks + 1);
                brickSlots = Buffers.Structured<uint>("Rill.Mesh.BrickPlaces", bricks);
                field = MakeField(bricks);
                cellMasks = Buffers.Structured<uint>("Rill.Mesh.CellMasks", 2L * bricks);
                brickCounts = Buffers.Structured<uint>("Rill.Mesh.BrickCounts", 2L * bricks + 1);
                countsBefore = Buffers.Structured<uint>("Rill.Mesh.CountsBefore", 2L * bricks + 1);
                BufferClear.Now(brickCounts);
                BrickCapacity = bricks;
            }
            if (newVertices > VertexCapacity)
            {
                Buffers.Release(ref meshVertices);
                workspace.Reserve((long)(SmoothBytes + LinkBytes * LinksOfVertex) * newVertices);
                meshVertices = Buffers.Raw("Rill.Mesh.Vertices", (long)VertexBytes / sizeof(uint) * newVertices, 0, "_MeshVertices");
                VertexCapacity = newVertices;
            }
            if (newQuads > QuadCapacity)
            {
                Buffers.Release(ref meshIndices);
                meshIndices = Buffers.Raw("Rill.Mesh.Indices", 6L * newQuads, GraphicsBuffer.Target.Index, "_MeshIndices");
                QuadCapacity = newQuads;
            }
        }

        /// <summary>Asks for the size of the newest mesh, and makes room where an earlier one had too little. After its commands were
        /// executed.</summary>
        /// <returns>Whether buffers are new, and the mesh is gone.</returns>
        /// <exception cref="ArgumentOutOfRangeException">It is more than the device can bind.</exception>
        public bool Follow()
        {
            bool isNew = false;
            if (readback.HasResult)
            {
                for (int i = 0; i < sizes.Length; i++)
                    sizes[i] = readback.Latest[i];
                readback.Invalidate();
                isNew = Enlarge(sizes);
            }
            readback.Request();
            return isNew;
        }

        /// <summary>Makes room for what an earlier mesh has needed, and a quarter more.</summary>
        /// <param name="needed">The words of <see cref="Counters"/>.</param>
        /// <returns>Whether there was not enough.</returns>
        /// <exception cref="ArgumentOutOfRangeException">It is more than the device can bind.</exception>
        public bool Enlarge(uint[] needed)
        {
            long newBricks = needed[(int)Counter.BricksNeeded], newVertices = needed[(int)Counter.VerticesNeeded];
            long newQuads = needed[(int)Counter.QuadsNeeded];
            if (newBricks <= BrickCapacity && newVertices <= VertexCapacity && newQuads <= QuadCapacity)
                return false;
            Reserve(Enlarged(newBricks, BrickCapacity), Enlarged(newVertices, VertexCapacity), Enlarged(newQuads, QuadCapacity));
            return true;
        }

        static RenderTexture MakeField(int bricks)
        {
            int layers = (bricks + FieldBricks * FieldBricks - 1) / (FieldBricks * FieldBricks), most = SystemInfo.maxTexture3DSize / (Brick + 1);
            if (layers > most)
                throw Limit.OutOfRange(nameof(bricks), bricks, Invariant($"The water's mesh has more bricks than a texture of this device holds ") +
                    Invariant($"({most * FieldBricks * FieldBricks:N0}). Lower the quality of the surface."));
            const int side = FieldBricks * (Brick + 1);
            return GpuTexture.Create("Rill.Mesh.Field", new RenderTextureDescriptor(side, side, GraphicsFormat.R16_SFloat, GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex3D, volumeDepth = layers * (Brick + 1), enableRandomWrite = true,
            }, FilterMode.Bilinear);
        }

        static int Enlarged(long needed, int capacity) => needed <= capacity ? capacity : (int)Math.Min(needed + needed / 4, int.MaxValue);

        /// <summary>Records the mesh of the elements, after they are recorded.</summary>
        /// <param name="hasSteps">As the elements had it: if not, all of them are balls, and the particles are in no cells.</param>
        /// <param name="shownWalls">Walls that have quads: bit 2 a + s for that at the low (s 0) or high end of axis a.</param>
        public void Record(in StepContext step, SurfaceParticles elements, bool hasSteps, int shownWalls)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            cmd.SetComputeFloatParam(shader, Ids.MeshCell, Cell);
            cmd.SetComputeVectorParam(shader, Ids.MeshBricks, new Vector4(Bricks.x, Bricks.y, Bricks.z));
            cmd.SetComputeIntParam(shader, Ids.TopCount, top);
            cmd.SetComputeIntParam(shader, Ids.BrickCapacity, BrickCapacity);
            cmd.SetComputeIntParam(shader, Ids.VertexCapacity, VertexCapacity);
            cmd.SetComputeIntParam(shader, Ids.QuadCapacity, QuadCapacity);
            cmd.SetComputeIntParam(shader, Ids.ShownWalls, shownWalls);
            cmd.SetComputeIntParam(shader, Ids.HasCells, hasSteps ? 1 : 0);
            withColliders = elements.HasContacts;
            RecordBricks(step, elements);
            RecordField(step, elements);
            RecordCells(cmd);
            RecordVertices(step);
            RecordDrops(cmd, elements);
            cmd.EndSample(Marker);
        }

        public override void Dispose()
        {
            sumMarks?.Dispose();
            sumCounts?.Dispose();
            sumCounts = null;
            EngineObject.Release(ref field);
            readback?.Dispose();
            base.Dispose();
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(SurfaceMesh stage)
        {
            string reason = stage != null
                ? Invariant($"a component draws the surface as a mesh: after the last step of a frame, nodes {stage.Cell} d apart")
                : "no component draws the surface as a mesh";
            var description = new StageDescription("Surface mesh", stage != null, reason);
            if (stage == null)
                return description;
            description.Kernel(stage.begin, 0);
            description.Kernel(stage.markBricks, 0);
            if (stage.withColliders)
                description.Kernel(stage.markContacts, 0);
            stage.sumMarks.Describe(description, 0);
            description.Kernel(stage.placeBricks.For(stage.withColliders), 0);
            description.Kernel(stage.storeBricks, 0);
            description.Kernel(stage.clearSums, 0);
            description.Kernel(stage.addElements, 0);
            description.Kernel(stage.findField.For(stage.withColliders), 0);
            description.Kernel(stage.countCells, 0);
            stage.sumCounts.Describe(description, 0);
            description.Kernel(stage.storeCounts, 0);
            description.Kernel(stage.makeVertices, 0);
            description.Kernel(stage.makeQuads, 0);
            description.Kernel(stage.smoothMesh, 0);
            description.Kernel(stage.smoothMeshBack, 0);
            description.Kernel(stage.finishMesh, 0);
            description.Kernel(stage.listDrops, 0);
            description.Kernel(stage.storeDrops, 0);
            stage.Buffers.Describe(description);
            description.Texture(stage.field.name, 2L * stage.field.width * stage.field.height * stage.field.volumeDepth);
            return description;
        }

        void RecordBricks(in StepContext step, SurfaceParticles elements)
        {
            CommandBuffer cmd = step.Commands;
            cmd.SetComputeBufferParam(shader, begin, Ids.SurfaceCounters, elements.Counters);
            Buffers.Bind(cmd, shader, begin);
            cmd.DispatchCompute(shader, begin, 1, 1, 1);

            BindElements(cmd, markBricks, elements);
            Buffers.Bind(cmd, shader, markBricks);
            cmd.DispatchCompute(shader, markBricks, arguments, MarkArgumentsAt);
            if (withColliders)
                RecordContacts(step);
            sumMarks.Record(cmd, marks, marksBefore, top + 1);

            int kernel = placeBricks.For(withColliders);
            BindColliders(step, kernel);
            cmd.SetComputeBufferParam(shader, kernel, ParticleIds.CellStarts, step.Search.CellStarts);
            Buffers.Bind(cmd, shader, kernel);
            ThreadGroups.Dispatch(cmd, shader, kernel, ((long)top + ParticleBuffers.Group - 1) / ParticleBuffers.Group);

            Buffers.Bind(cmd, shader, storeBricks);
            cmd.DispatchCompute(shader, storeBricks, 1, 1, 1);
        }

        void RecordField(in StepContext step, SurfaceParticles elements)
        {
            CommandBuffer cmd = step.Commands;
            Buffers.Bind(cmd, shader, clearSums);
            cmd.SetComputeBufferParam(shader, clearSums, SurfaceWorkspace.Id, workspace.Memory);
            cmd.DispatchCompute(shader, clearSums, arguments, BrickArgumentsAt);

            BindElements(cmd, addElements, elements);
            Buffers.Bind(cmd, shader, addElements);
            cmd.SetComputeBufferParam(shader, addElements, SurfaceWorkspace.Id, workspace.Memory);
            cmd.DispatchCompute(shader, addElements, arguments, AddArgumentsAt);

            int find = findField.For(withColliders);
            BindColliders(step, find);
            Buffers.Bind(cmd, shader, find);
            cmd.SetComputeTextureParam(shader, find, Ids.MeshFieldOut, field);
            cmd.SetComputeBufferParam(shader, find, ParticleIds.CellStarts, step.Search.CellStarts);
            cmd.SetComputeBufferParam(shader, find, SurfaceWorkspace.Id, workspace.Memory);
            cmd.DispatchCompute(shader, find, arguments, BrickArgumentsAt);
        }

        // Bricks where particles lie on colliders, and there may be no surface.
        void RecordContacts(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            step.Particles.Bind(cmd, shader, markContacts);
            cmd.SetComputeBufferParam(shader, markContacts, SurfaceWorkspace.Id, workspace.Memory);
            Buffers.Bind(cmd, shader, markContacts);
            cmd.DispatchCompute(shader, markContacts, step.Particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
        }

        void BindColliders(in StepContext step, int kernel)
        {
            if (!withColliders)
                return;
            step.Colliders.BindShapes(step.Commands, shader, kernel);
            step.Commands.SetComputeBufferParam(shader, kernel, ParticleIds.Positions, step.Particles.Positions);
        }

        void RecordCells(CommandBuffer cmd)
        {
            BindCells(cmd, countCells);
            cmd.DispatchCompute(shader, countCells, arguments, BrickArgumentsAt);
            sumCounts.Record(cmd, brickCounts, countsBefore, 2 * BrickCapacity + 1);

            Buffers.Bind(cmd, shader, storeCounts);
            cmd.DispatchCompute(shader, storeCounts, 1, 1, 1);

            BindCells(cmd, makeVertices);
            cmd.SetComputeBufferParam(shader, makeVertices, SurfaceWorkspace.Id, workspace.Memory);
            cmd.DispatchCompute(shader, makeVertices, arguments, BrickArgumentsAt);

            BindCells(cmd, makeQuads);
            cmd.DispatchCompute(shader, makeQuads, arguments, BrickArgumentsAt);
        }

        void RecordVertices(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            for (int pair = 0; pair < SmoothingPairs; pair++)
            {
                RecordSmoothing(cmd, smoothMesh, SmoothStep);
                RecordSmoothing(cmd, smoothMeshBack, SpreadStep);
            }
            BindVertices(cmd, finishMesh);
            cmd.SetComputeBufferParam(shader, finishMesh, ParticleIds.Positions, step.Particles.Positions);
            cmd.SetComputeBufferParam(shader, finishMesh, ParticleIds.CellStarts, step.Search.CellStarts);
            cmd.DispatchCompute(shader, finishMesh, arguments, VertexArgumentsAt);
        }

        // Last, as the list stays in the workspace while it is drawn.
        void RecordDrops(CommandBuffer cmd, SurfaceParticles elements)
        {
            cmd.SetComputeIntParam(shader, Ids.DropCapacity, Drops.count);
            BindElements(cmd, listDrops, elements);
            Buffers.Bind(cmd, shader, listDrops);
            cmd.SetComputeBufferParam(shader, listDrops, SurfaceWorkspace.Id, workspace.Memory);
            cmd.DispatchCompute(shader, listDrops, arguments, MarkArgumentsAt);
            Buffers.Bind(cmd, shader, storeDrops);
            cmd.DispatchCompute(shader, storeDrops, 1, 1, 1);
        }

        void RecordSmoothing(CommandBuffer cmd, int kernel, float smoothStep)
        {
            cmd.SetComputeFloatParam(shader, Ids.SmoothStep, smoothStep);
            BindVertices(cmd, kernel);
            cmd.DispatchCompute(shader, kernel, arguments, VertexArgumentsAt);
        }

        void BindVertices(CommandBuffer cmd, int kernel)
        {
            Buffers.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, SurfaceWorkspace.Id, workspace.Memory);
        }

        void BindElements(CommandBuffer cmd, int kernel, SurfaceParticles elements)
        {
            cmd.SetComputeBufferParam(shader, kernel, Ids.Surface, elements.Particles);
            cmd.SetComputeBufferParam(shader, kernel, Ids.SurfaceCounters, elements.Counters);
        }

        void BindCells(CommandBuffer cmd, int kernel)
        {
            Buffers.Bind(cmd, shader, kernel);
            cmd.SetComputeTextureParam(shader, kernel, Ids.MeshField, field);
        }

        static class Ids
        {
            public static readonly int MeshCell = Shader.PropertyToID("_MeshCell");
            public static readonly int MeshBricks = Shader.PropertyToID("_MeshBricks");
            public static readonly int TopCount = Shader.PropertyToID("_TopCount");
            public static readonly int BrickCapacity = Shader.PropertyToID("_BrickCapacity");
            public static readonly int VertexCapacity = Shader.PropertyToID("_VertexCapacity");
            public static readonly int QuadCapacity = Shader.PropertyToID("_QuadCapacity");
            public static readonly int ShownWalls = Shader.PropertyToID("_ShownWalls");
            public static readonly int DropCapacity = Shader.PropertyToID("_DropCapacity");
            public static readonly int HasCells = Shader.PropertyToID("_HasCells");
            public static readonly int SmoothStep = Shader.PropertyToID("_SmoothStep");
            public static readonly int Surface = Shader.PropertyToID("_Surface");
            public static readonly int SurfaceCounters = Shader.PropertyToID("_SurfaceCounters");
            public static readonly int MeshField = Shader.PropertyToID("_MeshField");
            public static readonly int MeshFieldOut = Shader.PropertyToID("_MeshFieldOut");
        }
    }
}
