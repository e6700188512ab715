namespace Rill
{
    /// <summary>What holds for the groups of threads of every dispatch.</summary>
    static class ThreadGroups
    {
        /// <summary>of a dispatch, along each axis; more fold into y</summary>
        [SharedWithHlsl("ThreadGroups")] public const int MaxGroups = 65535;
    }
}
