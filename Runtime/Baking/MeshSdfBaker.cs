using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// Turns triangles into a signed distance field on the GPU, in slices of work: <see cref="Step"/> once a frame or as often
    /// as it suits until <see cref="Result"/> is there, or <see cref="Bake(Mesh, in MeshSdfSettings, Func{float, string, bool})"/> for all at once.
    /// Works in the editor, in players and without a window, on any device with compute shaders.
    /// </summary>
    /// <remarks>
    /// Within two voxels of a triangle the distance is exact: every triangle is tested against the voxels around it. Beyond,
    /// the nearest triangle is passed on by jump flooding (Rong and Tan 2006), and the distance to it is exact again. Inside
    /// is where the generalized winding number (Jacobson et al. 2013), summed over a tree of triangle clusters (Barill et al.
    /// 2018), is above one half. Two bakes of the same triangles on one device give the same bits. Documentation~/baking.md
    /// has the measured errors.
    /// </remarks>
    public sealed class MeshSdfBaker : IDisposable
    {
        /// <summary><see cref="Stage"/> once all dispatches are made.</summary>
        internal const string ReadingBack = "Reading back";

        /// <summary>The most work of one dispatch.</summary>
        internal struct StepSize
        {
            /// <summary>Pairs of a large triangle and a brick of 64 voxels.</summary>
            public int pairs;
            /// <summary>Blocks have 64 bricks.</summary>
            public int triangles, voxels, bricks, blocks;

            /// <summary>A few ten milliseconds on a slow GPU; Windows resets one that takes two seconds.</summary>
            public static StepSize Default => new StepSize
            {
                pairs = 1 << 19, triangles = 1 << 17, voxels = 1 << 22, bricks = 1 << 14,
                blocks = 1 << 11
            };
        }

        readonly StepSize size;
        readonly TriangleMesh mesh;
        readonly MeshSdfSettings settings;
        readonly MeshSdfSign sign;
        readonly SdfGrid grid;
        readonly BakeGeometry geometry;
        readonly MeshSdfPasses passes;
        readonly IEnumerator<string> work;
        readonly int totalSteps;
        readonly ulong sourceHash;
        int steps;
        NativeArray<float> arriving;
        AsyncGPUReadbackRequest readback;
        bool isReading, isDisposed;

        /// <summary>Prepares a bake; most of the work is left to <see cref="Step"/>.</summary>
        /// <exception cref="ArgumentNullException">The mesh is null.</exception>
        /// <exception cref="ArgumentException">The mesh or the settings cannot be baked; the message says which, the limit and the
        /// remedy.</exception>
        /// <exception cref="InvalidOperationException">This device has no compute shaders or no asynchronous readback, or the baker's
        /// shaders are missing.</exception>
        public MeshSdfBaker(TriangleMesh mesh, in MeshSdfSettings settings) : this(mesh, settings, StepSize.Default) { }

        internal MeshSdfBaker(TriangleMesh mesh, in MeshSdfSettings settings, StepSize size)
        {
            this.size = size;
            TriangleMesh whole = mesh ?? throw new ArgumentNullException(nameof(mesh), "No mesh to bake: assign one.");
            this.mesh = mesh = settings.leaveOutFar ? FarTriangles.LeftOut(whole) : whole;
            this.settings = settings;
            if (!SystemInfo.supportsComputeShaders || !SystemInfo.supportsAsyncGPUReadback)
                throw new InvalidOperationException(
                    "Rill: this device has no compute shaders or no asynchronous readback: bake on another, and ship the asset.");
            BakedTriangles triangles = Usable(mesh, settings);
            // Which side a triangle faces, and what it hangs together with, is nothing to a shell.
            bool needsEdges = settings.sign != MeshSdfSign.OpenShell;
            MeshEdges edges = null;
            uint[] order = null;
            ulong hash = 0;
            Chunks.Together(() => edges = needsEdges ? new MeshEdges(triangles) : null, () => order = TriangleOrder.Of(triangles),
                () => hash = whole.Hash());
            sourceHash = hash;
            sign = settings.sign == MeshSdfSign.Automatic ? MeshReport.SignOf(edges) : settings.sign;
            bool isShell = sign == MeshSdfSign.OpenShell;
            grid = new SdfGrid(triangles.Bounds, settings, isShell);
            string problem = new MeshSdfEstimate(grid, mesh.TriangleCount, settings).Problem;
            if (problem != null)
                throw new ArgumentException($"'{mesh.Name}' cannot be baked. {problem}", nameof(settings));

            geometry = new BakeGeometry(mesh, order, edges?.Turned, grid, turnAll: !isShell && edges.SignedVolume < 0);
            passes = new MeshSdfPasses(geometry, grid);
            int triangleParts = Parts(geometry.TriangleCount, size.triangles), voxelParts = Parts(grid.VoxelCount, size.voxels);
            totalSteps = 2 + 3 * triangleParts + 2 * Parts(geometry.PairCount, size.pairs) + Strides(grid.Resolution).Count * voxelParts
                + (isShell ? voxelParts : passes.LevelCount + Parts(passes.BlockCount, size.blocks) + Parts(passes.BrickCount, size.bricks));
            work = Work(isShell, !isShell && edges.IsClosed);
        }

        /// <summary>Until the result is there.</summary>
        internal MeshSdfPasses Passes => passes;

        /// <summary>Fraction of the work that is done, 0 to 1.</summary>
        public float Progress => IsDone ? 1f : (float)steps / totalSteps;

        /// <summary>Current work, for a progress bar.</summary>
        public string Stage { get; private set; } = "";

        /// <summary>Result of the bake; null until it is done.</summary>
        public SdfBake Result { get; private set; }

        /// <summary>Whether the bake is done and <see cref="Result"/> is there.</summary>
        public bool IsDone => Result != null;

        /// <summary>Does one slice of the work: at most one dispatch, which no GPU takes long for.</summary>
        /// <returns>Whether there is more to do. While the result is read back that is so without work being done.</returns>
        /// <exception cref="ObjectDisposedException">The bake was canceled.</exception>
        public bool Step()
        {
            if (IsDone)
                return false;
            if (isDisposed)
                throw new ObjectDisposedException(nameof(MeshSdfBaker), $"The bake of '{mesh.Name}' was canceled.");
            if (!isReading && work.MoveNext())
            {
                Stage = work.Current;
                steps++;
                return true;
            }
            if (!isReading)
            {
                Stage = ReadingBack;
                arriving = new NativeArray<float>((int)grid.VoxelCount, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
                readback = AsyncGPUReadback.RequestIntoNativeArray(ref arriving, passes.Distances);
                isReading = true;
                steps++;
            }
            // Without frames, as in an idle editor, nothing else checks whether it has arrived.
            readback.Update();
            if (!readback.done)
                return true;
            Finish();
            return false;
        }

        /// <summary>Does the rest of the work and waits for it.</summary>
        public SdfBake Complete()
        {
            while (Step())
                if (isReading)
                    readback.WaitForCompletion();
            return Result;
        }

        /// <summary>Cancels the bake, if it is not done, and gives back its memory. The result stays.</summary>
        public void Dispose()
        {
            if (isDisposed)
                return;
            isDisposed = true;
            // The memory that a read-back fills must outlive it.
            if (isReading && !readback.done)
                readback.WaitForCompletion();
            if (arriving.IsCreated)
                arriving.Dispose();
            passes.Dispose();
        }

        /// <summary>Bakes all submeshes of a mesh and waits for the result: a tool, not for a frame of a game.</summary>
        /// <param name="progress">Told the fraction that is done and the stage, and asked whether to go on; null for neither.</param>
        /// <returns>Null if it was canceled.</returns>
        public static SdfBake Bake(Mesh mesh, in MeshSdfSettings settings, Func<float, string, bool> progress = null)
            => Bake(TriangleMesh.Of(mesh), settings, progress);

        /// <inheritdoc cref="Bake(Mesh, in MeshSdfSettings, Func{float, string, bool})"/>
        public static SdfBake Bake(TriangleMesh mesh, in MeshSdfSettings settings, Func<float, string, bool> progress = null)
        {
            using (var baker = new MeshSdfBaker(mesh, settings))
            {
                // Each step is told, also one after which the result is there at once.
                while (!baker.isReading)
                {
                    baker.Step();
                    if (progress != null && !progress(baker.Progress, baker.Stage))
                        return null;
                }
                return baker.Complete();
            }
        }

        /// <summary>Estimates a bake. Reads the whole mesh where the sign is automatic, to see whether it is open.</summary>
        /// <exception cref="ArgumentException">The mesh or the settings cannot be baked at any size.</exception>
        public static MeshSdfEstimate Estimate(TriangleMesh mesh, in MeshSdfSettings settings)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            if (settings.leaveOutFar)
                mesh = FarTriangles.LeftOut(mesh);
            BakedTriangles triangles = Usable(mesh, settings);
            MeshSdfSign sign = settings.sign == MeshSdfSign.Automatic ? MeshReport.SignOf(new MeshEdges(triangles)) : settings.sign;
            return new MeshSdfEstimate(new SdfGrid(triangles.Bounds, settings, sign == MeshSdfSign.OpenShell), mesh.TriangleCount, settings);
        }

        /// <summary>Estimates a bake of a checked mesh without reading it: for a window whose settings are being dragged.</summary>
        /// <exception cref="ArgumentException">The mesh or the settings cannot be baked at any size.</exception>
        public static MeshSdfEstimate Estimate(MeshReport report, in MeshSdfSettings settings)
        {
            if (report == null)
                throw new ArgumentNullException(nameof(report));
            RequireValid(report.Name, settings);
            report = report.Of(settings);
            if (report.Problem != null)
                throw new ArgumentException(report.Problem, nameof(report));
            MeshSdfSign sign = settings.sign == MeshSdfSign.Automatic ? report.Sign : settings.sign;
            return new MeshSdfEstimate(new SdfGrid(report.Bounds, settings, sign == MeshSdfSign.OpenShell), report.Triangles, settings);
        }

        static BakedTriangles Usable(TriangleMesh mesh, in MeshSdfSettings settings)
        {
            RequireValid(mesh.Name, settings);
            var triangles = new BakedTriangles(mesh);
            string problem = MeshReport.ProblemOf(triangles);
            return problem == null ? triangles : throw new ArgumentException(problem, nameof(mesh));
        }

        static void RequireValid(string name, in MeshSdfSettings settings)
        {
            if (!settings.Validate(out string problem))
                throw new ArgumentException($"'{name}' cannot be baked. {problem}", nameof(settings));
        }

        // The order of a bake; each turn is one dispatch.
        IEnumerator<string> Work(bool isShell, bool isClosed)
        {
            const string near = "Distances near the surface", far = "Distances beyond", last = "Inside and outside";
            int voxels = (int)grid.VoxelCount, triangles = geometry.TriangleCount;

            for (int first = 0; first < triangles; first += size.triangles)
            {
                passes.Gather(first, Math.Min(size.triangles, triangles - first));
                yield return near;
            }
            passes.Clear();
            yield return near;
            for (int first = 0; first < triangles; first += size.triangles)
            {
                passes.SplatDistances(first, Math.Min(size.triangles, triangles - first));
                yield return near;
            }
            foreach (BakeGeometry.Slice slice in geometry.Slices(size.pairs))
            {
                passes.SplatDistances(slice);
                yield return near;
            }
            for (int first = 0; first < triangles; first += size.triangles)
            {
                passes.SplatNearest(first, Math.Min(size.triangles, triangles - first));
                yield return near;
            }
            foreach (BakeGeometry.Slice slice in geometry.Slices(size.pairs))
            {
                passes.SplatNearest(slice);
                yield return near;
            }
            foreach (int stride in Strides(grid.Resolution))
            {
                for (int first = 0; first < voxels; first += size.voxels)
                {
                    passes.Flood(stride, first, Math.Min(size.voxels, voxels - first));
                    yield return far;
                }
                passes.Swap();
            }
            for (int first = 0; first < voxels && isShell; first += size.voxels)
            {
                passes.ResolveShell(first, Math.Min(size.voxels, voxels - first));
                yield return last;
            }
            for (int level = 0; level < passes.LevelCount && !isShell; level++)
            {
                passes.BuildClusters(level);
                yield return last;
            }
            for (int first = 0; first < passes.BlockCount && !isShell; first += size.blocks)
            {
                passes.FindSides(first, Math.Min(size.blocks, passes.BlockCount - first), isClosed);
                yield return last;
            }
            for (int first = 0; first < passes.BrickCount && !isShell; first += size.bricks)
            {
                passes.ResolveSolid(first, Math.Min(size.bricks, passes.BrickCount - first));
                yield return last;
            }
        }

        // Halving from half the grid down to 1, and 1 once more, which halves the mean error; further rounds win little.
        internal static List<int> Strides(int3 resolution)
        {
            var strides = new List<int>();
            for (int stride = math.ceilpow2(math.cmax(resolution)) / 2; stride > 0; stride /= 2)
                strides.Add(stride);
            strides.Add(1);
            return strides;
        }

        void Finish()
        {
            if (readback.hasError)
                throw new InvalidOperationException($"The distances of '{mesh.Name}' did not arrive from the GPU: the device was lost " +
                    $"or has no memory left. Bake again, with fewer voxels if it happens again.");
            NativeArray<float> arrived = arriving;
            var distances = new float[arrived.Length];
            Chunks.Run(distances.Length, (chunk, first, end) => NativeArray<float>.Copy(arrived, first, distances, first, end - first));
            Result = new SdfBake(mesh.Name, grid, distances, settings, sign, geometry.TriangleCount, sourceHash);
            Dispose();
        }

        static int Parts(long items, int each) => (int)((items + each - 1) / each);
    }
}
