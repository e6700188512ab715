using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Keywords of a shader that follow from the step: neighbor lists in two buffers, and regions that sleep. A fluid records them
    /// before its kernels, as another may have left the shared shader on another variant.</summary>
    readonly struct StepKeywords
    {
        readonly ComputeShader shader;
        readonly LocalKeyword twoLists, sleep;
        readonly bool readsLists, skipsAsleep;

        /// <param name="readsLists">Whether its kernels read neighbor lists.</param>
        /// <param name="skipsAsleep">Whether they leave out what sleeps.</param>
        public StepKeywords(ComputeShader shader, bool readsLists, bool skipsAsleep)
        {
            this.shader = shader;
            this.readsLists = readsLists;
            this.skipsAsleep = skipsAsleep;
            twoLists = readsLists ? new LocalKeyword(shader, NeighborLists.TwoListsKeyword) : default;
            sleep = skipsAsleep ? new LocalKeyword(shader, RestingRegions.Keyword) : default;
        }

        /// <param name="allAwake">Whether the kernels visit what sleeps, too.</param>
        public void Record(in StepContext step, bool allAwake = false)
        {
            if (readsLists)
                step.Commands.SetKeyword(shader, twoLists, step.Lists.TwoLists);
            if (skipsAsleep)
                step.Commands.SetKeyword(shader, sleep, step.Resting != null && !allAwake);
        }

        /// <summary>Returns the enabled keywords, for descriptions; null for none.</summary>
        /// <param name="others">Further ones of the kernel, or null.</param>
        public string Variant(in StepContext step, string others = null)
        {
            string lists = readsLists ? step.Lists.Variant : null, asleep = skipsAsleep && step.Resting != null ? RestingRegions.Keyword : null;
            return Join(Join(others, lists), asleep);
        }

        static string Join(string a, string b) => a == null ? b : b == null ? a : a + " " + b;
    }
}
