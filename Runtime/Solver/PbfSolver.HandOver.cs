using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What a box that moves leaves to another fluid.
    partial class PbfSolver
    {
        // Number of the transfer to it, behind those of what is kept. Of a transfer whose rest is kept no number is read.
        const int HandingOver = Listing + 1;

        /// <summary>Particles of the newest hand-over that the other fluid had no room for and that were not kept, as far as has come
        /// back.</summary>
        public int RefusedToHandOver => Transferred(HandingOver, TransferWord.Held);

        /// <summary>Moves to another fluid, at once, what lies in its box and will lie outside of this one's. Before
        /// <see cref="Shift(float3)"/>.</summary>
        /// <param name="taker">Of the same particle spacing.</param>
        /// <param name="from">Where this box is in world space, m, its lowest corner.</param>
        /// <param name="to">Where it will be, turned as before.</param>
        /// <param name="takersBox">Where the other is.</param>
        /// <param name="keepsRest">Whether what finds no room is kept.</param>
        public void HandOver(PbfSolver taker, in RigidPose from, in RigidPose to, in RigidPose takersBox, bool keepsRest)
        {
            TransferRegion region = RegionOf(from, takersBox, taker.Layout, keepsRest ? Listing : HandingOver);
            region.staysCorner = math.rotate(math.inverse(from.rotation), to.position - from.position) / Layout.Spacing;
            region.staysSize = Layout.DomainSize;
            region.stepsAhead = taker.stepIndex - stepIndex;
            taker.Expect(this, region);
            Transfer.Reserve(Layout.Capacity);
            using (var cmd = new CommandBuffer { name = "Rill.HandOver" })
            {
                Transfer.Record(cmd, particles.AsSet(tags), taker.particles.AsSet(taker.tags), region, TransferRule.Move);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            NoteGone();
            taker.NoteAdded(Layout.Capacity, taker.minAdded, taker.maxAdded);
            Transfer.Request();
        }
    }
}
