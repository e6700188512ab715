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
        /// <summary>tangent of the friction angle</summary>
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
    /// Friction between grains, on a grid of its own: a stress up to the Coulomb limit of the pressure that the coarse grid finds. Made when
    /// first needed. See GrainFriction.compute.
    /// </summary>
    sealed class GrainFriction : Stage
    {
        /// <summary>Wanted side of a cell, d.</summary>
        public const float CellSize = 2f;

        /// <summary>Most cells: a larger box gets larger ones.</summary>
        public const int MaxCells = 1 << 21;

        /// <summary>Steps towards the stress in each of the two solves of a substep.</summary>
        public static int Steps = 16;
        public static float BlendRate = 60f;
        public static bool After = true;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.GrainFriction");

        readonly ComputeShader shader = StageShader.LoadCompute("GrainFriction");
        readonly KernelVariants addGrains, findCells, moveGrains;       // before the prediction
        readonly Kernel findNodes, moveNodes, stressCells;
        readonly StepKeywords keywords;
        readonly GraphicsBuffer constants, stress, stressAfter;
        readonly FrictionConstants[] upload = new FrictionConstants[1];
        readonly int3 counts;
        readonly float3 size;

        public GrainFriction(SolverLayout layout)
        {
            addGrains = new KernelVariants(shader, "AddGrains", "AddGrainsBefore");
            findCells = new KernelVariants(shader, "FindCells", "FindCellsBefore");
            moveGrains = new KernelVariants(shader, "MoveGrains", "MoveGrainsBefore");
            findNodes = new Kernel(shader, "FindNodes");
            moveNodes = new Kernel(shader, "MoveNodes");
            stressCells = new Kernel(shader, "StressCells");
            keywords = new StepKeywords(shader, readsLists: false, skipsAsleep: true, weighs: true);
            float side = CellSize;
            do
            {
                counts = math.max((int3)math.round(layout.DomainSize / side), 1);
                side *= 1.25f;
            }
            while ((long)counts.x * counts.y * counts.z > MaxCells);
            size = layout.DomainSize / counts;
            constants = Buffers.Constants<FrictionConstants>("Rill.Friction.Constants", "RillFriction");
            GraphicsBuffer sums = Buffers.Structured<int>("Rill.Friction.NodeSums", 4L * Nodes);
            GraphicsBuffer grains = Buffers.Structured<uint>("Rill.Friction.CellGrains", 2L * Cells);
            Buffers.Structured<float4>("Rill.Friction.NodeFlows", Nodes);
            Buffers.Structured<float4>("Rill.Friction.NewFlows", Nodes);
            Buffers.Structured<float4>("Rill.Friction.Trial", 2L * Cells);
            Buffers.Structured<float>("Rill.Friction.Limits", Cells);
            stress = Buffers.Structured<float4>("Rill.Friction.Stress", 2L * Cells);
            stressAfter = Buffers.Structured<float4>("Rill.Friction.StressAfter", 2L * Cells, BufferSet.Unbound);
            BufferClear.Now(sums, grains, stress, stressAfter);
        }

        int Nodes => (counts.x + 1) * (counts.y + 1) * (counts.z + 1);

        int Cells => counts.x * counts.y * counts.z;

        public static bool IsNeeded(in StepInput input) => input.material.frictionAngle > 0f || input.material.cohesion > 0f;

        public override bool Survives(ParticleChange change) => false;

        /// <summary>Records the solve before the prediction, which adds the coarse grid's projection to the velocities.</summary>
        public void RecordBefore(in StepContext step) => Record(step, isBefore: true, step.Particles.Positions, stress);

        /// <summary>Records the solve on what the passes have left.</summary>
        public void RecordAfter(in StepContext step) => Record(step, isBefore: false, step.Particles.Predicted, stressAfter);

        void Record(in StepContext step, bool isBefore, GraphicsBuffer positions, GraphicsBuffer solution)
        {
            if (!isBefore && !After)
                return;
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            if (isBefore)
            {
                FluidMaterial material = step.Input.material;
                double spacing = step.Layout.Spacing;
                upload[0] = new FrictionConstants
                {
                    frictionCells = (uint3)counts,
                    frictionTotal = (uint)Cells,
                    inverseFrictionSize = 1f / size,
                    friction = math.tan(math.radians(material.frictionAngle)),
                    cohesion = (float)(material.cohesion / material.density * (double)step.SubstepTime * step.SubstepTime / (spacing * spacing)),
                    wallFriction = material.wallFriction,
                    inverseCellGrains = 1f / (size.x * size.y * size.z),
                    grainBlend = 1f - math.exp(-BlendRate * step.SubstepTime),
                };
                cmd.SetBufferData(constants, upload);
            }
            DispatchGrains(step, addGrains.For(isBefore), positions, isBefore);
            DispatchCells(step, findNodes, Nodes, solution);
            int find = findCells.For(isBefore);
            if (isBefore)
            {
                step.Coarse.BindChange(step, shader, find);
                cmd.SetComputeBufferParam(shader, find, Ids.FlowPotential, step.Coarse.Cells.flowPotential);
            }
            DispatchCells(step, find, Cells, solution);
            float t = 1f;
            for (int i = 0; i < Steps; i++)
            {
                float next = 0.5f * (1f + math.sqrt(1f + 4f * t * t));
                cmd.SetComputeFloatParam(shader, Ids.Momentum, i == Steps - 1 ? 0f : (t - 1f) / next);
                t = next;
                DispatchCells(step, moveNodes, Nodes, solution);
                DispatchCells(step, stressCells, Cells, solution);
            }
            DispatchCells(step, moveNodes, Nodes, solution);
            DispatchGrains(step, moveGrains.For(isBefore), positions, false);
            cmd.EndSample(Marker);
        }

        void DispatchGrains(in StepContext step, int kernel, GraphicsBuffer positions, bool takesProjection)
        {
            CommandBuffer cmd = step.Commands;
            step.Particles.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, ParticleIds.Positions, positions);
            Buffers.Bind(cmd, shader, kernel);
            step.BindAsleep(shader, kernel);
            step.Materials?.Bind(step, shader, kernel);
            if (takesProjection)
                step.Coarse.BindChange(step, shader, kernel);
            step.Particles.DispatchAlive(cmd, shader, kernel);
        }

        void DispatchCells(in StepContext step, int kernel, int count, GraphicsBuffer solution)
        {
            CommandBuffer cmd = step.Commands;
            Buffers.Bind(cmd, shader, kernel);
            cmd.SetComputeBufferParam(shader, kernel, Ids.Stress, solution);
            ThreadGroups.Dispatch(cmd, shader, kernel, ParticleBuffers.Groups(count));
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(GrainFriction stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Grain friction", needed, needed
                ? Invariant($"friction angle {step.Input.material.frictionAngle}°, cohesion {step.Input.material.cohesion} Pa")
                : "the friction angle and the cohesion are 0");
            if (!needed || stage == null)
                return description;
            int substeps = step.Substeps;
            for (int solve = 0; solve < 2; solve++)
            {
                description.Kernel(stage.addGrains.For(solve == 0), substeps, stage.keywords.Variant(step));
                description.Kernel(stage.findCells.For(solve == 0), substeps, stage.keywords.Variant(step));
                description.Kernel(stage.moveGrains.For(solve == 0), substeps, stage.keywords.Variant(step));
            }
            description.Kernel(stage.findNodes, 2 * substeps);
            description.Kernel(stage.moveNodes, 2 * (Steps + 1) * substeps);
            description.Kernel(stage.stressCells, 2 * Steps * substeps);
            stage.Buffers.Describe(description);
            return description;
        }

        static class Ids
        {
            public static readonly int FlowPotential = Shader.PropertyToID("_FlowPotential");
            public static readonly int Momentum = Shader.PropertyToID("_Momentum");
            public static readonly int Stress = Shader.PropertyToID("_Stress");
        }
    }
}
