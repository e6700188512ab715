using System;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Which side of the surface a brick lies on as a whole.</summary>
    [GenerateHlsl("MeshSdf")]
    enum BrickSide { Outside, Inside, Mixed }

    /// <summary>The buffers of one bake and its dispatches; each call runs at most one, at once.</summary>
    sealed class MeshSdfPasses : IDisposable
    {
        /// <summary>where no triangle is known</summary>
        [GenerateHlsl("MeshSdf")] public const uint None = uint.MaxValue;

        /// <summary>threads of every kernel</summary>
        [GenerateHlsl("MeshSdf")] const int Group = 64;

        /// <summary>Bytes per triangle in the largest buffer that a mesh's triangles need, <see cref="PackedTriangle"/>.</summary>
        public static int BytesOfTriangle => UnsafeUtility.SizeOf<PackedTriangle>();

        /// <summary>Corners as whole float4, which load at once; a.w is 1 in those that are in _Large.</summary>
        [GenerateHlsl("MeshSdf")]
        struct PackedTriangle
        {
            public float4 a, b, c;
        }

        [GenerateHlsl("MeshSdf")]
        struct Cluster
        {
            /// <summary>center of the area, radius around all triangles</summary>
            public float4 sphere;
            /// <summary>twice the area, summed as vectors and, w, as lengths</summary>
            public float4 areaVector;
        }

        [GenerateHlsl("MeshSdf")]
        struct Box
        {
            public float3 low, high;
        }

        // Markers of each kind of dispatch, for GPU times in profilers.
        static readonly ProfilerMarker GatherMarker = GpuMarker.Create("Rill.Bake.Gather");
        static readonly ProfilerMarker DistancesMarker = GpuMarker.Create("Rill.Bake.SplatDistances");
        static readonly ProfilerMarker NearestMarker = GpuMarker.Create("Rill.Bake.SplatNearest");
        static readonly ProfilerMarker FloodMarker = GpuMarker.Create("Rill.Bake.Flood");
        static readonly ProfilerMarker ClustersMarker = GpuMarker.Create("Rill.Bake.Clusters");
        static readonly ProfilerMarker SidesMarker = GpuMarker.Create("Rill.Bake.Sides");
        static readonly ProfilerMarker ResolveMarker = GpuMarker.Create("Rill.Bake.Resolve");

        readonly ComputeShader shader = StageShader.LoadCompute("MeshSdf");
        readonly Kernel clear, gather, splatDistances, splatNearest, splatLargeDistances, splatLargeNearest, flood, buildLeaves, buildParents,
            findSides, resolveSolid, resolveShell, poseVertices;
        readonly CommandBuffer cmd;
        readonly bool executes;
        readonly SdfGrid grid;
        readonly int triangleCount;
        readonly int[] resolution;      // once, since three numbers would make an array each time
        readonly uint2[] levels;
        readonly BufferSet buffers = new BufferSet();
        GraphicsBuffer vertices, triangles, spheres, clusters, sides, distances, nearest;

        /// <param name="into">Where dispatches are recorded; null to execute each at once.</param>
        public MeshSdfPasses(BakeGeometry geometry, in SdfGrid grid, CommandBuffer into = null)
        {
            executes = into == null;
            cmd = into ?? new CommandBuffer { name = "Rill.MeshSdf" };
            this.grid = grid;
            resolution = new[] { grid.Resolution.x, grid.Resolution.y, grid.Resolution.z };
            clear = new Kernel(shader, "Clear");
            gather = new Kernel(shader, "Gather");
            splatDistances = new Kernel(shader, "SplatDistances");
            splatNearest = new Kernel(shader, "SplatNearest");
            splatLargeDistances = new Kernel(shader, "SplatLargeDistances");
            splatLargeNearest = new Kernel(shader, "SplatLargeNearest");
            flood = new Kernel(shader, "Flood");
            buildLeaves = new Kernel(shader, "BuildLeaves");
            buildParents = new Kernel(shader, "BuildParents");
            findSides = new Kernel(shader, "FindSides");
            resolveSolid = new Kernel(shader, "ResolveSolid");
            resolveShell = new Kernel(shader, "ResolveShell");
            poseVertices = new Kernel(shader, "PoseVertices");

            triangleCount = geometry.TriangleCount;
            levels = ClusterLevels.Of(triangleCount);
            try
            {
                Fill(geometry);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public int LevelCount => levels.Length;

        /// <summary>Bricks of 4³ voxels.</summary>
        public int BrickCount => BakeGeometry.BrickCount(grid.Resolution);

        /// <summary>Blocks of 4³ bricks.</summary>
        public int BlockCount => BakeGeometry.BrickCount((grid.Resolution + BakeGeometry.Brick - 1) / BakeGeometry.Brick);

        /// <summary>Bits of floats, m, once everything is resolved.</summary>
        public GraphicsBuffer Distances => distances;

        /// <summary>A <see cref="BrickSide"/> for each brick, once <see cref="FindSides"/> has run.</summary>
        public GraphicsBuffer Sides => sides;

        /// <summary>Moves the vertices, all of them, to where their bones are.</summary>
        /// <param name="rest">float3 [vertices], before bones act on them.</param>
        /// <param name="vertexBones"><see cref="DeformingField.VertexBones"/> [vertices].</param>
        /// <param name="bones">float4 [3 a bone], rows of matrices to the grid's frame, m.</param>
        public void Pose(GraphicsBuffer rest, GraphicsBuffer vertexBones, GraphicsBuffer bones, int count)
        {
            Begin(poseVertices, 0, count);
            Ids.Pose.Bind(cmd, shader, poseVertices, rest, vertexBones, bones, vertices);
            Run(poseVertices, GroupsFor(count), GatherMarker);
        }

        /// <param name="isMirrored">Whether all triangles were turned over since they were put in order.</param>
        public void Gather(int first, int count, bool isMirrored = false)
        {
            Begin(gather, first, count);
            Ids.Gather.Bind(cmd, shader, gather, isMirrored, grid.Min, 1f / grid.VoxelSize, triangles, spheres);
            Run(gather, GroupsFor(count), GatherMarker);
        }

        public void Clear()
        {
            Begin(clear, 0, (int)grid.VoxelCount);
            Run(clear, GroupsFor(grid.VoxelCount), GatherMarker);
        }

        /// <summary>Writes the distances around triangles that are not large.</summary>
        public void SplatDistances(int first, int count)
        {
            Begin(splatDistances, first, count);
            Run(splatDistances, count, DistancesMarker);
        }

        public void SplatNearest(int first, int count)
        {
            Begin(splatNearest, first, count);
            Run(splatNearest, count, NearestMarker);
        }

        public void SplatDistances(in BakeGeometry.Slice slice) => Splat(splatLargeDistances, slice, DistancesMarker);

        public void SplatNearest(in BakeGeometry.Slice slice) => Splat(splatLargeNearest, slice, NearestMarker);

        void Splat(int kernel, in BakeGeometry.Slice slice, ProfilerMarker marker)
        {
            Begin(kernel, unchecked((int)slice.First), slice.Count);
            Ids.Slice.Bind(cmd, shader, kernel, slice.Low, slice.High);
            Run(kernel, slice.Count, marker);
        }

        /// <summary>One part of a flood pass; <see cref="Swap"/> comes after the last of its parts.</summary>
        public void Flood(int stride, int first, int count)
        {
            Begin(flood, first, count);
            Ids.Flood.Bind(cmd, shader, flood, stride, nearest, distances);
            Run(flood, GroupsFor(count), FloodMarker);
        }

        /// <summary>Makes the output of a flood pass the input of the next.</summary>
        public void Swap() => buffers.Swap(ref nearest, ref distances);

        /// <summary>Levels from 0 on, one after the other.</summary>
        public void BuildClusters(int level)
        {
            int kernel = level == 0 ? buildLeaves : buildParents;
            Begin(kernel, 0, (int)levels[level].y);
            cmd.SetComputeIntParam(shader, Ids.Level, level);
            Run(kernel, GroupsFor(levels[level].y), ClustersMarker);
        }

        /// <summary>Finds the sides of bricks that lie entirely on one side of the surface, in blocks of 4³, after the flood.</summary>
        /// <param name="isClosed"><see cref="MeshEdges.IsClosed"/></param>
        public void FindSides(int firstBlock, int count, bool isClosed)
        {
            Begin(findSides, firstBlock, count);
            Ids.Sides.Bind(cmd, shader, findSides, isClosed, clusters, nearest);
            Run(findSides, count, SidesMarker);
        }

        /// <summary>Instead of <see cref="FindSides"/>, once for all bakes: each voxel of a solid asks for its side by itself.</summary>
        public void LeaveSidesToVoxels()
        {
            var all = new uint[sides.count];
            Array.Fill(all, (uint)BrickSide.Mixed);
            sides.SetData(all);
        }

        /// <summary>Bricks of a solid.</summary>
        /// <param name="into">Bits of floats, m; null for <see cref="Distances"/>.</param>
        public void ResolveSolid(int first, int count, GraphicsBuffer into = null)
        {
            Begin(resolveSolid, first, count);
            Ids.Solid.Bind(cmd, shader, resolveSolid, clusters, nearest, sides, into ?? distances);
            Run(resolveSolid, count, ResolveMarker);
        }

        /// <summary>Voxels of a shell.</summary>
        /// <param name="into">Bits of floats, m; null for <see cref="Distances"/>.</param>
        public void ResolveShell(int first, int count, GraphicsBuffer into = null)
        {
            Begin(resolveShell, first, count);
            Ids.Shell.Bind(cmd, shader, resolveShell, 0.5f * grid.Thickness / grid.VoxelSize, nearest, into ?? distances);
            Run(resolveShell, GroupsFor(count), ResolveMarker);
        }

        public void Dispose()
        {
            if (executes)
                cmd.Dispose();
            buffers.Dispose();
        }

        void Fill(BakeGeometry geometry)
        {
            TriangleMesh mesh = geometry.Mesh;
            vertices = buffers.Structured<Vector3>("Rill.MeshSdf.Vertices", mesh.Vertices.Length);
            vertices.SetData(mesh.Vertices);
            GraphicsBuffer indices = buffers.Structured<int>("Rill.MeshSdf.Indices", mesh.Triangles.Length);
            indices.SetData(mesh.Triangles);
            GraphicsBuffer order = buffers.Structured<uint>("Rill.MeshSdf.Order", triangleCount);
            order.SetData(geometry.Order);
            GraphicsBuffer large = buffers.Structured<BakeGeometry.LargeTriangle>("Rill.MeshSdf.Large", math.max(geometry.Large.Length, 1));
            if (geometry.Large.Length > 0)
                large.SetData(geometry.Large);
            triangles = buffers.Structured<PackedTriangle>("Rill.MeshSdf.Triangles", triangleCount);
            spheres = buffers.Structured<float4>("Rill.MeshSdf.Spheres", triangleCount);
            GraphicsBuffer levelTable = buffers.Structured<uint2>("Rill.MeshSdf.Levels", levels.Length);
            levelTable.SetData(levels);
            uint2 top = levels[levels.Length - 1];
            clusters = buffers.Structured<Cluster>("Rill.MeshSdf.Clusters", top.x + top.y);
            buffers.Structured<Box>("Rill.MeshSdf.Boxes", top.x + top.y);
            sides = buffers.Structured<uint>("Rill.MeshSdf.Sides", BakeGeometry.BrickCount(grid.Resolution));
            distances = buffers.Structured<uint>("Rill.MeshSdf.Distances", grid.VoxelCount);
            nearest = buffers.Structured<uint>("Rill.MeshSdf.Nearest", grid.VoxelCount);
        }

        void Begin(int kernel, int first, int count)
        {
            buffers.Bind(cmd, shader, kernel);
            cmd.SetComputeIntParams(shader, Ids.Resolution, resolution);
            Ids.Common.Bind(cmd, shader, kernel, triangleCount, levels.Length, grid.VoxelSize, first, count);
        }

        // The commands of a tool are executed one by one: a driver can then stop a device's watchdog between any two of them.
        void Run(int kernel, long groups, ProfilerMarker marker)
        {
            cmd.BeginSample(marker);
            ThreadGroups.Dispatch(cmd, shader, kernel, groups);
            cmd.EndSample(marker);
            if (!executes)
                return;
            Graphics.ExecuteCommandBuffer(cmd);
            cmd.Clear();
        }

        static long GroupsFor(long items) => (items + Group - 1) / Group;

        static class Ids
        {
            public static readonly ShaderParameters Common = new ShaderParameters("_TriangleCount", "_LevelCount", "_VoxelSize", "_First", "_Count");
            public static readonly ShaderParameters Pose = new ShaderParameters("_RestVertices", "_VertexBones", "_Bones", "_VerticesMade");
            public static readonly ShaderParameters Gather = new ShaderParameters(
                "_IsMirrored", "_Min", "_PerMeter", "_TrianglesMade", "_SpheresMade");
            public static readonly ShaderParameters Slice = new ShaderParameters("_LowTriangle", "_HighTriangle");
            public static readonly ShaderParameters Flood = new ShaderParameters("_Stride", "_NearestBefore", "_Nearest");
            public static readonly ShaderParameters Sides = new ShaderParameters("_IsClosed", "_ClustersRead", "_NearestBefore");
            public static readonly ShaderParameters Solid = new ShaderParameters("_ClustersRead", "_NearestBefore", "_SidesRead", "_Distances");
            public static readonly ShaderParameters Shell = new ShaderParameters("_HalfThickness", "_NearestBefore", "_Distances");
            public static readonly int Resolution = Shader.PropertyToID("_Resolution");
            public static readonly int Level = Shader.PropertyToID("_Level");
        }
    }
}
