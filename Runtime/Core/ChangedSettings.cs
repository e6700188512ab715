using System;

namespace Rill
{
    /// <summary>A component whose settings are checked, and have consequences.</summary>
    interface IAppliesSettings
    {
        /// <summary>Puts each setting into its range. Unity may want it on a thread of its own: of its API only arithmetic is called.</summary>
        void CheckSettings();

        /// <summary>On the main thread, after a check: logs what was clamped and does what follows.</summary>
        void ApplySettings();
    }

    /// <summary>
    /// Applies new settings. Unity may call OnValidate on a thread where most of its API is forbidden, so the work waits for
    /// the Editor's next update. A setter has it done at once. A player hears no OnValidate.
    /// </summary>
    static class ChangedSettings
    {
        [KeptBetweenPlays] static Action<IAppliesSettings> editorQueue;

        /// <summary>Takes components on any thread, and applies their settings on the main one; null in a player.</summary>
        internal static Action<IAppliesSettings> EditorQueue { get => editorQueue; set => editorQueue = value; }

        /// <summary>Applies settings from OnValidate.</summary>
        public static void ApplyLater(IAppliesSettings of)
        {
            of.CheckSettings();
            editorQueue?.Invoke(of);
        }

        /// <summary>Applies settings from a setter.</summary>
        public static void Apply(IAppliesSettings of)
        {
            of.CheckSettings();
            of.ApplySettings();
        }
    }
}
