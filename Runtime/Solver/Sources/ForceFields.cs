using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>A force field in one step; lengths in d, in the domain's frame.</summary>
    [GenerateHlsl("ForceFields")]
    [StructLayout(LayoutKind.Sequential)]
    struct FieldRegion : IEquatable<FieldRegion>
    {
        /// <summary>d, in the domain's frame</summary>
        public float3 center;
        /// <summary>a <see cref="ForceFieldKind"/></summary>
        public uint kind;
        /// <summary>along the bounds' sides, over half their length (a sphere: over its radius), 1/d; 0 without bounds</summary>
        public float3 axisX;
        /// <summary>a <see cref="ForceFieldFalloff"/></summary>
        public uint falloff;
        public float3 axisY;
        public uint isSphere;
        public float3 axisZ;
        /// <summary>d/s²; of a wind: drag, 1/s</summary>
        public float strength;
        /// <summary>direction or axis, length 1; of a wind: its velocity, d/s</summary>
        public float3 flow;
        /// <summary>distance below which a point or vortex fades towards its center, d, above 0</summary>
        public float core;

        public bool Equals(FieldRegion other) => center.Equals(other.center) && kind == other.kind && axisX.Equals(other.axisX)
            && falloff == other.falloff
            && axisY.Equals(other.axisY) && isSphere == other.isSphere && axisZ.Equals(other.axisZ) && strength == other.strength
            && flow.Equals(other.flow) && core == other.core;

        public override bool Equals(object other) => other is FieldRegion region && Equals(region);

        public override int GetHashCode() => center.GetHashCode() ^ flow.GetHashCode();
    }

    /// <summary>Adds the acceleration of force fields to the velocities, before each substep's prediction. Made when first needed.</summary>
    sealed class ForceFields : Stage
    {
        /// <summary>Most that all fields together accelerate a particle, m/s²: about a hundred times gravity.</summary>
        public const float MaxAcceleration = 1000f;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Fields");

        readonly ComputeShader shader = StageShader.LoadCompute("ForceFields");
        readonly Kernel accelerate;
        readonly FieldRegion[] last = new FieldRegion[StepSources.MaxFields];
        int lastCount = -1;
        readonly GraphicsBuffer regions;

        public ForceFields()
        {
            accelerate = new Kernel(shader, "Accelerate");
            regions = Buffers.Structured<FieldRegion>("Rill.Fields", StepSources.MaxFields);
        }

        public static bool IsNeeded(StepSources sources) => sources != null && sources.fieldCount > 0;

        /// <summary>Records the fields of this step.</summary>
        /// <returns>Whether they are others than those of the step before.</returns>
        public bool Upload(CommandBuffer cmd, StepSources sources)
        {
            cmd.SetBufferData(regions, sources.fields, 0, 0, sources.fieldCount);
            bool changed = lastCount != sources.fieldCount;
            lastCount = sources.fieldCount;
            for (int i = 0; i < sources.fieldCount; i++)
            {
                changed |= !last[i].Equals(sources.fields[i]);
                last[i] = sources.fields[i];
            }
            return changed;
        }

        /// <summary>The fields of the last step: where the next has others, what rests wakes.</summary>
        public ReadOnlySpan<FieldRegion> Last
        {
            get => new ReadOnlySpan<FieldRegion>(last, 0, Math.Max(lastCount, 0));
            set
            {
                value.CopyTo(last);
                lastCount = value.Length;
            }
        }

        /// <summary>Records the acceleration of one substep.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            Ids.Fields.Bind(cmd, shader, accelerate, lastCount, MaxAcceleration / step.Layout.Spacing);
            particles.Bind(cmd, shader, accelerate);
            Buffers.Bind(cmd, shader, accelerate);
            cmd.DispatchCompute(shader, accelerate, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(ForceFields stage, in StepInput input)
        {
            StepSources sources = input.sources;
            bool needed = IsNeeded(sources);
            var description = new StageDescription("Force fields", needed, needed ? Invariant($"{sources.fieldCount} ") +
                "fields" : "no force field");
            if (!needed || stage == null)
                return description;
            description.Kernel(stage.accelerate, input.settings.substeps);
            stage.Buffers.Describe(description);
            return description;
        }

        static class Ids
        {
            public static readonly ShaderParameters Fields = new ShaderParameters("_FieldCount", "_MaxAcceleration");
        }
    }
}
