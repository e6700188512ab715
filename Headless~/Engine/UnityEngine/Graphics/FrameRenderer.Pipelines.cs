using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    // Draws from which scriptable pipelines make a camera's picture.
    internal static partial class FrameRenderer
    {
        /// <summary>Draws in the camera's layers, seen or not; casters among them.</summary>
        internal static IReadOnlyList<QueuedDraw> InLayers => all;

        /// <summary>Draws in its frustum.</summary>
        internal static IReadOnlyList<QueuedDraw> Seen => seen;

        /// <summary>Culls: what was submitted until now for this camera, and the renderers.</summary>
        internal static void Cull(Camera camera) => Collect(camera);

        internal static void EndCulled()
        {
            items.Clear();
            all.Clear();
            seen.Clear();
        }

        /// <summary>Draws what was culled in the order of the Built-in pipeline: each object's passes whose LightMode is wanted.</summary>
        /// <param name="wanted">Gets the value of LightMode, "" for a pass without.</param>
        /// <param name="ofDraws">Null: all.</param>
        /// <param name="beforeEach">Sets what is of the draw alone.</param>
        internal static void DrawCulled(bool opaque, Func<string, bool> wanted, Func<QueuedDraw, bool> ofDraws = null,
            Action<QueuedDraw> beforeEach = null) =>
            DrawCulled(opaque ? 0 : LastOpaqueQueue + 1, opaque ? LastOpaqueQueue : int.MaxValue, wanted, ofDraws, beforeEach);

        /// <summary>Draws the render queues from one to another, both included.</summary>
        internal static void DrawCulled(int firstQueue, int lastQueue, Func<string, bool> wanted, Func<QueuedDraw, bool> ofDraws = null,
            Action<QueuedDraw> beforeEach = null)
        {
            foreach (Item item in items)
            {
                if (item.Queue < firstQueue || item.Queue > lastQueue || ofDraws != null && !ofDraws(item.Draw))
                    continue;
                Material material = item.Draw.Call.Material;
                beforeEach?.Invoke(item.Draw);
                for (int pass = 0; pass < material.passCount; pass++)
                {
                    material.shader.Source.Passes[pass].Tags.TryGetValue("LightMode", out string mode);
                    if (wanted(mode ?? "") && (mode == null || material.GetShaderPassEnabled(mode)))
                        Drawing.DrawPass(item.Draw.Call, pass);
                }
            }
        }
    }
}
