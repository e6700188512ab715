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
    /// <summary>
    /// The extra stress of a fluid that remembers its stretch: an Oldroyd-B fluid, whose tensor B travels with each particle and
    /// relaxes in one time (see Viscoelasticity.compute). Made when first needed; until then nothing is stretched.
    /// </summary>
    sealed class Viscoelasticity : Stage
    {
        /// <summary>of the stiffness times what its particle's neighborhood multiplies it by: as much as a substep can follow</summary>
        [GenerateHlsl("Viscoelasticity")] const double StableStiffness = 0.5;

        /// <summary>Maximum of G Δt² / (ρ d²): the stable stiffness over what a particle of the lattice multiplies it by.</summary>
        public static readonly double MaxStiffness = StableStiffness / (Math.Sqrt(3.0) * LatticeKernels.StressMultiplier);

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Viscoelasticity");

        readonly ComputeShader shader = StageShader.LoadCompute("Viscoelasticity");
        readonly Kernel deform, applyStress;
        readonly StepKeywords keywords;
        readonly GraphicsBuffer previousIndices;
        GraphicsBuffer conformation, deformed;

        public Viscoelasticity(int capacity)
        {
            deform = new Kernel(shader, "Deform");
            applyStress = new Kernel(shader, "ApplyStress");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true);
            conformation = Buffers.Structured<Symmetric>("Rill.Conformation", capacity);
            deformed = Buffers.Structured<Symmetric>("Rill.DeformedConformation", capacity, "_Deformed");
            Buffers.Structured<float3x3>("Rill.Stress", capacity);
            previousIndices = Buffers.Structured<uint>("Rill.PreviousIndices", capacity);
            BufferClear.Now(conformation);
        }

        /// <summary>A symmetric tensor of a particle.</summary>
        [GenerateHlsl("Viscoelasticity")]
        [StructLayout(LayoutKind.Sequential)]
        public struct Symmetric
        {
            /// <summary>xx, yy, zz</summary>
            public float3 diagonal;
            /// <summary>yz, xz, xy</summary>
            public float3 others;
        }

        /// <summary>[capacity], B − I of the particles of the last substep; 0 is unstretched.</summary>
        public GraphicsBuffer Conformation => conformation;

        /// <summary>uint [capacity], where each particle was before the sort; NeighborSearch writes it.</summary>
        public GraphicsBuffer PreviousIndices => previousIndices;

        public override void ListState(List<StateBuffer> state)
            => state.Add(new StateBuffer(SnapshotSection.Conformation, conformation, StateExtent.Moved));

        public override bool Survives(ParticleChange change) => change == ParticleChange.Shifted;

        public static bool IsNeeded(in StepInput input) => input.material.shearModulus > 0f;

        /// <summary>Records how the stretch follows the particles' path in this substep and what its stress does to their velocities.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            FluidMaterial material = step.Input.material;
            float dt = step.SubstepTime, spacing = step.Layout.Spacing;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            float stiffness = material.shearModulus * dt * dt / (material.density * spacing * spacing);
            Ids.Material.Bind(cmd, shader, deform, stiffness, math.exp(-0.5f * dt / material.relaxationTime));

            Dispatch(step, deform);
            Dispatch(step, applyStress);
            cmd.EndSample(Marker);
            Buffers.Swap(ref conformation, ref deformed);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Viscoelasticity stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Viscoelasticity", needed, Reason(step));
            if (!needed || stage == null)
                return description;
            string variant = stage.keywords.Variant(step);
            description.Kernel(step.Search.GatherPreviousIndices, step.Substeps, step.Search.Variant(step));
            description.Kernel(stage.deform, step.Substeps, variant);
            description.Kernel(stage.applyStress, step.Substeps, variant);
            stage.Buffers.Describe(description);
            return description;
        }

        static string Reason(in StepContext step)
        {
            FluidMaterial material = step.Input.material;
            if (material.shearModulus <= 0f)
                return "the shear modulus is 0";
            string text = Invariant($"shear modulus {material.shearModulus} Pa, relaxing in {material.relaxationTime} s");
            float largest = material.MaxShearModulus(step.Layout.Spacing, step.SubstepTime);
            return material.shearModulus > largest ? Invariant($"{text}; at this spacing and substep it acts like {largest:G3} Pa") : text;
        }

        void Dispatch(in StepContext step, int kernel)
        {
            CommandBuffer cmd = step.Commands;
            step.BindLists(shader, kernel);
            step.Particles.Bind(cmd, shader, kernel);
            ParticleIds.Motion.Bind(cmd, shader, kernel, step.Particles.Predicted, step.NewVelocities);
            Buffers.Bind(cmd, shader, kernel);
            cmd.DispatchCompute(shader, kernel, step.Particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);
        }

        public static class Ids
        {
            public static readonly int PreviousIndices = Shader.PropertyToID("_PreviousIndices");
            public static readonly ShaderParameters Material = new ShaderParameters("_Stiffness", "_Relaxing");
        }
    }
}
