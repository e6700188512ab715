using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Packs the particles into frames of a recording and unpacks them, on the GPU. Made when first needed.</summary>
    sealed class FramePacking : Stage
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Recording");

        readonly ComputeShader shader = StageShader.LoadCompute("Recording");
        readonly Kernel pack, unpack;
        GraphicsBuffer upload;

        public FramePacking()
        {
            pack = new Kernel(shader, "PackFrame");
            unpack = new Kernel(shader, "UnpackFrame");
        }

        /// <summary>Records the packing of the particles.</summary>
        /// <param name="tags">Null where the particles have none.</param>
        /// <param name="frame">uint, <see cref="FrameLayout.PackedHeader"/> words and those of the particles.</param>
        public void RecordPack(CommandBuffer cmd, ParticleBuffers particles, GraphicsBuffer tags, float3 domainSize, in FrameLayout layout,
            GraphicsBuffer frame)
        {
            cmd.BeginSample(Marker);
            Bind(cmd, pack, particles, tags ?? particles.Ids, tags != null, layout, 1f / layout.StepSize(domainSize));
            cmd.SetComputeBufferParam(shader, pack, Ids.Frame, frame);
            particles.DispatchAlive(cmd, shader, pack);
            cmd.EndSample(Marker);
        }

        /// <summary>Uploads a frame, and records that its particles replace those that are there.</summary>
        /// <param name="stepBack">s, see Recording.compute.</param>
        public void RecordUnpack(CommandBuffer cmd, ParticleBuffers particles, GraphicsBuffer tags, float3 domainSize,
            in FrameLayout layout, RecordedFrame frame, float stepBack)
        {
            int words = Math.Max((int)layout.Words(frame.particles), 1);
            if (upload == null || upload.count < words)
            {
                Buffers.Release(ref upload);
                upload = Buffers.Structured<uint>("Rill.PlayedFrame", words + words / 8, "_Frame");      // fluids grow: not again for each frame
            }
            frame.Reserve(words);
            upload.SetData(frame.words, 0, 0, words);
            cmd.BeginSample(Marker);
            Bind(cmd, unpack, particles, tags ?? particles.SortedIds, tags != null, layout, layout.StepSize(domainSize));
            Buffers.Bind(cmd, shader, unpack);
            uint nextId = layout.Has(RecordingFields.Ids) ? frame.nextId : (uint)frame.particles;
            Ids.Unpacked.Bind(cmd, shader, unpack, frame.particles, nextId, stepBack);
            ThreadGroups.Dispatch(cmd, shader, unpack, ParticleBuffers.Groups(Math.Max(frame.particles, 1)));
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(FramePacking stage)
        {
            var description = new StageDescription("Recording", stage != null, stage != null
                ? "frames are recorded or played back, outside the step" : "nothing is recorded or played back");
            if (stage == null)
                return description;
            description.Kernel(stage.upload != null ? stage.unpack : stage.pack, 0);
            stage.Buffers.Describe(description);
            return description;
        }

        // Without tags a buffer is bound in their stead and not touched.
        void Bind(CommandBuffer cmd, int kernel, ParticleBuffers particles, GraphicsBuffer tags, bool hasTags, in FrameLayout layout,
            float3 stepScale)
        {
            Ids.Layout.Bind(cmd, shader, kernel, stepScale, layout.MaxSteps, layout.IsWide, (uint)layout.Fields, hasTags, tags);
            particles.Bind(cmd, shader, kernel);
        }

        static class Ids
        {
            public static readonly int Frame = Shader.PropertyToID("_Frame");
            public static readonly ShaderParameters Layout = new ShaderParameters(
                "_StepScale", "_MaxSteps", "_IsWide", "_FrameFields", "_HasTags", "_Tags");
            public static readonly ShaderParameters Unpacked = new ShaderParameters("_FrameParticles", "_FrameNextId", "_StepBack");
        }
    }
}
