using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Friction of grains in one substep; lengths in d.</summary>
    [GenerateHlsl("GrainFriction", ConstantBuffer = "RillFriction")]
    [StructLayout(LayoutKind.Sequential)]
    struct FrictionConstants
    {
        /// <summary>cells along x, y, z</summary>
        public uint3 frictionCells;
        /// <summary>their product</summary>
        public uint frictionTotal;
        /// <summary>1/d</summary>
        public float3 inverseFrictionSize;
        /// <summary>see GrainFriction.Coefficient</summary>
        public float friction;
        /// <summary>d²: least limit of the stress</summary>
        public float cohesion;
        /// <summary>of the domain's walls, relative to that of grains among themselves</summary>
        public float wallFriction;
        /// <summary>1 over the particles of a full cell</summary>
        public float inverseCellGrains;
        /// <summary>part of a grain's departure from the flow around it that a substep takes</summary>
        public float grainBlend;
    }

    /// <summary>
    /// Friction and cohesion of grains, on a grid of its own: a stress up to the Coulomb limit at the pressure that the coarse grid finds.
    /// Made when first needed. See GrainFriction.compute.
    /// </summary>
    sealed class GrainFriction : Stage
    {
        /// <summary>Steps towards the stress in each of the two solves of a substep. It goes on where the last substep's ended.</summary>
        public const int Steps = 8;

        /// <summary>Rate at which grains lose what they depart from the flow around them by, 1/s. See Research~/solver-study.md, "Grains".</summary>
        public const float BlendRate = 100f;

        const float CellSize = 2f;          // wanted side of a cell, d
        const int MaxCells = 1 << 21;       // a larger box gets larger ones
        const int CellWords = 4;            // see _CellSums

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.GrainFriction");

        readonly ComputeShader shader = StageShader.LoadCompute("GrainFriction");
        readonly KernelVariants addGrains, findCells, moveGrains;       // before the prediction
        readonly KernelVariants moveNodes;                              // with colliders
        readonly Kernel anticipate, findNodes, findSolids, stressCells;
        readonly StepKeywords keywords;
        readonly GraphicsBuffer constants, lastChange, stress, stressAfter;
        GraphicsBuffer nodeSolids;      // null until there are colliders
        readonly FrictionConstants[] upload = new FrictionConstants[1];
        readonly int3 counts;
        readonly float3 size;

        public GrainFriction(SolverLayout layout)
        {
            anticipate = new Kernel(shader, "Anticipate");
            addGrains = new KernelVariants(shader, "AddGrains", "AddGrainsBefore");
            findNodes = new Kernel(shader, "FindNodes");
            findSolids = new Kernel(shader, "FindSolids");
            findCells = new KernelVariants(shader, "FindCells", "FindCellsBefore");
            moveNodes = new KernelVariants(shader, "MoveNodes", "MoveNodesWithColliders");
            stressCells = new Kernel(shader, "StressCells");
            moveGrains = new KernelVariants(shader, "MoveGrains", "MoveGrainsBefore");
            keywords = new StepKeywords(shader, readsLists: false, skipsAsleep: true, weighs: true);

            counts = CountsFor(layout.DomainSize);
            size = layout.DomainSize / counts;
            constants = Buffers.Constants<FrictionConstants>("Rill.Friction.Constants", "RillFriction");
            GraphicsBuffer nodeSums = Buffers.Structured<int>("Rill.Friction.NodeSums", 4L * Nodes);
            GraphicsBuffer cellSums = Buffers.Structured<uint>("Rill.Friction.CellSums", (long)CellWords * Cells);
            Buffers.Structured<float4>("Rill.Friction.NodeFlows", Nodes);
            Buffers.Structured<float4>("Rill.Friction.NewFlows", Nodes);
            lastChange = Buffers.Structured<float4>("Rill.Friction.LastChange", Nodes);
            Buffers.Structured<float4>("Rill.Friction.Trial", 2L * Cells);
            Buffers.Structured<float>("Rill.Friction.Limits", Cells);
            stress = Buffers.Structured<float4>("Rill.Friction.Stress", 2L * Cells);
            stressAfter = Buffers.Structured<float4>("Rill.Friction.StressAfter", 2L * Cells, BufferSet.Unbound);
            BufferClear.Now(nodeSums, cellSums, lastChange, stress, stressAfter);       // the first substep has no past
        }

        int Nodes => (counts.x + 1) * (counts.y + 1) * (counts.z + 1);

        int Cells => counts.x * counts.y * counts.z;

        /// <summary>Whether the fluid or one of its phases is of grains, and their pressure may be found.</summary>
        public static bool IsNeeded(in StepInput input) => input.settings.deepWater != DeepWater.Off && input.phases.HaveGrains(input.material);

        /// <summary>Whether grains flow as liquids, because nothing finds their pressure.</summary>
        public static bool LacksPressure(in StepInput input) => input.settings.deepWater == DeepWater.Off && input.phases.HaveGrains(input.material);

        /// <summary>Slope of the limit, √(s:s/2) over the pressure: the cone of Drucker and Prager that meets Mohr's and Coulomb's limit where
        /// grains are pressed together along one axis.</summary>
        /// <param name="angle">Friction angle, degrees.</param>
        public static float Coefficient(float angle) => (float)OfCone(angle, Math.Sin(angle * Math.PI / 180.0));

        /// <summary>Limit of that cone without pressure, d²: over the density, times the square of the substep.</summary>
        /// <param name="cohesion">Pa.</param>
        /// <param name="angle">Friction angle, degrees.</param>
        /// <param name="density">kg/m³.</param>
        /// <param name="spacing">m.</param>
        /// <param name="substep">s.</param>
        public static float Cohesion(float cohesion, float angle, float density, float spacing, float substep)
            => (float)(OfCone(angle, Math.Cos(angle * Math.PI / 180.0)) * cohesion / density * substep * substep / ((double)spacing * spacing));

        static double OfCone(float angle, double part) => 6.0 * part / (Math.Sqrt(3.0) * (3.0 - Math.Sin(angle * Math.PI / 180.0)));

        public override bool Survives(ParticleChange change) => false;

        public override void ListState(List<StateBuffer> state)
        {
            state.Add(new StateBuffer(SnapshotSection.FrictionChange, lastChange, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.FrictionStress, stress, StateExtent.All));
            state.Add(new StateBuffer(SnapshotSection.FrictionStressAfter, stressAfter, StateExtent.All));
        }

        /// <summary>Records that the velocities have what friction did last, for the projection to find the pressure by.</summary>
        public void RecordAnticipation(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            Upload(step);
            keywords.Record(step);
            step.BindConstants(shader);
            Bind(step, anticipate, step.Particles.Positions);
            step.Particles.DispatchAlive(cmd, shader, anticipate);
            cmd.EndSample(Marker);
        }

        /// <summary>Records the friction on the flow that is about to be predicted.</summary>
        /// <param name="takesProjection">Whether the coarse grid's displacements are added to the velocities first.</param>
        public void RecordBefore(in StepContext step, bool takesProjection)
            => Record(step, true, takesProjection, step.Particles.Positions, stress);

        /// <summary>Records the friction on what the passes have left, which moves the grains back.</summary>
        public void RecordAfter(in StepContext step) => Record(step, false, false, step.Particles.Predicted, stressAfter);

        void Record(in StepContext step, bool isBefore, bool takesProjection, GraphicsBuffer positions, GraphicsBuffer solution)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            cmd.SetComputeIntParam(shader, Ids.TakesProjection, takesProjection ? 1 : 0);
            cmd.SetComputeIntParam(shader, Ids.IsLast, 0);
            DispatchGrains(step, addGrains.For(isBefore), positions, isBefore);
            DispatchGrid(step, findNodes, Nodes, solution);
            if (isBefore && step.Colliders != null)
            {
                nodeSolids ??= Buffers.Structured<float4>("Rill.Friction.NodeSolids", 2L * Nodes);
                step.Colliders.BindShapes(cmd, shader, findSolids);
                DispatchGrid(step, findSolids, Nodes, solution);
            }
            int find = findCells.For(isBefore);
            if (isBefore)
            {
                step.Coarse.BindChange(step, shader, find);
                cmd.SetComputeBufferParam(shader, find, Ids.FlowPotential, step.Coarse.Cells.flowPotential);
            }
            DispatchGrid(step, find, Cells, solution);

            int move = moveNodes.For(step.Colliders != null);
            float momentum = 1f;        // of Beck and Teboulle 2009, t_k
            for (int i = 0; i < Steps; i++)
            {
                float next = 0.5f * (1f + math.sqrt(1f + 4f * momentum * momentum));
                DispatchGrid(step, move, Nodes, solution);
                cmd.SetComputeFloatParam(shader, Ids.Momentum, i < Steps - 1 ? (momentum - 1f) / next : 0f);
                DispatchGrid(step, stressCells, Cells, solution);
                momentum = next;
            }
            cmd.SetComputeIntParam(shader, Ids.IsLast, isBefore ? 1 : 0);
            DispatchGrid(step, move, Nodes, solution);
            DispatchGrains(step, moveGrains.For(isBefore), positions, false);
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(GrainFriction stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Grain friction", needed, needed
                ? Invariant($"friction angle {step.Input.phases.MaxFrictionAngle(step.Input.material)}°, ") +
                Invariant($"cohesion {step.Input.phases.MaxCohesion(step.Input.material)} Pa")
                : LacksPressure(step.Input) ? "deep water is off" : "the friction angle and the cohesion are 0");
            if (!needed || stage == null)
                return description;
            int substeps = step.Substeps;
            bool withColliders = step.Colliders != null;
            string variant = stage.keywords.Variant(step);
            description.Kernel(stage.anticipate, substeps, variant);
            foreach (bool isBefore in new[] { true, false })
            {
                description.Kernel(stage.addGrains.For(isBefore), substeps, variant);
                description.Kernel(stage.findCells.For(isBefore), substeps, variant);
                description.Kernel(stage.moveGrains.For(isBefore), substeps, variant);
            }
            description.Kernel(stage.findNodes, 2 * substeps, variant);
            if (withColliders)
                description.Kernel(stage.findSolids, substeps, variant);
            description.Kernel(stage.moveNodes.For(withColliders), 2 * (Steps + 1) * substeps, variant);
            description.Kernel(stage.stressCells, 2 * Steps * substeps, variant);
            stage.Buffers.Describe(description);
            return description;
        }

        static int3 CountsFor(float3 domainSize)
        {
            int3 counts;
            float side = CellSize;
            do
            {
                counts = math.max((int3)math.round(domainSize / side), 1);
                side *= 1.25f;
            }
            while (math.csum(math.log2((float3)counts)) > math.log2((float)MaxCells));
            return counts;
        }

        void Upload(in StepContext step)
        {
            FluidMaterial material = step.Input.material;
            upload[0] = new FrictionConstants
            {
                frictionCells = (uint3)counts,
                frictionTotal = (uint)Cells,
                inverseFrictionSize = 1f / size,
                friction = Coefficient(material.frictionAngle),
                cohesion = Cohesion(material.cohesion, material.frictionAngle, material.density, step.Layout.Spacing, step.SubstepTime),
                wallFriction = material.wallFriction,
                inverseCellGrains = 1f / (size.x * size.y * size.z),
                grainBlend = 1f - math.exp(-BlendRate * step.SubstepTime),
            };
            step.Commands.SetBufferData(constants, upload);
        }

        void DispatchGrains(in StepContext step, int kernel, GraphicsBuffer positions, bool takesProjection)
        {
            Bind(step, kernel, positions);
            if (takesProjection)
                step.Coarse.BindChange(step, shader, kernel);
            step.Particles.DispatchAlive(step.Commands, shader, kernel);
        }

        void Bind(in StepContext step, int kernel, GraphicsBuffer positions)
        {
            step.Particles.Bind(step.Commands, shader, kernel);
            step.BindAsleep(shader, kernel);
            step.Materials?.Bind(step, shader, kernel);
            Buffers.Bind(step.Commands, shader, kernel);
            step.Commands.SetComputeBufferParam(shader, kernel, ParticleIds.Positions, positions);
        }

        void DispatchGrid(in StepContext step, int kernel, int count, GraphicsBuffer solution)
        {
            Buffers.Bind(step.Commands, shader, kernel);
            step.Commands.SetComputeBufferParam(shader, kernel, Ids.Stress, solution);
            CoarseGrid.Dispatch(step.Commands, shader, kernel, count);
        }

        static class Ids
        {
            public static readonly int FlowPotential = Shader.PropertyToID("_FlowPotential");
            public static readonly int TakesProjection = Shader.PropertyToID("_TakesProjection");
            public static readonly int IsLast = Shader.PropertyToID("_IsLast");
            public static readonly int Momentum = Shader.PropertyToID("_Momentum");
            public static readonly int Stress = Shader.PropertyToID("_Stress");
        }
    }
}
