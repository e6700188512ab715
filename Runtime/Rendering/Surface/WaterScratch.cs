using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Resources that are filled and read while one fluid's surface is recorded for one camera, and not later: all fluids and cameras use
    /// it, since they come one after the other.</summary>
    sealed class WaterScratch
    {
        const int FramesKept = 3, Patience = 60;

        static WaterScratch shared = new WaterScratch();

        RenderTexture faces, faceDepth, sceneCopy;
        GraphicsBuffer sprayAmounts, tileMarks;
        int lastFrame, lookedFrame;
        long largest;       // texels asked for since it was looked at
        // Resources that recorded commands may still refer to: a camera can be drawn while another is prepared.
        readonly List<(IDisposable what, int frame)> outgrown = new List<(IDisposable, int)>();

        public static WaterScratch Instance => shared;

        /// <summary>The nearest faces of a mesh on the picture, see WaterRays.compute, and their depth.</summary>
        public RenderTexture Faces => faces;
        public RenderTexture FaceDepth => faceDepth;

        /// <summary>The scene's depth as the device has it, of the whole picture.</summary>
        public RenderTexture SceneCopy => sceneCopy;

        /// <summary>uint, of each texel of <see cref="WaterView.Spray"/> in use, slice after slice; see WaterSpray.compute.</summary>
        public GraphicsBuffer SprayAmounts => sprayAmounts;

        /// <summary>uint, see TileMarks.hlsl.</summary>
        public GraphicsBuffer TileMarks => tileMarks;

        /// <summary>Holds what the rays of a view need; allocates only where it is larger than all before.</summary>
        /// <param name="width">Width of the whole picture, in texels of the view's rays.</param>
        /// <param name="height">The same.</param>
        /// <param name="sprayWords">That are added up for a texel of its spray.</param>
        public void Prepare(WaterView view, int width, int height, int sprayWords)
        {
            lastFrame = Time.frameCount;
            int3 size = SizeOf(view.Faces);
            largest = Math.Max(largest, TexelsOf(view.Faces));
            HoldTexture(ref faces, "Rill.Water.Faces", size, GraphicsFormat.R16G16B16A16_SFloat);
            HoldTexture(ref faceDepth, "Rill.Water.FaceDepth", size, GraphicsFormat.None);
            HoldTexture(ref sceneCopy, "Rill.Water.Scene", new int3(width, height, size.z), GraphicsFormat.R32_SFloat);
            HoldBuffer<uint>(ref tileMarks, "Rill.Water.TileMarks", view.Tiles.Tiles.count);
            if (view.Spray != null)
                HoldBuffer<uint>(ref sprayAmounts, "Rill.Water.SprayAmounts", TexelsOf(view.Spray) * sprayWords);
        }

        /// <summary>Once a frame: gives back what nothing has asked for lately.</summary>
        public void ReleaseUnused()
        {
            for (int i = outgrown.Count - 1; i >= 0; i--)
                if (Time.frameCount - outgrown[i].frame > FramesKept)
                {
                    outgrown[i].what.Dispose();
                    outgrown.RemoveAt(i);
                }
            if (Time.frameCount - lastFrame > FramesKept)
                Release();
            else if (Time.frameCount - lookedFrame >= Patience)
                Shrink();
        }

        // If the largest use of a while leaves much of it empty, the next use makes it again.
        void Shrink()
        {
            if (faces != null && 4 * largest < 3 * TexelsOf(faces))
            {
                Outgrow(ref faces);
                Outgrow(ref faceDepth);
                Outgrow(ref sceneCopy);
                Outgrow(ref sprayAmounts);
                Outgrow(ref tileMarks);
            }
            lookedFrame = Time.frameCount;
            largest = 0;
        }

        /// <summary>After the last surface.</summary>
        public void Release()
        {
            foreach ((IDisposable what, _) in outgrown)
                what.Dispose();
            outgrown.Clear();
            EngineObject.Release(ref faces);
            EngineObject.Release(ref faceDepth);
            EngineObject.Release(ref sceneCopy);
            GpuBuffer.Release(ref sprayAmounts);
            GpuBuffer.Release(ref tileMarks);
        }

        public void Describe(StageDescription stage)
        {
            stage.Texture(faces);
            stage.Texture(faceDepth);
            stage.Texture(sceneCopy);
            stage.Buffer("Rill.Water.SprayAmounts", sprayAmounts);
            stage.Buffer("Rill.Water.TileMarks", tileMarks);
        }

        static long TexelsOf(RenderTexture texture) => (long)texture.width * texture.height * texture.volumeDepth;

        static int3 SizeOf(RenderTexture texture) => new int3(texture.width, texture.height, texture.volumeDepth);

        // size: width, height and slices.
        void HoldTexture(ref RenderTexture held, string name, int3 size, GraphicsFormat format)
        {
            int3 has = held == null ? 0 : SizeOf(held);
            if (held != null && math.all(has >= size))
                return;
            size = math.max(size, has);
            Outgrow(ref held);
            held = GpuTexture.CreateLayers(name, size.x, size.y, size.z, format, false);
        }

        void HoldBuffer<T>(ref GraphicsBuffer held, string name, long count) where T : struct
        {
            if (held != null && held.count >= count)
                return;
            Outgrow(ref held);
            held = GpuBuffer.Structured<T>(name, count);
        }

        void Outgrow(ref RenderTexture held)
        {
            if (held != null)
                outgrown.Add((new Outgrown(held), Time.frameCount));
            held = null;
        }

        void Outgrow(ref GraphicsBuffer held)
        {
            if (held != null)
                outgrown.Add((held, Time.frameCount));
            held = null;
        }

        sealed class Outgrown : IDisposable
        {
            RenderTexture texture;
            public Outgrown(RenderTexture texture) => this.texture = texture;
            public void Dispose() => EngineObject.Release(ref texture);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset()
        {
            shared.Release();
            shared = new WaterScratch();
        }
    }
}
