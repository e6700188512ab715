using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The buffers of one bake and its dispatches; each call runs at most one, at once.</summary>
    sealed class MeshSdfPasses : IDisposable
    {
        // Threads of every kernel; kGroup in MeshSdf.compute.
        const int Group = 64;
        const int MostGroups = 65535;
        // Cluster in MeshSdf.compute.
        struct Cluster
        {
            public float4 centerRadius, areaVectorArea;
        }

        // Of each kind of dispatch, for GPU times in profilers.
        static readonly ProfilerMarker ClearMarker = GpuMarker.Create("Rill.Bake.Clear");
        static readonly ProfilerMarker DistancesMarker = GpuMarker.Create("Rill.Bake.SplatDistances");
        static readonly ProfilerMarker NearestMarker = GpuMarker.Create("Rill.Bake.SplatNearest");
        static readonly ProfilerMarker FloodMarker = GpuMarker.Create("Rill.Bake.Flood");
        static readonly ProfilerMarker ClustersMarker = GpuMarker.Create("Rill.Bake.Clusters");
        static readonly ProfilerMarker SidesMarker = GpuMarker.Create("Rill.Bake.Sides");
        static readonly ProfilerMarker ResolveMarker = GpuMarker.Create("Rill.Bake.Resolve");

        readonly ComputeShader shader = StageShader.LoadCompute("MeshSdf");
        readonly int clear, splatDistances, splatNearest, flood, buildLeaves, buildParents, findSides, resolveSolid, resolveShell;
        readonly CommandBuffer cmd = new CommandBuffer { name = "Rill.MeshSdf" };
        readonly SdfGrid grid;
        readonly int triangleCount;
        readonly uint2[] levels;
        GraphicsBuffer triangles, firstPairs, levelTable, clusters, sides, distances, nearest;

        public MeshSdfPasses(BakeGeometry geometry, in SdfGrid grid)
        {
            this.grid = grid;
            clear = shader.FindKernel("Clear");
            splatDistances = shader.FindKernel("SplatDistances");
            splatNearest = shader.FindKernel("SplatNearest");
            flood = shader.FindKernel("Flood");
            buildLeaves = shader.FindKernel("BuildLeaves");
            buildParents = shader.FindKernel("BuildParents");
            findSides = shader.FindKernel("FindSides");
            resolveSolid = shader.FindKernel("ResolveSolid");
            resolveShell = shader.FindKernel("ResolveShell");

            triangleCount = geometry.Triangles.Length;
            levels = ClusterLevels.Of(triangleCount);
            triangles = GpuBuffer.Structured<BakeGeometry.Triangle>("Rill.MeshSdf.Triangles", triangleCount);
            triangles.SetData(geometry.Triangles);
            firstPairs = GpuBuffer.Structured<uint>("Rill.MeshSdf.FirstPairs", triangleCount);
            firstPairs.SetData(geometry.FirstPairs);
            levelTable = GpuBuffer.Structured<uint2>("Rill.MeshSdf.Levels", levels.Length);
            levelTable.SetData(levels);
            uint2 top = levels[levels.Length - 1];
            clusters = GpuBuffer.Structured<Cluster>("Rill.MeshSdf.Clusters", top.x + top.y);
            sides = GpuBuffer.Structured<uint>("Rill.MeshSdf.Sides", BrickCount);
            distances = GpuBuffer.Structured<uint>("Rill.MeshSdf.Distances", grid.VoxelCount);
            nearest = GpuBuffer.Structured<uint>("Rill.MeshSdf.Nearest", grid.VoxelCount);
        }

        public int LevelCount => levels.Length;

        /// <summary>Bricks of 4³ voxels.</summary>
        public int BrickCount => BakeGeometry.BrickCount(grid.Resolution);

        /// <summary>Bits of floats, m, once everything is resolved.</summary>
        public GraphicsBuffer Distances => distances;

        public void Clear()
        {
            Begin(0, (int)grid.VoxelCount);
            Bind(clear, Ids.Distances, distances);
            Bind(clear, Ids.Nearest, nearest);
            Run(clear, GroupsFor(grid.VoxelCount), ClearMarker);
        }

        public void SplatDistances(in BakeGeometry.Slice slice) => Splat(splatDistances, slice, DistancesMarker);

        public void SplatNearest(in BakeGeometry.Slice slice)
        {
            Bind(splatNearest, Ids.Nearest, nearest);
            Splat(splatNearest, slice, NearestMarker);
        }

        void Splat(int kernel, in BakeGeometry.Slice slice, ProfilerMarker marker)
        {
            Begin(unchecked((int)slice.First), slice.Count);
            cmd.SetComputeIntParam(shader, Ids.LowTriangle, slice.LowTriangle);
            cmd.SetComputeIntParam(shader, Ids.HighTriangle, slice.HighTriangle);
            Bind(kernel, Ids.Triangles, triangles);
            Bind(kernel, Ids.FirstPairs, firstPairs);
            Bind(kernel, Ids.Distances, distances);
            Run(kernel, slice.Count, marker);
        }

        /// <summary>One part of a flood pass; <see cref="Swap"/> comes after the last of its parts.</summary>
        public void Flood(int stride, int first, int count)
        {
            Begin(first, count);
            cmd.SetComputeIntParam(shader, Ids.Stride, stride);
            Bind(flood, Ids.Triangles, triangles);
            Bind(flood, Ids.NearestBefore, nearest);
            Bind(flood, Ids.Nearest, distances);
            Run(flood, GroupsFor(count), FloodMarker);
        }

        /// <summary>What a flood pass wrote is what the next pass reads.</summary>
        public void Swap() => (nearest, distances) = (distances, nearest);

        /// <summary>Levels from 0 on, one after the other.</summary>
        public void BuildClusters(int level)
        {
            Begin(0, (int)levels[level].y);
            int kernel = level == 0 ? buildLeaves : buildParents;
            cmd.SetComputeIntParam(shader, Ids.Level, level);
            if (level == 0)
                Bind(kernel, Ids.Triangles, triangles);
            Bind(kernel, Ids.Levels, levelTable);
            Bind(kernel, Ids.Clusters, clusters);
            Run(kernel, GroupsFor(levels[level].y), ClustersMarker);
        }

        /// <summary>Of bricks that lie on one side of the surface as a whole; once the flood is over.</summary>
        public void FindSides(int first, int count)
        {
            Begin(first, count);
            BindTree(findSides);
            Bind(findSides, Ids.NearestBefore, nearest);
            Bind(findSides, Ids.Sides, sides);
            Run(findSides, GroupsFor(count), SidesMarker);
        }

        /// <summary>Bricks of a solid.</summary>
        public void ResolveSolid(int first, int count)
        {
            Begin(first, count);
            BindTree(resolveSolid);
            Bind(resolveSolid, Ids.NearestBefore, nearest);
            Bind(resolveSolid, Ids.SidesRead, sides);
            Bind(resolveSolid, Ids.Distances, distances);
            Run(resolveSolid, count, ResolveMarker);
        }

        /// <summary>Voxels of a shell.</summary>
        public void ResolveShell(int first, int count)
        {
            Begin(first, count);
            cmd.SetComputeFloatParam(shader, Ids.HalfThickness, 0.5f * grid.Thickness / grid.VoxelSize);
            Bind(resolveShell, Ids.Triangles, triangles);
            Bind(resolveShell, Ids.NearestBefore, nearest);
            Bind(resolveShell, Ids.Distances, distances);
            Run(resolveShell, GroupsFor(count), ResolveMarker);
        }

        void BindTree(int kernel)
        {
            Bind(kernel, Ids.Triangles, triangles);
            Bind(kernel, Ids.Levels, levelTable);
            Bind(kernel, Ids.ClustersRead, clusters);
        }

        public void Dispose()
        {
            cmd.Dispose();
            GpuBuffer.Release(ref triangles);
            GpuBuffer.Release(ref firstPairs);
            GpuBuffer.Release(ref levelTable);
            GpuBuffer.Release(ref clusters);
            GpuBuffer.Release(ref sides);
            GpuBuffer.Release(ref distances);
            GpuBuffer.Release(ref nearest);
        }

        void Begin(int first, int count)
        {
            cmd.SetComputeIntParam(shader, Ids.TriangleCount, triangleCount);
            cmd.SetComputeIntParams(shader, Ids.Resolution, grid.Resolution.x, grid.Resolution.y, grid.Resolution.z);
            cmd.SetComputeIntParam(shader, Ids.First, first);
            cmd.SetComputeIntParam(shader, Ids.Count, count);
            cmd.SetComputeIntParam(shader, Ids.LevelCount, levels.Length);
            cmd.SetComputeFloatParam(shader, Ids.VoxelSize, grid.VoxelSize);
        }

        void Bind(int kernel, int id, GraphicsBuffer buffer) => cmd.SetComputeBufferParam(shader, kernel, id, buffer);

        // Executed at once and not with others: a driver can then stop a device's watchdog between any two of them.
        void Run(int kernel, long groups, ProfilerMarker marker)
        {
            cmd.BeginSample(marker);
            cmd.DispatchCompute(shader, kernel, (int)math.min(groups, MostGroups), (int)((groups + MostGroups - 1) / MostGroups), 1);
            cmd.EndSample(marker);
            Graphics.ExecuteCommandBuffer(cmd);
            cmd.Clear();
        }

        static long GroupsFor(long items) => (items + Group - 1) / Group;

        static class Ids
        {
            public static readonly int Triangles = Shader.PropertyToID("_Triangles");
            public static readonly int FirstPairs = Shader.PropertyToID("_FirstPairs");
            public static readonly int Levels = Shader.PropertyToID("_Levels");
            public static readonly int NearestBefore = Shader.PropertyToID("_NearestBefore");
            public static readonly int Distances = Shader.PropertyToID("_Distances");
            public static readonly int Nearest = Shader.PropertyToID("_Nearest");
            public static readonly int Clusters = Shader.PropertyToID("_Clusters");
            public static readonly int ClustersRead = Shader.PropertyToID("_ClustersRead");
            public static readonly int Sides = Shader.PropertyToID("_Sides");
            public static readonly int SidesRead = Shader.PropertyToID("_SidesRead");
            public static readonly int TriangleCount = Shader.PropertyToID("_TriangleCount");
            public static readonly int Resolution = Shader.PropertyToID("_Resolution");
            public static readonly int First = Shader.PropertyToID("_First");
            public static readonly int Count = Shader.PropertyToID("_Count");
            public static readonly int LowTriangle = Shader.PropertyToID("_LowTriangle");
            public static readonly int HighTriangle = Shader.PropertyToID("_HighTriangle");
            public static readonly int Stride = Shader.PropertyToID("_Stride");
            public static readonly int Level = Shader.PropertyToID("_Level");
            public static readonly int LevelCount = Shader.PropertyToID("_LevelCount");
            public static readonly int HalfThickness = Shader.PropertyToID("_HalfThickness");
            public static readonly int VoxelSize = Shader.PropertyToID("_VoxelSize");
        }
    }
}
