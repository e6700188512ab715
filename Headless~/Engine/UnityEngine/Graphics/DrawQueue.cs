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
    }

    /// <summary>Draws asked for by Graphics.Render* and Draw* since the last frame.</summary>
    internal static class DrawQueue
    {
        public static readonly List<QueuedDraw> Draws = new List<QueuedDraw>();
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

        public static void Clear()
        {
            foreach (QueuedDraw draw in Draws)
                if (draw.Call.Block != null)
                {
                    draw.Call.Block.Clear();
                    spareBlocks.Push(draw.Call.Block);
                }
            Draws.Clear();
        }
    }
}
