using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Absorbing and open sides of the box: in a band beside each the velocity relaxes to that beyond the side, before each substep's
    /// prediction (a sponge layer; Israeli and Orszag 1981). Made when first needed.</summary>
    sealed class Borders : Stage
    {
        // Integral of the rate over the band, in the speed of long waves: what takes most of the waves that are up to three times as long as the
        // band. See Research~/solver-study.md, "Borders".
        const float AbsorbingStrength = 2.2f;

        // Such integrals for an open side, whose level is held: near 1 its water ends as if it went on.
        const float OpenStrength = 1.5f, FlowStrength = 8f;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Borders");

        readonly ComputeShader shader = StageShader.LoadCompute("Borders");
        readonly Kernel relax;
        FluidBorders last;

        public Borders() => relax = new Kernel(shader, "RelaxAtBorders");

        public static bool IsNeeded(in StepInput input) => input.borders.HasBands;

        /// <summary>Returns whether the borders are others than in the step before.</summary>
        public bool ConsumeChanges(in FluidBorders borders)
        {
            bool changed = false;
            for (int side = 0; side < FluidBorders.Sides; side++)
                changed |= !borders[side].IsSame(last[side]);
            last = borders;
            return changed;
        }

        /// <summary>Records the relaxation of one substep.</summary>
        /// <param name="depth">Depth of the water, d.</param>
        public void Record(in StepContext step, float depth)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            float4 inverseWidths = 0f, rates = 0f, velocities = 0f;
            float spacing = step.Layout.Spacing, gravity = math.length(step.Input.gravity);
            for (int side = 0; side < FluidBorders.Sides; side++)
            {
                FluidBorder border = step.Input.borders[side];
                if (border.kind == BorderKind.Wall)
                    continue;
                bool isOpen = border.kind == BorderKind.Open;
                float celerity = math.sqrt(gravity * (isOpen ? border.level : depth * spacing));     // of long waves
                float speed = isOpen ? OpenStrength * celerity + FlowStrength * math.abs(border.velocity) : AbsorbingStrength * celerity;
                inverseWidths[side] = spacing / border.width;
                rates[side] = 2f * speed / border.width;
                velocities[side] = isOpen ? step.Input.borders.VelocityAt(side) / spacing : 0f;
            }
            Ids.Borders.Bind(cmd, shader, relax, inverseWidths, rates, velocities, gravity > 0f ? -step.Input.gravity / gravity : 0f);
            particles.Bind(cmd, shader, relax);
            cmd.DispatchCompute(shader, relax, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Borders stage, in StepInput input)
        {
            bool needed = IsNeeded(input);
            int count = 0;
            for (int side = 0; side < FluidBorders.Sides; side++)
                count += input.borders[side].kind != BorderKind.Wall ? 1 : 0;
            var description = new StageDescription("Borders", needed, needed ? Invariant($"{count} sides are absorbing or open") : "walls only");
            if (needed && stage != null)
                description.Kernel(stage.relax, input.settings.substeps);
            return description;
        }

        static class Ids
        {
            public static readonly ShaderParameters Borders = new ShaderParameters(
                "_BorderInverseWidths", "_BorderRates", "_BorderVelocities", "_BorderUp");
        }
    }
}
