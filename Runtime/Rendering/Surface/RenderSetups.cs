using System.Collections.Generic;

namespace Rill
{
    /// <summary>The adapters that are compiled in this project.</summary>
    static class RenderSetups
    {
        [KeptBetweenPlays] static readonly List<IRenderSetup> all = new List<IRenderSetup>();

        public static IReadOnlyList<IRenderSetup> All => all;

        /// <summary>When a surface has ended: after the last, cameras are as they were.</summary>
        public static void End()
        {
            if (FluidSurface.Active.Count > 0)
                return;
            for (int i = 0; i < all.Count; i++)
                all[i].End();
        }

        /// <summary>Instead of an earlier one of the same class.</summary>
        public static void Add(IRenderSetup setup)
        {
            for (int i = all.Count - 1; i >= 0; i--)
                if (all[i].GetType() == setup.GetType())
                    all.RemoveAt(i);
            all.Add(setup);
        }
    }
}
