using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// The signed distances of a mesh that deforms, baked again and again on the GPU: its vertices follow bones, its triangles stay. The
    /// newest two fields are kept. Nothing is read back, and no frame allocates.
    /// </summary>
    /// <remarks>The passes are those of <see cref="MeshSdfBaker"/>. What costs by the triangle can be spread over frames: the pose is taken
    /// as a whole when a bake begins.</remarks>
    sealed class DeformingField : IDisposable
    {
        /// <summary>The bones of a vertex.</summary>
        [GenerateHlsl("MeshSdf")]
        public struct VertexBones
        {
            public uint4 bones;
            public float4 weights;
        }

        readonly CommandBuffer cmd = new CommandBuffer { name = "Rill.DeformingField" };
        readonly SdfGrid grid;
        readonly DeformedMesh mesh;
        readonly MeshSdfPasses passes;
        readonly int[] strides;
        GraphicsBuffer rest, vertexBones, bones, older, newer;
        long done = -1;      // triangles of both splats; below 0 while nothing is baked

        /// <param name="mesh">Not kept by the device: its arrays may change.</param>
        /// <exception cref="InvalidOperationException">The baker's shaders are missing.</exception>
        public DeformingField(DeformedMesh mesh, in SdfGrid grid)
        {
            this.mesh = mesh;
            this.grid = grid;
            strides = MeshSdfBaker.Strides(grid.Resolution).ToArray();
            passes = new MeshSdfPasses(mesh.GeometryFor(grid), grid, cmd);
            // Bricks that lie on one side spare a large grid most sums. They are too few here to fill a GPU, which waits for them longer.
            passes.LeaveSidesToVoxels();
            rest = GpuBuffer.Structured<Vector3>("Rill.Deforming.Rest", mesh.VertexCount);
            rest.SetData(mesh.Rest);
            vertexBones = GpuBuffer.Structured<VertexBones>("Rill.Deforming.VertexBones", mesh.VertexCount);
            vertexBones.SetData(mesh.Bones);
            bones = GpuBuffer.Structured<float4>("Rill.Deforming.Bones", mesh.Rows.Length);
            older = GpuBuffer.Structured<float>("Rill.Deforming.Older", grid.VoxelCount);
            newer = GpuBuffer.Structured<float>("Rill.Deforming.Newer", grid.VoxelCount);
        }

        public int3 Resolution => grid.Resolution;

        /// <summary>float [voxels], m: the newest two that are finished. Both are the first until there is a second.</summary>
        public GraphicsBuffer Older => Version < 2 ? newer : older;
        public GraphicsBuffer Newer => newer;

        /// <summary>Fields that were finished.</summary>
        public int Version { get; private set; }

        public bool IsBaking => done >= 0;

        /// <summary>Begins a field of the mesh as it is posed now.</summary>
        public void Begin()
        {
            cmd.SetBufferData(bones, mesh.Rows);
            if (mesh.RestChanges)
                cmd.SetBufferData(rest, mesh.Rest);
            passes.Pose(rest, vertexBones, bones, mesh.VertexCount);
            passes.Gather(0, mesh.TriangleCount, mesh.IsMirrored);
            passes.Clear();
            done = 0;
        }

        /// <summary>Goes on with the field that was begun.</summary>
        /// <param name="triangles">That may be splatted now.</param>
        /// <returns>Whether it is finished.</returns>
        public bool Advance(int triangles)
        {
            long left = 2L * triangles, all = mesh.TriangleCount;
            while (left > 0 && done < 2 * all)
            {
                bool isFirst = done < all;
                int from = (int)(isFirst ? done : done - all), count = (int)math.min(left, all - from);
                if (isFirst)
                    passes.SplatDistances(from, count);
                else
                    passes.SplatNearest(from, count);
                done += count;
                left -= count;
            }
            bool isFinished = done == 2 * all;
            if (isFinished)
                Finish();
            Graphics.ExecuteCommandBuffer(cmd);
            cmd.Clear();
            return isFinished;
        }

        public void Dispose()
        {
            passes.Dispose();
            cmd.Dispose();
            GpuBuffer.Release(ref rest);
            GpuBuffer.Release(ref vertexBones);
            GpuBuffer.Release(ref bones);
            GpuBuffer.Release(ref older);
            GpuBuffer.Release(ref newer);
        }

        void Finish()
        {
            int voxels = (int)grid.VoxelCount;
            foreach (int stride in strides)
            {
                passes.Flood(stride, 0, voxels);
                passes.Swap();
            }
            if (mesh.IsShell)
                passes.ResolveShell(0, voxels, older);
            else
            {
                for (int level = 0; level < passes.LevelCount; level++)
                    passes.BuildClusters(level);
                passes.ResolveSolid(0, passes.BrickCount, older);
            }
            (older, newer) = (newer, older);
            Version++;
            done = -1;
        }
    }
}
