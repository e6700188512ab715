using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Ellipsoids that have to be drawn of the water, found once a frame for all cameras. Made when first needed.</summary>
    sealed class SurfaceParticles : Stage
    {
        /// <summary>An element of <see cref="Particles"/>; SurfaceParticle.hlsl says what the words are.</summary>
        [GenerateHlsl("SurfaceParticle", Name = "SurfaceParticle")]
        [StructLayout(LayoutKind.Sequential)]
        public struct Element
        {
            public uint4 a, b;
        }

        /// <summary>Entries of _SurfaceCounters.</summary>
        [GenerateHlsl("SurfaceParticles")]
        public enum Counter { Found, Drawn, DidNotFit }

        /// <summary>Passes that average the planes among neighbors before the ellipsoids are made, which average them once more.</summary>
        public const int SmoothingPasses = 3;

        /// <summary>bytes of a plane in _Workspace, and of a contact</summary>
        [GenerateHlsl("SurfaceParticles")] const uint PlaneBytes = 8;

        /// <summary>byte of the groups of Smooth in _SurfaceArguments</summary>
        [GenerateHlsl("SurfaceParticles")] const uint SmoothArgumentsAt = 48;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Surface");

        readonly ComputeShader shader = StageShader.LoadCompute("SurfaceParticles");
        readonly KernelVariants estimate;     // that leave out what lies deep; with colliders
        readonly KernelVariants shapeElements;      // with colliders
        readonly Kernel addNew, storeDrawn, smooth, shape, makeElements, hideGhosts, findContacts;
        readonly bool isWide = DeviceLimits.Current.Holds("SurfaceParticles", "Estimate" + KernelNeed.Wide);
        readonly bool mirrorsColliders = DeviceLimits.Current.Holds("SurfaceParticles", "EstimateDeepWithColliders" + KernelNeed.Wide);
        readonly StepKeywords keywords;
        readonly SurfaceWorkspace workspace;
        GraphicsBuffer surface, counters, arguments, planesBefore;

        /// <param name="layout">Layout of the solver.</param>
        /// <param name="workspace">Workspace of the same solver; it outlives this.</param>
        /// <exception cref="ArgumentOutOfRangeException">A buffer of this capacity is more than the device can bind.</exception>
        public SurfaceParticles(SolverLayout layout, SurfaceWorkspace workspace)
        {
            this.workspace = workspace;
            addNew = new Kernel(shader, "AddNew");
            estimate = new KernelVariants(shader, "Estimate", "Estimate" + KernelNeed.Wide, "EstimateWithColliders" + KernelNeed.Wide,
                "EstimateDeepWithColliders" + KernelNeed.Wide);
            storeDrawn = new Kernel(shader, "StoreDrawn");
            smooth = new Kernel(shader, "Smooth");
            shape = new Kernel(shader, "Shape");
            shapeElements = new KernelVariants(shader, "ShapeElements", "ShapeElementsWithColliders" + KernelNeed.Wide);
            makeElements = new Kernel(shader, "MakeElements");
            hideGhosts = new Kernel(shader, "HideGhosts");
            findContacts = new Kernel(shader, "FindContacts");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true);
            try
            {
                surface = Buffers.Structured<Element>("Rill.Surface", CapacityFor(layout));
                planesBefore = Buffers.Structured<uint4>("Rill.Surface.PlanesBefore", layout.Capacity);
                counters = Buffers.Structured<uint>("Rill.Surface.Counters", Enum.GetValues(typeof(Counter)).Length, "_SurfaceCounters");
                arguments = Buffers.Arguments("Rill.Surface.Arguments", 16, property: "_SurfaceArguments");
                BufferClear.Now(counters);
                BufferClear.Now(planesBefore);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Most ellipsoids: one for each particle, and those that cover the walls of the domain.</summary>
        public static long CapacityFor(SolverLayout layout)
        {
            float3 size = layout.DomainSize;
            double area = 2.0 * ((double)size.x * size.y + (double)size.y * size.z + (double)size.z * size.x);
            return layout.Capacity + (long)Math.Min(3.0 * layout.Capacity, 1.5 * area);
        }

        /// <summary>SurfaceParticle [<see cref="CapacityFor"/>], of which the first [drawn] are set, in any order; see
        /// SurfaceParticle.hlsl.</summary>
        public GraphicsBuffer Particles => surface;

        /// <summary>Begins with the GraphicsBuffer.IndirectDrawArgs for those, 6 vertices each; see Arguments.hlsl.</summary>
        public GraphicsBuffer Arguments => arguments;

        /// <summary>uint, by <see cref="Counter"/>.</summary>
        public GraphicsBuffer Counters => counters;

        /// <summary>Whether colliders mirror the surface recorded last: the workspace has the contact of each particle then, see
        /// Contact.hlsl.</summary>
        public bool HasContacts { get; private set; }

        /// <summary>Records the surface of the current state, after the last step that is recorded before it.</summary>
        /// <param name="hasSteps">Whether there was one since the fluid was cleared or restored: if not, all particles are drawn as what is
        /// new.</param>
        /// <param name="hasNew">Whether particles may have come since the last step.</param>
        /// <param name="version">One more than that of the surface before; more than one where that has nothing to do with this one.</param>
        /// <param name="substepsSince">Substeps since the surface before.</param>
        /// <param name="hasGhosts">Whether some of the particles are ghosts.</param>
        /// <param name="asElements">Whether <see cref="Particles"/> are those of SurfaceElement.hlsl, for a <see cref="SurfaceMesh"/>.</param>
        public void Record(in StepContext step, bool hasSteps, bool hasNew, int version, int substepsSince, bool hasGhosts = false,
            bool asElements = false)
        {
            CommandBuffer cmd = step.Commands;
            // Only the mesh of a fluid with colliders has contacts.
            HasContacts = hasSteps && asElements && mirrorsColliders && step.Colliders != null;
            workspace.Reserve((long)PlaneBytes * (HasContacts ? 3 : 2) * step.Layout.Capacity);
            cmd.BeginSample(Marker);
            keywords.Record(step);
            cmd.SetComputeIntParam(shader, Ids.SurfaceCapacity, surface.count);
            if (hasNew || !hasSteps)
                RecordNew(step, !hasSteps);
            if (hasSteps)
            {
                step.BindConstants(shader);
                if (HasContacts)
                    RecordContacts(step);
                RecordEstimate(step);
            }
            RecordDrawn(cmd);
            if (hasSteps)
            {
                RecordSmoothing(step);
                RecordShape(step, version, substepsSince, asElements ? shapeElements.For(HasContacts) : shape);
            }
            else if (asElements)
            {
                RecordElements(step);
            }
            if (hasGhosts && !asElements)
                RecordHiding(step);
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        /// <param name="asElements">As <see cref="Record"/> has it.</param>
        public static StageDescription Describe(SurfaceParticles stage, in StepContext step, bool asElements)
        {
            string reason = stage != null
                ? Invariant($"a component draws the surface: after the last step of a frame, {SmoothingPasses} smoothing passes over ") +
                    "what is drawn"
                : "no component draws the surface";
            var description = new StageDescription("Surface particles", stage != null, reason);
            if (stage == null)
                return description;
            string variant = stage.keywords.Variant(step);
            bool withColliders = stage.HasContacts;
            description.Kernel(stage.addNew, 0);
            if (withColliders)
                description.Kernel(stage.findContacts, 0, variant);
            description.Kernel(stage.estimate.For(stage.LeavesOutDeep(step), withColliders), 0, variant);
            description.Kernel(stage.storeDrawn, 0);
            description.Kernel(stage.smooth, 0, variant);
            description.Kernel(asElements ? stage.shapeElements.For(withColliders) : stage.shape, 0, variant);
            stage.Buffers.Describe(description);
            description.Buffer("Rill.Surface.Workspace", stage.workspace.Memory);
            return description;
        }

        bool LeavesOutDeep(in StepContext step) => isWide && step.Coarse != null;

        void RecordContacts(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            step.Colliders.BindShapes(cmd, shader, findContacts);
            step.Particles.Bind(cmd, shader, findContacts);
            cmd.SetComputeBufferParam(shader, findContacts, SurfaceWorkspace.Id, workspace.Memory);
            cmd.DispatchCompute(shader, findContacts, step.Particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
        }

        void RecordNew(in StepContext step, bool all)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            Ids.New.Bind(cmd, shader, addNew, all, step.SubstepTime);
            particles.Bind(cmd, shader, addNew);
            Buffers.Bind(cmd, shader, addNew);
            cmd.DispatchCompute(shader, addNew, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
        }

        void RecordEstimate(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            int kernel = estimate.For(LeavesOutDeep(step), HasContacts);
            if (LeavesOutDeep(step))
            {
                step.BindCoarseConstants(shader);
                cmd.SetComputeBufferParam(shader, kernel, Ids.CoarseSurface, step.Coarse.Surface);
            }
            BindNeighbors(step, kernel);
            cmd.DispatchCompute(shader, kernel, step.Particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
        }

        void RecordDrawn(CommandBuffer cmd)
        {
            Buffers.Bind(cmd, shader, storeDrawn);
            cmd.DispatchCompute(shader, storeDrawn, 1, 1, 1);
        }

        void RecordSmoothing(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            BindNeighbors(step, smooth);
            for (int pass = 0; pass < SmoothingPasses; pass++)
            {
                cmd.SetComputeIntParam(shader, Ids.PlaneList, pass % 2);
                cmd.DispatchCompute(shader, smooth, arguments, SmoothArgumentsAt);
            }
        }

        void RecordShape(in StepContext step, int version, int substepsSince, int kernel)
        {
            CommandBuffer cmd = step.Commands;
            BindNeighbors(step, kernel);
            Ids.Shape.Bind(cmd, shader, kernel, SmoothingPasses % 2, version, (float)substepsSince);
            cmd.DispatchCompute(shader, kernel, arguments, GpuBuffer.DispatchArgumentsAt);
        }

        void RecordElements(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.SetComputeBufferParam(shader, makeElements, ParticleIds.Ids, step.Particles.Ids);
            Buffers.Bind(cmd, shader, makeElements);
            cmd.DispatchCompute(shader, makeElements, arguments, GpuBuffer.DispatchArgumentsAt);
        }

        void RecordHiding(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.SetComputeBufferParam(shader, hideGhosts, ParticleIds.Ids, step.Particles.Ids);
            Buffers.Bind(cmd, shader, hideGhosts);
            cmd.DispatchCompute(shader, hideGhosts, arguments, GpuBuffer.DispatchArgumentsAt);
        }

        void BindNeighbors(in StepContext step, int kernel)
        {
            CommandBuffer cmd = step.Commands;
            step.Lists.Bind(cmd, shader, kernel);
            step.BindAsleep(shader, kernel);
            step.Particles.Bind(cmd, shader, kernel);
            Ids.Neighbors.Bind(cmd, shader, kernel, workspace.Memory, step.Search.CellStarts);
            Buffers.Bind(cmd, shader, kernel);
        }

        static class Ids
        {
            public static readonly int PlaneList = Shader.PropertyToID("_PlaneList");
            public static readonly int CoarseSurface = Shader.PropertyToID("_CoarseSurface");
            public static readonly ShaderParameters New = new ShaderParameters("_AllNew", "_SubstepTime");
            public static readonly ShaderParameters Shape = new ShaderParameters("_PlaneList", "_SurfaceVersion", "_SinceSurface");
            public static readonly ShaderParameters Neighbors = new ShaderParameters("_Workspace", "_CellStarts");
            public static readonly int SurfaceCapacity = Shader.PropertyToID("_SurfaceCapacity");
        }
    }
}
