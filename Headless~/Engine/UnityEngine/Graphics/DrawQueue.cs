using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>A draw of this frame with what decides whether and when it comes.</summary>
    internal struct QueuedDraw
    {
        public DrawCall Call;
        public Bounds Bounds;
        public bool HasBounds;
        public Camera Camera;       // null: every camera
        public int Layer, Priority, Order;
        public Rendering.ShadowCastingMode Shadows;
        public bool ReceivesShadows;
        public MotionVectorGenerationMode Motion;
        public Rendering.ReflectionProbeUsage Reflections;
    }

    /// <summary>
    /// Draws asked for by Graphics.Render* and Draw*. As the editor has it, those that a camera has culled wait until the next frame begins: one
    /// that draws again meanwhile, as scene views do while the game is paused, draws them again (7000.0, Scripting API,
    /// PlayerLoop.EarlyUpdate.ClearIntermediateRenderers). As a player has it, which forgets them at the frame's end, those from between
    /// two frames are drawn in the next.
    /// </summary>
    internal static class DrawQueue
    {
        public static readonly List<QueuedDraw> Draws = new List<QueuedDraw>();
        static int culled;      // the first of them
        static readonly Stack<PropertyTable> spareBlocks = new Stack<PropertyTable>();

        public static void Add(QueuedDraw draw, MaterialPropertyBlock properties)
        {
            using NativeWork.Scope native = NativeWork.Enter();
            if (draw.Call.Material == null)
                throw new ArgumentNullException("material", $"Graphics.{draw.Call.Call}: the material is null.");
            if (properties != null && !properties.isEmpty)
            {
                // Unity takes the block's values at the call.
                draw.Call.Block = spareBlocks.Count > 0 ? spareBlocks.Pop() : new PropertyTable();
                draw.Call.Block.CopyFrom(properties.Values);
            }
            draw.Order = Draws.Count;
            Draws.Add(draw);
        }

        /// <summary>A camera has culled all that there are.</summary>
        public static void MarkCulled() => culled = Draws.Count;

        public static void BeginFrame() => Remove(culled);

        public static void Clear() => Remove(Draws.Count);

        static void Remove(int count)
        {
            for (int i = 0; i < count; i++)
                if (Draws[i].Call.Block is PropertyTable block)
                {
                    block.Clear();
                    spareBlocks.Push(block);
                }
            Draws.RemoveRange(0, count);
            for (int i = 0; i < Draws.Count; i++)
            {
                QueuedDraw draw = Draws[i];
                draw.Order = i;
                Draws[i] = draw;
            }
            culled = 0;
        }
    }
}
