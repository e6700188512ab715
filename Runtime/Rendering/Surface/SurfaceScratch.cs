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

        RenderTexture rows, sceneDistance;
        GraphicsBuffer amounts, foamAmounts;
        int lastFrame, lookedFrame;
        long largest;       // texels asked for since it was looked at
        // What commands that are recorded and have not run may still refer to: a camera can be drawn while another is prepared.
        readonly List<(IDisposable what, int frame)> outgrown = new List<(IDisposable, int)>();

        public static SurfaceScratch Shared => shared;

        /// <summary>Depth, smoothed along rows.</summary>
        public RenderTexture Rows => rows;

        /// <summary>Distance of the scene along the view, m; of the size of <see cref="SurfaceView.Thickness"/>.</summary>
        public RenderTexture SceneDistance => sceneDistance;

        /// <summary>uint, of each texel of <see cref="SurfaceView.Thickness"/> in use, slice after slice; see SurfaceThickness.compute.</summary>
        public GraphicsBuffer Amounts => amounts;

        /// <summary>uint4, of each texel of <see cref="SurfaceView.Foam"/> in use, slice after slice; see SurfaceFoam.compute.</summary>
        public GraphicsBuffer FoamAmounts => foamAmounts;

        /// <summary>Holds what a view needs; allocates only where it is larger than all before.</summary>
        public void Prepare(SurfaceView view)
        {
            lastFrame = Time.frameCount;
            largest = Math.Max(largest, TexelsOf(view.Smoothed));
            HoldTexture(ref rows, "Rill.Surface.Rows", view.Smoothed, true);
            HoldTexture(ref sceneDistance, "Rill.Surface.SceneDistance", view.Thickness, false);
            HoldBuffer<uint>(ref amounts, "Rill.Surface.Amounts", TexelsOf(view.Thickness) * view.Phases);
            if (view.Foam != null)
                HoldBuffer<uint4>(ref foamAmounts, "Rill.Surface.FoamAmounts", TexelsOf(view.Foam));
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
            if (rows != null && 4 * largest < 3 * TexelsOf(rows))
            {
                Outgrow(ref rows);
                Outgrow(ref sceneDistance);
                Outgrow(ref amounts);
                Outgrow(ref foamAmounts);
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
            GpuBuffer.Release(ref amounts);
            GpuBuffer.Release(ref foamAmounts);
        }

        public void Describe(StageDescription stage)
        {
            SurfaceView.Describe(stage, rows);
            SurfaceView.Describe(stage, sceneDistance);
            if (amounts != null)
                stage.Buffer("Rill.Surface.Amounts", amounts);
            if (foamAmounts != null)
                stage.Buffer("Rill.Surface.FoamAmounts", foamAmounts);
        }

        static long TexelsOf(RenderTexture texture) => (long)texture.width * texture.height * texture.volumeDepth;

        void HoldTexture(ref RenderTexture held, string name, RenderTexture like, bool isWritten)
        {
            if (held != null && held.width >= like.width && held.height >= like.height && held.volumeDepth >= like.volumeDepth)
                return;
            int width = Math.Max(like.width, held == null ? 0 : held.width), height = Math.Max(like.height, held == null ? 0 : held.height),
                slices = Math.Max(like.volumeDepth, held == null ? 0 : held.volumeDepth);
            Outgrow(ref held);
            held = SurfaceView.Make(name, width, height, slices, GraphicsFormat.R32_SFloat, isWritten);
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
