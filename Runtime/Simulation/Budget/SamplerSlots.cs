using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Names for samplers: Unity keeps each for as long as it runs, so they are used again.</summary>
    static class SamplerSlots
    {
        const int LastSlot = 63;      // beyond so many simulations with a budget, the rest are summed in one

        static ulong taken;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset() => taken = 0;

        public static int Take()
        {
            int slot = 0;
            while (slot < LastSlot && (taken & 1ul << slot) != 0)
                slot++;
            taken |= 1ul << slot;
            return slot;
        }

        public static void Give(int slot) => taken &= ~(1ul << slot);

        public static string NameOf(int slot) => slot == 0 ? "Rill.Steps" : Invariant($"Rill.Steps {slot + 1}");
    }
}
