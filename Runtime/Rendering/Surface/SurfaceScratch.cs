using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What is filled and read while one fluid's surface is recorded for one camera, and by no one after: all fluids and cameras share
    /// it, since they come one after the other.</summary>
    sealed class SurfaceScratch
    {
        const int FramesKept = 3, Patience = 60;

        static SurfaceScratch shared = new SurfaceScratch();

        RenderTexture rows, sceneDistance, faces, faceDepth, sceneCopy;
        GraphicsBuffer amounts, foamAmounts, sprayAmounts, tileMarks;
        int lastFrame, lookedFrame;
        long largest;       // texels asked for since it was looked at
        // What commands that are recorded and have not run may still refer to: a camera can be drawn while another is prepared.
        readonly List<(IDisposable what, int frame)> outgrown = new List<(IDisposable, int)>();

        public static SurfaceScratch Shared => shared;

        /// <summary>Depth, smoothed along rows.</summary>
        public RenderTexture Rows => rows;

        /// <summary>Distance of the scene along the view, m; of the size of <see cref="SurfaceView.Thickness"/>.</summary>
        public RenderTexture SceneDistance => sceneDistance;

        /// <summary>The nearest faces of a mesh on the picture, see WaterRays.compute, and their depth.</summary>
        public RenderTexture Faces => faces;
        public RenderTexture FaceDepth => faceDepth;

        /// <summary>The scene's depth as the device has it, of the whole picture.</summary>
        public RenderTexture SceneCopy => sceneCopy;

        /// <summary>uint, of each texel of <see cref="SurfaceView.Thickness"/> in use, slice after slice; see SurfaceThickness.compute.</summary>
        public GraphicsBuffer Amounts => amounts;

        /// <summary>uint4, of each texel of <see cref="SurfaceView.Foam"/> in use, slice after slice; see SurfaceFoam.compute.</summary>
        public GraphicsBuffer FoamAmounts => foamAmounts;

        /// <summary>uint, of each texel of <see cref="WaterView.Spray"/> in use, slice after slice; see WaterSpray.compute.</summary>
        public GraphicsBuffer SprayAmounts => sprayAmounts;

        /// <summary>uint, see TileMarks.hlsl.</summary>
        public GraphicsBuffer TileMarks => tileMarks;

        /// <summary>Holds what a view needs; allocates only where it is larger than all before.</summary>
        public void Prepare(SurfaceView view)
        {
            lastFrame = Time.frameCount;
            largest = Math.Max(largest, TexelsOf(view.Smoothed));
            HoldTexture(ref rows, "Rill.Surface.Rows", SizeOf(view.Smoothed), GraphicsFormat.R32_SFloat, true);
            HoldTexture(ref sceneDistance, "Rill.Surface.SceneDistance", SizeOf(view.Thickness), GraphicsFormat.R32_SFloat, false);
            HoldBuffer<uint>(ref amounts, "Rill.Surface.Amounts", TexelsOf(view.Thickness) * view.Phases);
            if (view.Foam != null)
                HoldBuffer<uint4>(ref foamAmounts, "Rill.Surface.FoamAmounts", TexelsOf(view.Foam));
        }

        /// <summary>Holds what the rays of a view need.</summary>
        /// <param name="width">Of the whole picture, in texels of the view's rays.</param>
        /// <param name="height">The same.</param>
        /// <param name="sprayWords">That are added up for a texel of its spray.</param>
        public void Prepare(WaterView view, int width, int height, int sprayWords)
        {
            lastFrame = Time.frameCount;
            int3 size = SizeOf(view.Faces);
            largest = Math.Max(largest, TexelsOf(view.Faces));
            HoldTexture(ref faces, "Rill.Water.Faces", size, GraphicsFormat.R16G16B16A16_SFloat, false);
            HoldTexture(ref faceDepth, "Rill.Water.FaceDepth", size, GraphicsFormat.None, false);
            HoldTexture(ref sceneCopy, "Rill.Water.Scene", new int3(width, height, size.z), GraphicsFormat.R32_SFloat, false);
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

        // Where the largest use of a while leaves much of it empty it is made again by the next.
        void Shrink()
        {
            if (rows != null && 4 * largest < 3 * TexelsOf(rows) || faces != null && 4 * largest < 3 * TexelsOf(faces))
            {
                Outgrow(ref rows);
                Outgrow(ref sceneDistance);
                Outgrow(ref faces);
                Outgrow(ref faceDepth);
                Outgrow(ref sceneCopy);
                Outgrow(ref amounts);
                Outgrow(ref foamAmounts);
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
            EngineObject.Release(ref rows);
            EngineObject.Release(ref sceneDistance);
            EngineObject.Release(ref faces);
            EngineObject.Release(ref faceDepth);
            EngineObject.Release(ref sceneCopy);
            GpuBuffer.Release(ref amounts);
            GpuBuffer.Release(ref foamAmounts);
            GpuBuffer.Release(ref sprayAmounts);
            GpuBuffer.Release(ref tileMarks);
        }

        public void Describe(StageDescription stage)
        {
            SurfaceView.Describe(stage, rows);
            SurfaceView.Describe(stage, sceneDistance);
            SurfaceView.Describe(stage, faces);
            SurfaceView.Describe(stage, faceDepth);
            SurfaceView.Describe(stage, sceneCopy);
            if (amounts != null)
                stage.Buffer("Rill.Surface.Amounts", amounts);
            if (foamAmounts != null)
                stage.Buffer("Rill.Surface.FoamAmounts", foamAmounts);
            if (sprayAmounts != null)
                stage.Buffer("Rill.Water.SprayAmounts", sprayAmounts);
            if (tileMarks != null)
                stage.Buffer("Rill.Water.TileMarks", tileMarks);
        }

        static long TexelsOf(RenderTexture texture) => (long)texture.width * texture.height * texture.volumeDepth;

        static int3 SizeOf(RenderTexture texture) => new int3(texture.width, texture.height, texture.volumeDepth);

        // size: width, height and slices.
        void HoldTexture(ref RenderTexture held, string name, int3 size, GraphicsFormat format, bool isWritten)
        {
            int3 has = held == null ? 0 : SizeOf(held);
            if (held != null && math.all(has >= size))
                return;
            size = math.max(size, has);
            Outgrow(ref held);
            held = SurfaceView.Make(name, size.x, size.y, size.z, format, isWritten);
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
            shared = new SurfaceScratch();
        }
    }
}
