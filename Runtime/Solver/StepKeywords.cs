using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Keywords of a shader that follow from the step: neighbor lists in two buffers, regions that sleep, and phases of several materials. A
    /// fluid records them before its kernels, as another may have left the shared shader on another variant.</summary>
    readonly struct StepKeywords
    {
        readonly ComputeShader shader;
        readonly LocalKeyword twoLists, sleep, materials;
        readonly bool readsLists, skipsAsleep, weighs;

        /// <param name="readsLists">Whether its kernels read neighbor lists.</param>
        /// <param name="skipsAsleep">Whether they leave out what sleeps.</param>
        /// <param name="weighs">Whether they need the particles' masses.</param>
        public StepKeywords(ComputeShader shader, bool readsLists, bool skipsAsleep, bool weighs = false)
        {
            this.shader = shader;
            this.readsLists = readsLists;
            this.skipsAsleep = skipsAsleep;
            this.weighs = weighs;
            twoLists = readsLists ? new LocalKeyword(shader, NeighborLists.TwoListsKeyword) : default;
            sleep = skipsAsleep ? new LocalKeyword(shader, RestingRegions.Keyword) : default;
            materials = weighs ? new LocalKeyword(shader, MaterialTable.Keyword) : default;
        }

        /// <param name="allAwake">Whether the kernels visit what sleeps, too.</param>
        public void Record(in StepContext step, bool allAwake = false)
        {
            if (readsLists)
                step.Commands.SetKeyword(shader, twoLists, step.Lists.TwoLists);
            if (skipsAsleep)
                step.Commands.SetKeyword(shader, sleep, step.Resting != null && !allAwake);
            if (weighs)
                step.Commands.SetKeyword(shader, materials, step.Materials != null);
        }

        /// <summary>Returns the enabled keywords, for descriptions; null for none.</summary>
        /// <param name="others">Further ones of the kernel, or null.</param>
        public string Variant(in StepContext step, string others = null)
        {
            string lists = readsLists ? step.Lists.Variant : null, asleep = skipsAsleep && step.Resting != null ? RestingRegions.Keyword : null;
            string weighed = weighs && step.Materials != null ? MaterialTable.Keyword : null;
            return Join(Join(Join(others, lists), asleep), weighed);
        }

        static string Join(string a, string b) => a == null ? b : b == null ? a : a + " " + b;
    }
}
