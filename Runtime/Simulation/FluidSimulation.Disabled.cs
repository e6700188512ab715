using UnityEngine;

namespace Rill
{
    // What a disabled fluid keeps.
    public sealed partial class FluidSimulation
    {
        [Tooltip("On: a disabled fluid keeps its water, and the memory for it, and goes on from there when it is enabled again. Off: " +
            "it gives its memory back and begins again.")]
        [SerializeField] bool keepStateOnDisable = true;

        // From before scripts are loaded again until they are: no reference to what is kept would be left.
        static bool keepsNothing;

        PbfSolver kept;     // of the disabled fluid

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetKeepsNothing() => keepsNothing = false;

        /// <summary>While it is set, a fluid that is disabled gives all back, whatever <see cref="KeepStateOnDisable"/> says.</summary>
        internal static bool KeepsNothing { get => keepsNothing; set => keepsNothing = value; }

        /// <summary>
        /// Whether the fluid keeps its water while this component or its object is disabled, and goes on from there when it is enabled again; on
        /// by default, since what is pooled or culled by being disabled should not lose its water. Off: it gives its memory back and begins
        /// again. Turning it off while the fluid is disabled gives the memory back at once.
        /// </summary>
        /// <remarks>A fluid that is destroyed gives all back. A budget measures again. One whose box, spacing, capacity or neighbor lists
        /// changed meanwhile begins again.</remarks>
        public bool KeepStateOnDisable
        {
            get => keepStateOnDisable;
            set
            {
                keepStateOnDisable = value;
                if (!value)
                    ReleaseKept();
            }
        }

        /// <summary>Whether the fluid is disabled and keeps its water.</summary>
        public bool HasKeptState => kept != null;

        /// <summary>Gives back what a disabled fluid keeps; it begins again when it is enabled. Before scripts are loaded again, and when
        /// it is destroyed.</summary>
        internal void ReleaseKept()
        {
            if (kept == null)
                return;
            pbf = kept;
            kept = null;
            Release();
        }

        // As the fluid is disabled; false where there is nothing to keep.
        bool TryKeep()
        {
            if (!keepStateOnDisable || keepsNothing || pbf == null || failure != null || IsInEditMode)
                return false;
            kept = pbf;
            pbf = null;
            ReleaseBudget();        // its recorder is one of a few
            shaders.Release();
            return true;
        }

        // As it is enabled: what moved meanwhile has not moved through the fluid, as after a pause.
        bool TryResume()
        {
            if (kept != null && !Matches(kept.Layout))
                ReleaseKept();
            if (kept == null)
                return false;
            pbf = kept;
            kept = null;
            layoutChanged = false;
            StandStill();
            ClearMotions();
            return true;
        }
    }
}
